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

// The shape that settings ask for; who asks releases it.
export function created(settings) {
  const result = settings.Create();
  if (result.HasError()) throw new Error(result.GetError().c_str());
  const shape = result.Get();
  shape.AddRef();
  jolt.destroy(settings);
  return shape;
}
