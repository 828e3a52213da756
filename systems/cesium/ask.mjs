// Asks CesiumJS by IntersectionTests.rayTriangleParametric, triangle by triangle.
import { nearest, ofFaces, packages, serve } from "../protocol.mjs";

const source = packages + "@cesium/engine/Source/Core/";
const { default: Cartesian3 } = await import(source + "Cartesian3.js");
const { default: IntersectionTests } = await import(source + "IntersectionTests.js");
const { default: Ray } = await import(source + "Ray.js");
const vector = (n) => new Cartesian3(...n);

function build(points, faces) {
  const triangles = faces.map((face) => face.map((i) => vector(points[i])));
  return (p, v) => {
    const ray = new Ray(vector(p), vector(v));
    const hits = triangles.map((corners, i) => [i, IntersectionTests.rayTriangleParametric(ray, ...corners, false)]);
    return nearest(hits.filter(([, t]) => t >= 0));
  };
}

await serve("CesiumJS", "26.3.0", ofFaces(build));
