// Asks Crashcat by castRay of one triangle mesh, of a segment that no point is beyond; it does not say which triangle.
import { distance, ofFaces, packages, past, serve, unit } from "../protocol.mjs";

const crashcat = await import(packages + "crashcat/dist/index.js");
const { castRay, CastRayStatus, createClosestCastRayCollector, createDefaultCastRaySettings } = crashcat;
const { createWorld, createWorldSettings } = crashcat;
const { addBroadphaseLayer, addObjectLayer, filter, MotionType, registerAll, rigidBody, triangleMesh } = crashcat;

registerAll();
const layers = createWorldSettings();
const objectLayer = addObjectLayer(layers, addBroadphaseLayer(layers));
const settings = createDefaultCastRaySettings();
settings.collideWithBackfaces = true;

function build(points, faces) {
  const world = createWorld(layers);
  const shape = triangleMesh.create({ positions: points.flat(), indices: faces.flat() });
  rigidBody.create(world, { shape, motionType: MotionType.STATIC, objectLayer });
  const all = filter.create(world.settings.layers);
  return (p, v) => {
    const far = past(Math.max(...points.map((point) => distance(p, point))), unit(v));
    const collector = createClosestCastRayCollector();
    castRay(world, collector, settings, p, unit(v), far, all);
    const { status, fraction } = collector.hit;
    return status === CastRayStatus.COLLIDING ? [undefined, far * fraction] : undefined;
  };
}

await serve("Crashcat", "0.0.5", ofFaces(build));
