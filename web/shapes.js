import { across, add, cross, dot, sub, times, unit } from "./vectors.js";

// Elements as triangles, for the picture alone: the exact engine knows no triangle that the scene has not.
const around = 64,
  upwards = 32;

// plane_reach is how far a plane is drawn about its point.
export const plane_reach = 40;

function grid(columns, rows, point) {
  const positions = [],
    normals = [],
    indices = [];
  for (let j = 0; j <= rows; ++j)
    for (let i = 0; i <= columns; ++i) {
      const [p, n] = point(i / columns, j / rows);
      positions.push(...p);
      normals.push(...n);
    }
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) {
      const a = j * (columns + 1) + i,
        b = a + columns + 1;
      indices.push(a, a + 1, b, b, a + 1, b + 1);
    }
  return { positions, normals, indices };
}

// A great ball, such as a floor, has so many triangles that they keep within a fifty-thousandth of its radius.
function sphere({ centro, radio }) {
  const finer = radio > 20 ? 8 : 1;
  return grid(around * finer, upwards * finer, (s, t) => {
    const a = 2 * Math.PI * s,
      b = Math.PI * (t - 0.5);
    const n = [Math.cos(b) * Math.cos(a), Math.sin(b), Math.cos(b) * Math.sin(a)];
    return [add(centro, times(n, radio)), n];
  });
}

// turned is a surface whose radius is base at the centre, and top at the height.
function turned(centro, axis, height, base, top) {
  const [u, w] = across(axis);
  return grid(around, 1, (s, t) => {
    const a = 2 * Math.PI * s,
      out = add(times(u, Math.cos(a)), times(w, Math.sin(a)));
    const at = add(add(centro, times(axis, height * t)), times(out, base + (top - base) * t));
    return [at, unit(add(out, times(axis, (base - top) / height)))];
  });
}

function round_flat(centro, axis, radius) {
  const [u, w] = across(axis),
    n = unit(axis);
  return grid(around, 1, (s, t) => {
    const a = 2 * Math.PI * s;
    return [add(centro, times(add(times(u, Math.cos(a)), times(w, Math.sin(a))), radius * t)), n];
  });
}

export function square(centro, axis, half, pieces = 1) {
  const [u, w] = across(axis),
    n = unit(axis);
  return grid(pieces, pieces, (s, t) => [add(centro, add(times(u, half * (2 * s - 1)), times(w, half * (2 * t - 1)))), n]);
}

export function faces(points, triples) {
  const positions = [],
    normals = [],
    indices = [];
  for (const triple of triples) {
    const [a, b, c] = triple.map(i => points[i]),
      n = unit(cross(sub(b, a), sub(c, a)));
    for (const p of [a, b, c]) {
      indices.push(positions.length / 3);
      positions.push(...p);
      normals.push(...n);
    }
  }
  return { positions, normals, indices };
}

function box([low, high]) {
  const points = [0, 1, 2, 3, 4, 5, 6, 7].map(i => [0, 1, 2].map(k => ((i >> k) & 1 ? high[k] : low[k])));
  return faces(points, [
    [0, 2, 1],
    [1, 2, 3],
    [4, 5, 6],
    [5, 7, 6],
    [0, 1, 4],
    [1, 5, 4],
    [2, 6, 3],
    [3, 6, 7],
    [0, 4, 2],
    [2, 4, 6],
    [1, 3, 5],
    [3, 7, 5],
  ]);
}

const entry_of = x =>
  typeof x === "string"
    ? x
        .split("/")
        .map(Number)
        .reduce((a, b) => a / b)
    : x;

// matrix_of gives the three rows of a map, whose numbers may be fractions in words.
export const matrix_of = mapa => mapa.map(row => row.map(entry_of));

// image is a mesh that an affine map moves; its normals are those of the image.
export function image(mesh, mapa) {
  const m = matrix_of(mapa),
    columns = [0, 1, 2].map(c => m.map(row => row[c]));
  const turns = dot(columns[0], cross(columns[1], columns[2])) < 0 ? -1 : 1;
  const minors = [cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])];
  const each = (list, f) => {
    const made = [];
    for (let i = 0; i < list.length; i += 3) made.push(...f([list[i], list[i + 1], list[i + 2]]));
    return made;
  };
  return {
    positions: each(mesh.positions, p => m.map(row => row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3])),
    normals: each(mesh.normals, n =>
      unit(times(add(add(times(minors[0], n[0]), times(minors[1], n[1])), times(minors[2], n[2])), turns)),
    ),
    indices: mesh.indices,
  };
}

const makers = {
  esfera: sphere,
  cilindro: e => turned(e.centro, e.vector, e.altura, e.radio, e.radio),
  cono: e => turned(e.centro, e.vector, e.altura, e.proporcion * e.altura, 0),
  tronco: e => turned(e.centro, e.vector, e.altura, e.radio + e.proporcion * e.altura, e.radio),
  plano: e => square(e.centro, e.vector, plane_reach),
  disco: e => round_flat(e.centro, e.vector, e.radio),
  triangulo: e => faces(e.vertices, [[0, 1, 2]]),
  caja: e => box(e.esquinas),
};

// shape_mesh gives the triangles of a shape, or null where the type is none.
export const shape_mesh = element => makers[element.tipo]?.(element) ?? null;

// joined is one mesh of several.
export function joined(meshes) {
  const positions = [],
    normals = [],
    indices = [];
  for (const mesh of meshes) {
    const first = positions.length / 3;
    for (const x of mesh.positions) positions.push(x);
    for (const x of mesh.normals) normals.push(x);
    for (const i of mesh.indices) indices.push(first + i);
  }
  return { positions, normals, indices };
}

// closed_mesh is a shape as a solid has it: with what closes its ends.
export function closed_mesh(element) {
  const end = (at, radius) => {
    const axis = element.vector;
    return round_flat(add(element.centro, times(axis, at)), times(axis, at > 0 ? 1 : -1), radius);
  };
  const { tipo, radio = 0, altura: h, proporcion = 0 } = element;
  const ends = {
    cilindro: () => [end(0, radio), end(h, radio)],
    cono: () => [end(0, proporcion * h)],
    tronco: () => [end(0, radio + proporcion * h), end(h, radio)],
  }[tipo];
  return ends ? joined([shape_mesh(element), ...ends()]) : shape_mesh(element);
}
