// Asks PlayCanvas by Tri.intersectsRay, triangle by triangle.
import { ofFaces, packages, serve, triangleByTriangle, unit } from "../protocol.mjs";

const source = packages + "playcanvas/build/playcanvas/src/core/";
const { Vec3 } = await import(source + "math/vec3.js");
const { Ray } = await import(source + "shape/ray.js");
const { Tri } = await import(source + "shape/tri.js");
const vector = (n) => new Vec3(...n);

function meet(ray, triangle) {
  const place = new Vec3();
  return triangle.intersectsRay(ray, place) ? [undefined, place.toArray()] : undefined;
}

const build = triangleByTriangle((corners) => new Tri(...corners.map(vector)), (p, v) => new Ray(vector(p), vector(unit(v))), meet);
await serve("PlayCanvas", "2.23.3", ofFaces(build));
