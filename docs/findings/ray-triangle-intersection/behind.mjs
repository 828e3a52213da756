// ray-triangle-intersection 1.0.3: misplaced
// Expected e4 at t = 109.71428571428571, point (-1.7142857142857142, 292.57142857142856, 73.14285714285714); got e1 at (-62.666666666666664, 0, 170.66666666666666).
// A triangle behind the origin is a hit: nothing looks at the sign of t.
// the exact answer: e4 at t = 109.71428571428571
// e4:
//   t = 109.7142857142857142857142857142857142857
//     = 768/7
// the first point:
//   x = -1.714285714285714285714285714285714285714
//   y = 292.5714285714285714285714285714285714286
//   z = 73.14285714285714285714285714285714285714
//
// npm install ray-triangle-intersection && node behind.mjs
import intersect from "ray-triangle-intersection";

const p = [-36.0, 128.0, 128.0];
const v = [0.3125, 1.5, -0.5];
const triangles = {
  "e1": [[0.0, 0.0, 0.0], [-64.0, 0.0, 256.0], [-64.0, 0.0, 0.0]],
  "e4": [[0.0, 0.0, 0.0], [0.0, 320.0, 80.0], [-64.0, 0.0, 0.0]],
};

const hits = Object.entries(triangles).map(([name, corners]) => [name, intersect([], p, v, corners)]).filter(([, x]) => x);
const away = ([, x]) => Math.hypot(...x.map((y, i) => y - p[i]));
hits.sort((a, b) => away(a) - away(b));
console.log(hits.length ? `got: hit ${hits[0][0]} - ${hits[0][1].join(" ")}` : "got: miss");
console.log("expected: hit e4 - -1.7142857142857142 292.57142857142856 73.14285714285714");
