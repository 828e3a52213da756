// Vectors and matrices of binary64, for the picture alone: no answer is computed by them.
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const long = a => Math.hypot(a[0], a[1], a[2]);
export const unit = a => {
  const l = long(a);
  return l > 0 ? times(a, 1 / l) : [0, 0, 0];
};

// across gives two unit vectors that stand upright on a and on each other.
export function across(a) {
  const least = Math.abs(a[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const u = unit(cross(a, least));
  return [u, cross(unit(a), u)];
}

// Matrices are columns, as WebGL takes them.
export function product(a, b) {
  const m = new Array(16).fill(0);
  for (let c = 0; c < 4; ++c)
    for (let r = 0; r < 4; ++r) for (let k = 0; k < 4; ++k) m[4 * c + r] += a[4 * k + r] * b[4 * c + k];
  return m;
}

export function look(eye, at, up) {
  const back = unit(sub(eye, at)),
    right = unit(cross(up, back)),
    top = cross(back, right);
  return [
    right[0],
    top[0],
    back[0],
    0,
    right[1],
    top[1],
    back[1],
    0,
    right[2],
    top[2],
    back[2],
    0,
    -dot(right, eye),
    -dot(top, eye),
    -dot(back, eye),
    1,
  ];
}

export function perspective(fov, aspect, near, far) {
  const f = 1 / Math.tan(fov / 2);
  return [
    f / aspect,
    0,
    0,
    0,
    0,
    f,
    0,
    0,
    0,
    0,
    (far + near) / (near - far),
    -1,
    0,
    0,
    (2 * far * near) / (near - far),
    0,
  ];
}

export const moved = (m, p) => [0, 1, 2, 3].map(r => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]);
