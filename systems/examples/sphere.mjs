import { createInterface } from "node:readline"; // A system that knows spheres: it reads rays and writes its hits.

console.log("system example-javascript 1");
let spheres = [];
for await (const line of createInterface({ input: process.stdin })) {
  const words = line.split(" "), x = words.map(Number);
  if (words[0] === "scene") spheres = [];
  else if (words[0] === "esfera") spheres.push({ name: words[1], c: x.slice(2, 5), r: x[5] });
  else if (words[0] !== "rays") {
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2], v = x.slice(3);
    const hits = spheres.flatMap(({ name, c, r }) => {
      const q = c.map((y, i) => x[i] - y), A = dot(v, v), B = dot(q, v), D = B * B - A * (dot(q, q) - r * r);
      return [-1, 1].map((side) => ({ name, t: (-B + side * Math.sqrt(D)) / A })).filter(({ t }) => t > 0);
    });
    const first = hits.reduce((a, b) => (b.t < a.t ? b : a), { t: Infinity });
    console.log(first.name ? `hit ${first.name} ${first.t}` : "miss");
  }
}
