// Asks PlayCanvas by Tri.intersectsRay, triangle by triangle.
import { distance, nearest, ofFaces, packages, serve, unit } from "../protocol.mjs";

const source = packages + "playcanvas/build/playcanvas/src/core/";
const { Vec3 } = await import(source + "math/vec3.js");
const { Ray } = await import(source + "shape/ray.js");
const { Tri } = await import(source + "shape/tri.js");
const vector = (n) => new Vec3(...n);

function build(points, faces) {
  const triangles = faces.map((face) => new Tri(...face.map((i) => vector(points[i]))));
  return (p, v) => {
    const ray = new Ray(vector(p), vector(unit(v)));
    const hits = [];
    triangles.forEach((triangle, i) => {
      const place = new Vec3();
      if (triangle.intersectsRay(ray, place)) hits.push([i, distance(p, place.toArray()), place.toArray()]);
    });
    const hit = nearest(hits);
    return hit && [hit[0], undefined, hit[2]];
  };
}

await serve("PlayCanvas", "2.23.3", ofFaces(build));
