// Asks cannon-es by World.raycastClosest, of a segment that no element is beyond.
import { packages, quaternionOfZ, segment, serve } from "../protocol.mjs";

const { Body, Plane, Quaternion, Sphere, RaycastResult, Trimesh, Vec3, World } = await import(packages + "cannon-es/dist/cannon-es.js");
const vector = (n) => new Vec3(...n);

function body(element) {
  if (element.tipo === "triangulo")
    return new Body({ mass: 0, shape: new Trimesh(element.vertices.flat(), [0, 1, 2]) });
  const position = vector(element.centro);
  if (element.tipo === "esfera") return new Body({ mass: 0, position, shape: new Sphere(element.radio) });
  const quaternion = new Quaternion(...quaternionOfZ(element.vector));
  return new Body({ mass: 0, position, quaternion, shape: new Plane() });
}

function load(elements) {
  const world = new World();
  const names = new Map();
  for (const element of elements) {
    const added = body(element);
    world.addBody(added);
    names.set(added, element.name);
  }
  return (p, v) => {
    const f = segment(elements, p, v);
    const end = p.map((x, i) => x + f * v[i]);
    const result = new RaycastResult();
    world.raycastClosest(vector(p), vector(end), {}, result);
    return result.hasHit ? [names.get(result.body), result.distance, result.hitPointWorld.toArray()] : undefined;
  };
}

await serve("cannon-es", "0.20.0", load);
