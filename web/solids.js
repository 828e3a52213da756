import { closed_mesh, image, joined, matrix_of, plane_reach, shape_mesh, square } from "./shapes.js";
import { add, cross, dot, long, sub, times } from "./vectors.js";

// Solids as triangles, for the picture alone. A point of a part's surface is on the surface of the whole where it makes a
// difference whether the point is in that part; the triangles of all parts are cut down to these.
const most_shapes = 40,
  pieces = 24,
  finest = 12,
  deepest = 8;

const solids = ["union", "interseccion", "diferencia"];

// is_in tells whether a shape as a solid has it holds a point.
function is_in(shape, point) {
  if (shape.tipo === "caja") return [0, 1, 2].every(k => shape.esquinas[0][k] <= point[k] && point[k] <= shape.esquinas[1][k]);
  const q = sub(point, shape.centro);
  if (shape.tipo === "esfera") return long(q) <= shape.radio;
  const s = dot(q, shape.vector);
  if (shape.tipo === "plano") return s <= 0;
  const at_height = (shape.radio ?? 0) + (shape.proporcion ?? 0) * (shape.altura - s);
  return s >= 0 && s <= shape.altura && long(sub(q, times(shape.vector, s))) <= at_height;
}

// inverse_of gives the map back of an affine one, as a function of a point.
function inverse_of(m) {
  const columns = [0, 1, 2].map(c => m.map(row => row[c])),
    size = dot(columns[0], cross(columns[1], columns[2]));
  const rows = [cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])];
  return point => {
    const q = sub(point, [m[0][3], m[1][3], m[2][3]]);
    return rows.map(row => dot(row, q) / size);
  };
}

const named = (part, scene) =>
  typeof part === "string" ? (scene.elementos?.find(e => e.id === part) ?? scene.prototypes?.[part]) : part;

// tree_of gives a solid as a tree whose leaves are shapes in `leaves`, each with its maps, the innermost first; null where a
// part is none that the picture knows, or where there are too many.
function tree_of(element, scene, maps, leaves, depth = 0) {
  if (!element?.tipo || depth > deepest || leaves.length >= most_shapes) return null;
  if (element.tipo === "instancia")
    return tree_of(named(element.de, scene), scene, [matrix_of(element.mapa), ...maps], leaves, depth + 1);
  if (solids.includes(element.tipo)) {
    const parts = element.de.map(part => tree_of(named(part, scene), scene, maps, leaves, depth + 1));
    return parts.every(Boolean) ? { tipo: element.tipo, parts } : null;
  }
  if (!shape_mesh(element) || ["disco", "triangulo"].includes(element.tipo)) return null;
  const inverses = maps.map(inverse_of).reverse(),
    back = point => inverses.reduce((p, f) => f(p), point);
  leaves.push({ shape: element, maps, back, holds: point => is_in(element, back(point)) });
  return { leaf: leaves.length - 1 };
}

// whole_holds tells whether the whole holds a point, where its shapes do as `holds` says.
function whole_holds(tree, holds) {
  if (!tree.parts) return holds(tree.leaf);
  const in_part = part => whole_holds(part, holds);
  if (tree.tipo === "union") return tree.parts.some(in_part);
  if (tree.tipo === "interseccion") return tree.parts.every(in_part);
  return in_part(tree.parts[0]) && !tree.parts.slice(1).some(in_part);
}

const moved = (mesh, maps) => maps.reduce(image, mesh);

// box_of gives the least box about a bounded mesh.
function box_of({ positions }) {
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  return { low, high };
}

const everywhere = { low: [-Infinity, -Infinity, -Infinity], high: [Infinity, Infinity, Infinity] };
const each_way = (a, b, low, high) => ({
  low: a.low.map((x, k) => low(x, b.low[k])),
  high: a.high.map((x, k) => high(x, b.high[k])),
});

// The planes of the box within which an unbounded solid is drawn, as { n, d } for n·x ≤ d.
const unit_along = (k, sign) => [0, 1, 2].map(i => (i === k ? sign : 0));
const drawn_walls = [0, 1, 2].flatMap(k => [1, -1].map(sign => ({ n: unit_along(k, sign), d: plane_reach })));

// corners_between gives the corners of what is behind all of some planes.
function corners_between(planes) {
  const found = [];
  for (let i = 0; i < planes.length; ++i)
    for (let j = 0; j < i; ++j)
      for (let k = 0; k < j; ++k) {
        const [a, b, c] = [planes[i], planes[j], planes[k]],
          size = dot(a.n, cross(b.n, c.n));
        if (Math.abs(size) < 1e-9) continue;
        const sums = [times(cross(b.n, c.n), a.d), times(cross(c.n, a.n), b.d), times(cross(a.n, b.n), c.d)];
        const corner = times(sums.reduce(add), 1 / size);
        if (planes.every(({ n, d }) => dot(n, corner) <= d + 1e-6)) found.push(...corner);
      }
  return found;
}

// plane_of gives the plane of a leaf where its maps have moved it.
function plane_of({ shape, maps }) {
  const { positions, normals } = moved(square(shape.centro, shape.vector, 1), maps);
  const n = normals.slice(0, 3);
  return { n, d: dot(n, positions.slice(0, 3)) };
}

// bounds_of gives a box about the whole.
function bounds_of(tree, leaves) {
  if (!tree.parts) {
    const { shape, maps } = leaves[tree.leaf];
    return shape.tipo === "plano" ? everywhere : box_of(moved(closed_mesh(shape), maps));
  }
  const of_parts = tree.parts.map(part => bounds_of(part, leaves));
  if (tree.tipo === "union") return of_parts.reduce((a, b) => each_way(a, b, Math.min, Math.max));
  if (tree.tipo === "diferencia") return of_parts[0];
  const planes = tree.parts.filter(part => !part.parts && leaves[part.leaf].shape.tipo === "plano"),
    walls = planes.map(part => plane_of(leaves[part.leaf]));
  const between = box_of({ positions: corners_between([...walls, ...drawn_walls]) });
  return of_parts.reduce((a, b) => each_way(a, b, Math.max, Math.min), planes.length ? between : everywhere);
}

// plane_in gives the square of a plane that a box needs.
function plane_in(plane, { low, high }) {
  const middle = times(add(low, high), 0.5),
    off = dot(sub(middle, plane.centro), plane.vector);
  return square(sub(middle, times(plane.vector, off)), plane.vector, long(sub(high, low)) / 2, pieces);
}

const corners_of = ({ low, high }) =>
  [0, 1, 2, 3, 4, 5, 6, 7].map(i => [0, 1, 2].map(k => ((i >> k) & 1 ? high : low)[k]));

const half = (a, b) => a.map((x, k) => (x + b[k]) / 2);

// cut keeps of a mesh the pieces that `side` takes: 1 as they are, -1 turned round, 0 not. A triangle longer than `longest` is
// halved across its longest edge, and so is a shorter one that is not all on one side.
function cut(mesh, longest, side) {
  const positions = [],
    normals = [],
    indices = [];
  const put = (corners, turn) => {
    for (const [p, n] of corners) {
      indices.push(positions.length / 3);
      positions.push(...p);
      normals.push(...times(n, turn));
    }
  };
  const visit = corners => {
    const edges = corners.map(([p], i) => long(sub(p, corners[(i + 1) % 3][0]))),
      size = Math.max(...edges);
    const middle = times(corners.map(([p]) => p).reduce(add), 1 / 3),
      here = side(middle);
    if (size > longest || (size > longest / finest && corners.some(([p]) => side(half(p, middle)) !== here))) {
      const first = edges.indexOf(size),
        [a, b, c] = [0, 1, 2].map(i => corners[(first + i) % 3]);
      const ab = [half(a[0], b[0]), half(a[1], b[1])];
      visit([a, ab, c]);
      visit([ab, b, c]);
    } else if (here !== 0) put(corners, here);
  };
  const corner = i => [mesh.positions.slice(3 * i, 3 * i + 3), mesh.normals.slice(3 * i, 3 * i + 3)];
  for (let i = 0; i < mesh.indices.length; i += 3)
    visit(mesh.indices.slice(i, i + 3).map(corner));
  return { positions, normals, indices };
}

// solid_mesh gives the triangles of the surface of a solid; null where its parts are not known, or too many.
function solid_mesh(solid, scene) {
  const leaves = [],
    tree = tree_of(solid, scene, [], leaves);
  if (!tree) return null;
  const is_plane = leaf => leaf.shape.tipo === "plano";
  const reach = { low: [-plane_reach, -plane_reach, -plane_reach], high: [plane_reach, plane_reach, plane_reach] };
  const finite = (x, other) => (Number.isFinite(x) ? x : other);
  const whole = each_way(bounds_of(tree, leaves), reach, finite, finite);
  const longest = long(sub(whole.high, whole.low)) / pieces;
  return joined(
    leaves.map((leaf, own) => {
      const near = box_of({ positions: corners_of(whole).flatMap(leaf.back) });
      const mesh = moved(is_plane(leaf) ? plane_in(leaf.shape, near) : closed_mesh(leaf.shape), leaf.maps);
      return cut(mesh, longest, point => {
        const with_it = whole_holds(tree, i => i === own || leaves[i].holds(point)),
          without = whole_holds(tree, i => i !== own && leaves[i].holds(point));
        return Number(with_it) - Number(without);
      });
    }),
  );
}

// mesh_of gives the triangles of an element, or null where the picture has none for it.
export function mesh_of(element, scene, depth = 0) {
  if (solids.includes(element.tipo)) return solid_mesh(element, scene);
  if (element.tipo !== "instancia") return shape_mesh(element);
  const original = named(element.de, scene),
    mesh = original?.tipo && depth < deepest ? mesh_of(original, scene, depth + 1) : null;
  return mesh && image(mesh, matrix_of(element.mapa));
}
