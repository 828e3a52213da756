// Asks CesiumJS by IntersectionTests.rayTriangleParametric, triangle by triangle.
import { ofFaces, packages, serve, triangleByTriangle } from "../protocol.mjs";

const source = packages + "@cesium/engine/Source/Core/";
const { default: Cartesian3 } = await import(source + "Cartesian3.js");
const { default: IntersectionTests } = await import(source + "IntersectionTests.js");
const { default: Ray } = await import(source + "Ray.js");
const vector = (n) => new Cartesian3(...n);

function meet(ray, corners) {
  const t = IntersectionTests.rayTriangleParametric(ray, ...corners, false);
  return t >= 0 ? [t] : undefined;
}

const build = triangleByTriangle((corners) => corners.map(vector), (p, v) => new Ray(vector(p), vector(v)), meet);
await serve("CesiumJS", "26.3.0", ofFaces(build));
