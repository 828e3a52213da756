import { ball_of } from "./drawn.js";
import { add, cross, dot, long, sub, times, unit } from "./vectors.js";

// The window that a scene's camera looks through, its pixels, and from where the picture shows all of it.

// frame_of is the window that the camera looks through: its corners and its middle, a part of the way to what it looks at.
export function frame_of(scene) {
  const camera = scene.camera;
  if (!camera) return null;
  const forward = unit(sub(camera.look_at, camera.eye)),
    side = unit(cross(forward, camera.up)),
    top = cross(side, forward);
  const [width, height] = scene.resolution ?? [640, 360];
  const far = 0.3 * long(sub(camera.look_at, camera.eye)),
    half = far * Math.tan((camera.fov_y * Math.PI) / 360);
  const middle = add(camera.eye, times(forward, far)),
    wide = (half * width) / height,
    hand = camera.mirrored ? -1 : 1;
  const at = (x, y) => add(add(middle, times(side, x * wide * hand)), times(top, y * half));
  return { eye: camera.eye, forward, side: times(side, hand), top, far, half, wide, middle, width, height, at };
}

// pixel_of is the pixel that a ray from the eye goes through: its column and row from the top, or null.
export function pixel_of(frame, p, v) {
  if (!frame || p.some((x, i) => x !== frame.eye[i])) return null;
  const along = dot(v, frame.forward);
  if (!(along > 0)) return null;
  const q = times(v, frame.far / along),
    x = dot(q, frame.side) / frame.wide,
    y = dot(q, frame.top) / frame.half;
  if (Math.abs(x) >= 1 || Math.abs(y) >= 1) return null;
  return { column: Math.floor(((x + 1) / 2) * frame.width), row: Math.floor(((1 - y) / 2) * frame.height), x, y };
}

// through_pixel is the direction from the eye to the middle of a pixel.
export function through_pixel(frame, column, row) {
  const x = (2 * (column + 0.5)) / frame.width - 1,
    y = 1 - (2 * (row + 0.5)) / frame.height;
  return times(sub(frame.at(x, y), frame.eye), 1 / frame.far);
}

// usual_orbit looks at all from beside the camera: angles, and a distance.
export function usual_orbit(frame, ball) {
  const from = frame ? sub(frame.eye, ball.middle) : [0, 0.4, 1];
  return [Math.atan2(from[0], from[2]) + 0.85, 0.28, 1.95 * ball.radius];
}

// shown_ball is about the eye, near lights and all elements but those far greater than the rest, such as a ball that is a floor.
export function shown_ball(meshes, frame, lights) {
  const sizes = meshes
    .filter(m => m.tipo !== "plano")
    .map(m => ({ m, size: ball_of([m]).radius }))
    .sort((a, b) => a.size - b.size);
  const usual = sizes.length ? sizes[sizes.length >> 1].size : 1;
  const near = sizes.filter(({ size }) => size <= 10 * usual).map(({ m }) => m);
  const eye = frame ? [{ tipo: "eye", positions: [...frame.eye, ...frame.middle] }] : [];
  const ball = ball_of([...near, ...eye]),
    close = lights.filter(l => long(sub(l.position, ball.middle)) < 1.8 * ball.radius);
  return ball_of([...near, ...eye, ...close.map(l => ({ tipo: "light", positions: l.position }))]);
}
