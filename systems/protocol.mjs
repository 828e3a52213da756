// The question protocol, for systems that are asked from JavaScript: an adapter says how its system is asked, no more.
import { writeSync } from "node:fs";
import { createInterface } from "node:readline";

// What a system prints goes to standard error; standard output is for the answers.
console.log = console.info = console.debug = console.error;

// Where the packages are: the first argument names the folder that `durero conform setup` made.
export const packages = process.argv[2] + "/node_modules/";

const sizes = { esfera: ["radio"], cilindro: ["radio", "altura"], cono: ["proporcion", "altura"],
  tronco: ["radio", "proporcion", "altura"], plano: [], disco: ["radio"] };

const bodies = ["caja", "capsula", "elipsoide", "copia_caja", "copia_esfera"];
export const isBody = (e) => bodies.includes(e.tipo);

// An element of the scene, by the names of its type's attributes.
function element(line) {
  const [tipo, name, ...words] = line.trim().split(/\s+/);
  const n = words.map(Number);
  if (tipo === "triangulo") return { tipo, name, vertices: [n.slice(0, 3), n.slice(3, 6), n.slice(6, 9)] };
  const shape = { tipo, name, centro: n.slice(0, 3) };
  if (bodies.includes(tipo)) return { ...shape, sides: [n.slice(3, 6), n.slice(6, 9), n.slice(9, 12)] };
  if (tipo !== "esfera") shape.vector = n.slice(3, 6);
  sizes[tipo].forEach((size, i) => (shape[size] = n[(tipo === "esfera" ? 3 : 6) + i]));
  return shape;
}

// The point of the axis at that advance from the centre.
export const along = (e, advance) => e.centro.map((c, i) => c + advance * e.vector[i]);

// The radii at the centre and at the other end of the axis.
export function radii(e) {
  const top = e.tipo === "cono" ? 0 : e.radio;
  return [top + (e.tipo === "cilindro" ? 0 : e.proporcion * e.altura), top];
}

// The lengths of a body's sides.
export const half = (e) => e.sides.map((side) => Math.hypot(...side));

// x, y, z and w of the rotation that takes the axes of coordinates to the directions of a body's sides, which are at right
// angles and right-handed.
export function turn(e) {
  const [x, y, z] = e.sides.map((side) => side.map((c) => c / Math.hypot(...side)));
  const four = [1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2], 1 + x[0] + y[1] + z[2]];
  const rows = [[four[0], x[1] + y[0], z[0] + x[2], y[2] - z[1]], [x[1] + y[0], four[1], y[2] + z[1], z[0] - x[2]],
    [z[0] + x[2], y[2] + z[1], four[2], x[1] - y[0]], [y[2] - z[1], z[0] - x[2], x[1] - y[0], four[3]]];
  const q = rows[four.indexOf(Math.max(...four))];
  return q.map((part) => part / Math.hypot(...q));
}

// x, y, z and w of the least rotation that takes the y axis to the element's.
export function quaternionOfY([x, y, z]) {
  const w = y > 0 ? 1 + y : (x * x + z * z) / (1 - y);
  if (w === 0) return [1, 0, 0, 0];
  const length = Math.hypot(x, z, w);
  return [z / length, 0, -x / length, w / length];
}

// x, y, z and w of the least rotation that takes the z axis to the element's.
export function quaternionOfZ([x, y, z]) {
  const w = z > 0 ? 1 + z : (x * x + y * y) / (1 - z);
  if (w === 0) return [1, 0, 0, 0];
  const length = Math.hypot(x, y, w);
  return [-y / length, x / length, 0, w / length];
}

// The unit vector of v's direction, whatever the magnitude of v.
export function unit(v) {
  const largest = Math.max(...v.map(Math.abs));
  const scaled = v.map((x) => x / largest);
  const length = Math.hypot(...scaled);
  return scaled.map((x) => x / length);
}

export const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

// How far from p the last of its points can be that a ray along the unit vector u meets.
function farthest(e, p, u) {
  if (e.tipo === "triangulo") return Math.max(...e.vertices.map((vertex) => distance(p, vertex)));
  const reach = distance(p, e.centro);
  if (isBody(e)) return half(e).reduce((sum, x) => sum + x, reach);
  if (e.tipo === "plano") {
    const slope = Math.abs(u.reduce((sum, x, i) => sum + x * e.vector[i], 0));
    return slope ? reach / slope : 0;
  }
  return e.tipo === "esfera" || e.tipo === "disco" ? reach + e.radio : reach + Math.max(...radii(e)) + e.altura;
}

// A power of two f for systems that ask of segments: none of the elements is beyond p + f v.
export function segment(elements, p, v) {
  return past(Math.max(...elements.map((e) => farthest(e, p, unit(v)))), v);
}

// A power of two f: f v is longer than that distance.
export const past = (far, v) => 2 ** Math.ceil(Math.log2((2 * far) / Math.hypot(...v)));

// Their points, each once, and of each triangle the numbers of its three points: one mesh of them all.
function mesh(elements) {
  const numbers = new Map(), points = [];
  const numberOf = (vertex) => {
    const key = vertex.join();
    if (!numbers.has(key)) numbers.set(key, points.push(vertex) - 1);
    return numbers.get(key);
  };
  return [points, elements.map((e) => e.vertices.map(numberOf))];
}

// load(elements) of a system that has meshes: build(points, faces) answers with the number of a face for its name.
export const ofFaces = (build) => (elements) => {
  const ask = build(...mesh(elements));
  return (...question) => {
    const claim = ask(...question);
    return claim && [elements[claim[0]]?.name ?? "-", ...claim.slice(1)];
  };
};

// The hit of least t; nothing of none. For systems that answer of one element at a time.
export const nearest = (hits) => hits.reduce((a, b) => (a && a[1] <= b[1] ? a : b), undefined);

// build(points, faces) of a system that is asked of one triangle at a time: corners and ray make what it takes, and
// meet(ray, corners) answers with undefined, [t], or [undefined, point]. The nearest counts.
export const triangleByTriangle = (corners, ray, meet) => (points, faces) => {
  const triangles = faces.map((face) => corners(face.map((i) => points[i])));
  return (p, v) => {
    const asked = ray(p, v);
    const hits = triangles.map((triangle, i) => [i, meet(asked, triangle)]).filter(([, hit]) => hit);
    const away = ([, [t, point]]) => t ?? distance(p, point);
    const first = hits.reduce((a, b) => (a && away(a) <= away(b) ? a : b), undefined);
    return first && [first[0], ...first[1]];
  };
};

const refusal = (why) => "refused " + String(why).replace(/\s+/g, " ").slice(0, 200);
const number = (x) => (Number.isFinite(x) ? String(x) : Number.isNaN(x) ? "nan" : x > 0 ? "inf" : "-inf");
const written = (x) => (x === undefined ? "-" : number(x));
const besidesOf = ({ normal, front, uv } = {}) => [
  ...(normal ? ["normal", ...normal.map(number)] : []),
  ...(front === undefined ? [] : [front ? "front" : "back"]),
  ...(uv ? ["uv", ...uv.map(number)] : []),
];
const shown = ([name, t, punto, besides]) =>
  ["hit", name, written(t), ...(punto ?? []).map(number), ...besidesOf(besides)].join(" ");

// The question that a line asks: an origin and a direction, or a point, and the numbers behind them.
const parts = (n) => (n.length < 6 ? [n] : [n.slice(0, 3), n.slice(3, 6), ...n.slice(6)]);

// Answers until the questions end. load(elements) is a function of an origin and a direction to undefined for a miss,
// or to [name, t], or [name, t, point], behind which may stand { normal, front, uv } or some of it. Of a system that
// answers ranges, others.ranges(elements) is the same of an origin, a direction and two ends; of one that answers
// nearest points, others.points(elements) is a function of a point to [name, distance, point]; of one that casts balls,
// others.casts(elements) is the same as load(elements) of an origin, a direction and a radius.
export async function serve(system, version, load, others = {}) {
  const loads = { ...others, rays: load };
  const write = (lines) => writeSync(1, lines.join("\n") + "\n");
  write([`system ${system} ${version}`]);
  let elements = [], ask, left = 0, claims = [];
  for await (const line of createInterface({ input: process.stdin })) {
    const word = line.split(/\s+/)[0];
    if (left) {
      try {
        const claim = ask(...parts(line.trim().split(/\s+/).map(Number)));
        claims.push(claim ? shown(claim) : "miss");
      } catch (why) {
        claims.push(refusal(why));
      }
      if (--left === 0) write(claims.splice(0));
    } else if (word === "scene") {
      elements = [];
    } else if (loads[word]) {
      left = Number(line.split(/\s+/)[1]);
      try {
        ask = elements.length ? loads[word](elements) : () => undefined;
      } catch (why) {
        ask = () => { throw why; };
      }
    } else {
      elements.push(element(line));
    }
  }
}
