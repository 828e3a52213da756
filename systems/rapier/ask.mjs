// Asks Rapier by World.castRayAndGetNormal of one collider, which is a triangle mesh; it does not say
// which triangle. Balls are cast by World.castShape.
import { ofFaces, packages, serve } from "../protocol.mjs";

const { default: rapier } = await import(packages + "@dimforge/rapier3d-compat/dist/rapier.mjs");
await rapier.init();
const vector = ([x, y, z]) => ({ x, y, z });
let world;

function make(points, faces) {
  world?.free();
  world = new rapier.World(vector([0, 0, 0]));
  world.createCollider(rapier.ColliderDesc.trimesh(new Float32Array(points.flat()), new Uint32Array(faces.flat())));
  world.step();
}

function build(points, faces) {
  make(points, faces);
  return (p, v) => {
    const hit = world.castRayAndGetNormal(new rapier.Ray(vector(p), vector(v)), 3.4028234663852886e38, false);
    if (!hit) return undefined;
    const { x, y, z } = hit.normal;
    return [undefined, hit.timeOfImpact, undefined, { normal: [x, y, z] }];
  };
}

// The first touch. The module is of no use after it panicked, and so the program ends.
function first(p, turned, v, ball) {
  try {
    return world.castShape(p, turned, v, ball, 0, 3.4028234663852886e38, true);
  } catch {
    return process.exit(1);
  }
}

function casts(points, faces) {
  make(points, faces);
  const turned = { x: 0, y: 0, z: 0, w: 1 };
  return (p, v, radius) => {
    const hit = first(vector(p), turned, vector(v), new rapier.Ball(radius));
    if (!hit) return undefined;
    const { x, y, z } = hit.witness1;
    return [undefined, hit.time_of_impact, [x, y, z]];
  };
}

await serve("Rapier", rapier.version(), ofFaces(build), { casts: ofFaces(casts) });
