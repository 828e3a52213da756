// What Jolt Physics needs before it can be asked.
import { packages } from "../protocol.mjs";

const { default: start } = await import(packages + "jolt-physics/dist/jolt-physics.wasm-compat.js");
export const jolt = await start();
export const LAYER = 0;
const LAYERS = 1;

// A world of one layer.
export function physics() {
  const pairs = new jolt.ObjectLayerPairFilterTable(LAYERS);
  const layers = new jolt.BroadPhaseLayerInterfaceTable(LAYERS, LAYERS);
  layers.MapObjectToBroadPhaseLayer(LAYER, new jolt.BroadPhaseLayer(LAYER));
  const settings = new jolt.JoltSettings();
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(layers, LAYERS, pairs, LAYERS);
  return new jolt.JoltInterface(settings).GetPhysicsSystem();
}

// The first hit of a sphere that is cast, of back faces, too; nothing where it meets none.
export function sphereCast(system, filters) {
  const settings = new jolt.ShapeCastSettings();
  settings.mBackFaceModeTriangles = jolt.EBackFaceMode_CollideWithBackFaces;
  settings.mBackFaceModeConvex = jolt.EBackFaceMode_CollideWithBackFaces;
  settings.mActiveEdgeMode = jolt.EActiveEdgeMode_CollideWithAll;
  const base = new jolt.RVec3(0, 0, 0), scale = new jolt.Vec3(1, 1, 1);
  const collector = new jolt.CastShapeClosestHitCollisionCollector();
  return (p, way, radius) => {
    const ball = new jolt.SphereShape(radius), start = new jolt.RVec3(...p), direction = new jolt.Vec3(...way);
    ball.AddRef();
    const cast = new jolt.RShapeCast(ball, scale, jolt.RMat44.prototype.sTranslation(start), direction);
    collector.Reset();
    system.GetNarrowPhaseQuery().CastShape(cast, settings, base, collector, ...filters);
    for (const passed of [cast, start, direction]) jolt.destroy(passed);
    ball.Release();
    return collector.HadHit() ? collector.mHit : undefined;
  };
}

// The shape that settings ask for; who asks releases it.
export function created(settings) {
  const result = settings.Create();
  if (result.HasError()) throw new Error(result.GetError().c_str());
  const shape = result.Get();
  shape.AddRef();
  jolt.destroy(settings);
  return shape;
}
