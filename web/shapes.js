import { across, add, cross, dot, sub, times, unit } from "./vectors.js";

// Elements as triangles, for the picture alone: the exact engine knows no triangle that the scene has not.
const around = 64,
  upwards = 32,
  plane_reach = 40;

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

function square(centro, axis, half) {
  const [u, w] = across(axis),
    n = unit(axis);
  return grid(1, 1, (s, t) => [add(centro, add(times(u, half * (2 * s - 1)), times(w, half * (2 * t - 1)))), n]);
}

function faces(points, triples) {
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

const entry = x =>
  typeof x === "string"
    ? x
        .split("/")
        .map(Number)
        .reduce((a, b) => a / b)
    : x;

// image is a mesh that an affine map moves; its normals are those of the image.
function image(mesh, mapa) {
  const m = mapa.map(row => row.map(entry)),
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

// mesh_of gives the triangles of an element, or null where the picture has none for its type.
export function mesh_of(element, scene, depth = 0) {
  if (makers[element.tipo]) return makers[element.tipo](element);
  if (element.tipo !== "instancia" || depth > 8) return null;
  const original =
    typeof element.de === "string"
      ? (scene.elementos.find(e => e.id === element.de) ?? scene.prototypes?.[element.de])
      : element.de;
  const mesh = original?.tipo ? mesh_of(original, scene, depth + 1) : null;
  return mesh && image(mesh, element.mapa);
}

// drawn_of gives what the picture draws of a scene: name, colour and mesh; and the names that it has no mesh for.
export function drawn_of(scene) {
  const colour = e => scene.materials?.[e.material]?.color ?? [0.8, 0.8, 0.8];
  const solid = e => {
    // a mirror or a glass has hardly a colour of its own
    const m = scene.materials?.[e.material];
    return m && (m.k_t ?? 0) > 0.5 ? [0.72, 0.82, 0.85] : m && (m.k_ps ?? 0) > 0.5 ? [0.62, 0.66, 0.7] : colour(e);
  };
  const meshes = [],
    left_out = [];
  for (const element of scene.elementos ?? []) {
    const mesh = mesh_of(element, scene);
    if (mesh) meshes.push({ id: element.id, tipo: element.tipo, colour: solid(element), ...mesh });
    else left_out.push(element.id);
  }
  for (const malla of scene.mallas ?? [])
    meshes.push({ id: malla.id, tipo: "malla", colour: solid(malla), ...faces(malla.puntos, malla.caras) });
  return { meshes, left_out };
}

// ball_of is a ball about all bounded elements: its middle and its radius.
export function ball_of(meshes) {
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  for (const { tipo, positions } of meshes) {
    if (tipo === "plano") continue;
    for (let i = 0; i < positions.length; ++i) {
      const k = i % 3;
      if (positions[i] < low[k]) low[k] = positions[i];
      if (positions[i] > high[k]) high[k] = positions[i];
    }
  }
  if (!(low[0] <= high[0])) return { middle: [0, 0, 0], radius: 3 };
  return { middle: times(add(low, high), 0.5), radius: Math.max(0.5, Math.hypot(...sub(high, low)) / 2) };
}
