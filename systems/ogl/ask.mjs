// Asks OGL by Raycast.intersectTriangle, triangle by triangle.
import { nearest, ofFaces, packages, serve } from "../protocol.mjs";

const { Raycast } = await import(packages + "ogl/src/extras/Raycast.js");
const { Vec3 } = await import(packages + "ogl/src/math/Vec3.js");
const vector = (n) => new Vec3(...n);

function build(points, faces) {
  const raycast = new Raycast();
  const triangles = faces.map((face) => face.map((i) => vector(points[i])));
  return (p, v) => {
    const ray = [vector(p), vector(v)];
    const hits = triangles.map((corners, i) => [i, raycast.intersectTriangle(...corners, false, ...ray)]);
    return nearest(hits.filter(([, t]) => t));
  };
}

await serve("OGL", "1.0.11", ofFaces(build));
