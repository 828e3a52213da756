import { faces } from "./shapes.js";
import { mesh_of } from "./solids.js";
import { add, sub, times } from "./vectors.js";

// drawn_of gives what the picture draws of a scene: name, colour and mesh; and the names that it has no mesh for.
export function drawn_of(scene) {
  const colour = e => scene.materials?.[e.material]?.color ?? [0.8, 0.8, 0.8];
  const solid = e => {
    // a mirror or a glass has hardly a colour of its own
    const m = scene.materials?.[e.material];
    return m && (m.k_t ?? 0) > 0.5 ? [0.72, 0.82, 0.85] : m && (m.k_ps ?? 0) > 0.5 ? [0.62, 0.66, 0.7] : colour(e);
  };
  const meshes = [],
    left_out = [];
  for (const element of scene.elementos ?? []) {
    const mesh = mesh_of(element, scene);
    if (mesh) meshes.push({ id: element.id, tipo: element.tipo, colour: solid(element), ...mesh });
    else left_out.push(element.id);
  }
  for (const malla of scene.mallas ?? [])
    meshes.push({ id: malla.id, tipo: "malla", colour: solid(malla), ...faces(malla.puntos, malla.caras) });
  return { meshes, left_out };
}

// ball_of is a ball about all bounded elements: its middle and its radius.
export function ball_of(meshes) {
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  for (const { tipo, positions } of meshes) {
    if (tipo === "plano") continue;
    for (let i = 0; i < positions.length; ++i) {
      const k = i % 3;
      if (positions[i] < low[k]) low[k] = positions[i];
      if (positions[i] > high[k]) high[k] = positions[i];
    }
  }
  if (!(low[0] <= high[0])) return { middle: [0, 0, 0], radius: 3 };
  return { middle: times(add(low, high), 0.5), radius: Math.max(0.5, Math.hypot(...sub(high, low)) / 2) };
}
