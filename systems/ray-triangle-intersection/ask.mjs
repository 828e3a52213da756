// Asks ray-triangle-intersection, triangle by triangle.
import { distance, nearest, ofFaces, packages, serve } from "../protocol.mjs";

const { default: intersect } = await import(packages + "ray-triangle-intersection/index.js");

function build(points, faces) {
  const triangles = faces.map((face) => face.map((i) => points[i]));
  return (p, v) => {
    const hits = triangles.map((corners, i) => [i, intersect([], p, v, corners)]).filter(([, place]) => place);
    const hit = nearest(hits.map(([i, place]) => [i, distance(p, place), place]));
    return hit && [hit[0], undefined, hit[2]];
  };
}

await serve("ray-triangle-intersection", "1.0.3", ofFaces(build));
