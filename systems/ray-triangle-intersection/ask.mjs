// Asks ray-triangle-intersection, triangle by triangle.
import { ofFaces, packages, serve, triangleByTriangle } from "../protocol.mjs";

const { default: intersect } = await import(packages + "ray-triangle-intersection/index.js");

function meet([p, v], corners) {
  const place = intersect([], p, v, corners);
  return place ? [undefined, place] : undefined;
}

const build = triangleByTriangle((corners) => corners, (p, v) => [p, v], meet);
await serve("ray-triangle-intersection", "1.0.3", ofFaces(build));
