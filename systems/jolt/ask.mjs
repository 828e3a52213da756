// Asks Jolt Physics by NarrowPhaseQuery.CastRay, of a segment that no element is beyond. Convex shapes are not treated
// as solid and back faces are reported, so that a ray from inside is answered with where it leaves.
import { created, jolt, LAYER, physics, sphereCast } from "./physics.mjs";
import { along, half as halves, isBody, past, quaternionOfY, radii, segment, serve, turn } from "../protocol.mjs";

function shape(element) {
  if (element.tipo === "caja") return created(new jolt.BoxShapeSettings(new jolt.Vec3(...halves(element)), 0));
  if (element.tipo === "capsula") {
    const [radius, along] = halves(element);
    return created(new jolt.CapsuleShapeSettings(along, radius));
  }
  const half = element.altura / 2;
  if (element.tipo === "esfera") return created(new jolt.SphereShapeSettings(element.radio));
  if (element.tipo === "cilindro") return created(new jolt.CylinderShapeSettings(half, element.radio, 0));
  if (element.tipo === "triangulo") {
    const vertices = element.vertices.map((vertex) => new jolt.Vec3(...vertex));
    const triangles = new jolt.TriangleList();
    triangles.push_back(new jolt.Triangle(...vertices));
    return created(new jolt.MeshShapeSettings(triangles));
  }
  const [base, top] = radii(element);
  return created(new jolt.TaperedCylinderShapeSettings(half, top, base, 0));
}

function body(element) {
  const { tipo, altura, vector } = element;
  const position = tipo === "triangulo" ? [0, 0, 0] : tipo === "esfera" || isBody(element) ? element.centro : along(element, altura / 2);
  const rotation = isBody(element) ? turn(element) : vector ? quaternionOfY(vector) : [0, 0, 0, 1];
  const at = new jolt.RVec3(...position), turned = new jolt.Quat(...rotation), solid = shape(element);
  const settings = new jolt.BodyCreationSettings(solid, at, turned, jolt.EMotionType_Static, LAYER);
  const id = bodies.CreateBody(settings).GetID();
  for (const passed of [at, turned, settings]) jolt.destroy(passed);
  solid.Release();
  return id;
}

const system = physics();
const bodies = system.GetBodyInterface();
const filters = [new jolt.BroadPhaseLayerFilter(), new jolt.ObjectLayerFilter(), new jolt.BodyFilter(), new jolt.ShapeFilter()];
const settings = new jolt.RayCastSettings();
settings.SetBackFaceMode(jolt.EBackFaceMode_CollideWithBackFaces);
settings.mTreatConvexAsSolid = false;
const origin = new jolt.RVec3(0, 0, 0), direction = new jolt.Vec3(0, 0, 0);
const ray = new jolt.RRayCast(origin, direction);
const collector = new jolt.CastRayClosestHitCollisionCollector();
let names = new Map();

function make(elements) {
  for (const id of names.values()) { bodies.RemoveBody(id); bodies.DestroyBody(id); }
  names = new Map();
  for (const element of elements) {
    const id = body(element);
    names.set(element.name, id);
    bodies.AddBody(id, jolt.EActivation_DontActivate);
  }
}

const nameOf = (hit) => {
  const index = hit.mBodyID2?.GetIndexAndSequenceNumber() ?? hit.mBodyID.GetIndexAndSequenceNumber();
  return [...names].find(([, id]) => id.GetIndexAndSequenceNumber() === index)[0];
};

function load(elements) {
  make(elements);
  return (p, v) => {
    const f = segment(elements, p, v);
    origin.Set(...p);
    direction.Set(...v.map((x) => f * x));
    ray.mOrigin = origin;
    ray.mDirection = direction;
    collector.Reset();
    system.GetNarrowPhaseQuery().CastRay(ray, settings, collector, ...filters);
    if (!collector.HadHit()) return undefined;
    return [nameOf(collector.mHit), f * collector.mHit.mFraction];
  };
}

// A ball on a way that is longer than that of its middle by its radius.
const castSphere = sphereCast(system, filters);
function casts(elements) {
  make(elements);
  return (p, v, radius) => {
    const f = Math.max(segment(elements, p, v), past(4 * radius, v));
    const hit = castSphere(p, v.map((x) => f * x), radius);
    if (!hit) return undefined;
    const q = hit.mContactPointOn2;
    return [nameOf(hit), f * hit.mFraction, [q.GetX(), q.GetY(), q.GetZ()]];
  };
}

await serve("Jolt", "1.1.0", load, { casts });
