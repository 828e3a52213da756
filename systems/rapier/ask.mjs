// Asks Rapier by World.castRayAndGetNormal of one collider, which is a triangle mesh; it does not say
// which triangle.
import { ofFaces, packages, serve } from "../protocol.mjs";

const { default: rapier } = await import(packages + "@dimforge/rapier3d-compat/dist/rapier.mjs");
await rapier.init();
const vector = ([x, y, z]) => ({ x, y, z });
let world;

function build(points, faces) {
  world?.free();
  world = new rapier.World(vector([0, 0, 0]));
  world.createCollider(rapier.ColliderDesc.trimesh(new Float32Array(points.flat()), new Uint32Array(faces.flat())));
  world.step();
  return (p, v) => {
    const hit = world.castRayAndGetNormal(new rapier.Ray(vector(p), vector(v)), 3.4028234663852886e38, false);
    if (!hit) return undefined;
    const { x, y, z } = hit.normal;
    return [undefined, hit.timeOfImpact, undefined, { normal: [x, y, z] }];
  };
}

await serve("Rapier", rapier.version(), ofFaces(build));
