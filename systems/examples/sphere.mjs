// A system that knows spheres: it reads the rays of `durero conform run` and writes its hits.
import { createInterface } from "node:readline";

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
let spheres = [];
console.log("system example-javascript 1");
for await (const line of createInterface({ input: process.stdin })) {
  const words = line.split(" "), x = words.map(Number), v = x.slice(3);
  if (words[0] === "scene") spheres = [];
  if (words[0] === "esfera") spheres.push({ name: words[1], c: x.slice(2, 5), r: x[5] });
  const hits = spheres.flatMap(({ name, c, r }) => {
    const q = c.map((y, i) => x[i] - y), A = dot(v, v), B = dot(q, v), C = dot(q, q) - r * r;
    return [-1, 1].map((side) => ({ name, t: (-B + side * Math.sqrt(B * B - A * C)) / A }));
  });
  const [first] = hits.filter(({ t }) => t > 0).sort((a, b) => a.t - b.t); // NaN is no root
  if (!isNaN(x[0])) console.log(first ? `hit ${first.name} ${first.t}` : "miss"); // it was a ray
}
