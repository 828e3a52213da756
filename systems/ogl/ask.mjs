// Asks OGL by Raycast.intersectTriangle, triangle by triangle.
import { ofFaces, packages, serve, triangleByTriangle } from "../protocol.mjs";

const { Raycast } = await import(packages + "ogl/src/extras/Raycast.js");
const { Vec3 } = await import(packages + "ogl/src/math/Vec3.js");
const vector = (n) => new Vec3(...n);
const raycast = new Raycast();

function meet(ray, corners) {
  const t = raycast.intersectTriangle(...corners, false, ...ray);
  return t ? [t] : undefined;
}

const build = triangleByTriangle((corners) => corners.map(vector), (p, v) => [vector(p), vector(v)], meet);
await serve("OGL", "1.0.11", ofFaces(build));
