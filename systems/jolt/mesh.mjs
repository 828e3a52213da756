// Asks Jolt Physics by NarrowPhaseQuery.CastRay of one MeshShape, of a segment that no point is beyond, and by CastShape
// of a sphere on the same way.
import { created, jolt, LAYER, physics, sphereCast } from "./physics.mjs";
import { distance, ofFaces, past, serve } from "../protocol.mjs";

const system = physics();
const bodies = system.GetBodyInterface();
const { BodyFilter, BroadPhaseLayerFilter, ObjectLayerFilter, ShapeFilter } = jolt;
const filters = [new BroadPhaseLayerFilter(), new ObjectLayerFilter(), new BodyFilter(), new ShapeFilter()];
const settings = new jolt.RayCastSettings();
settings.SetBackFaceMode(jolt.EBackFaceMode_CollideWithBackFaces);
const place = new jolt.RVec3(0, 0, 0), turned = new jolt.Quat(0, 0, 0, 1);
const start = new jolt.RVec3(0, 0, 0), direction = new jolt.Vec3(0, 0, 0);
const ray = new jolt.RRayCast(start, direction);
const collector = new jolt.CastRayClosestHitCollisionCollector();
const castSphere = sphereCast(system, filters);
let id, shape;

function meshOf(points, faces) {
  const triangles = new jolt.TriangleList();
  faces.forEach((face, i) => {
    const corners = face.map((j) => new jolt.Vec3(...points[j]));
    const triangle = new jolt.Triangle(...corners, 0, i);
    triangles.push_back(triangle);
    for (const copied of [...corners, triangle]) jolt.destroy(copied);
  });
  const settings = new jolt.MeshShapeSettings(triangles);
  jolt.destroy(triangles);
  settings.mPerTriangleUserData = true;
  return created(settings);
}

function clear() {
  if (!id) return;
  bodies.RemoveBody(id);
  bodies.DestroyBody(id);
  shape.Release();
  id = undefined;
}

function make(points, faces) {
  clear();
  shape = jolt.castObject(meshOf(points, faces), jolt.MeshShape);
  const body = new jolt.BodyCreationSettings(shape, place, turned, jolt.EMotionType_Static, LAYER);
  id = bodies.CreateAndAddBody(body, jolt.EActivation_DontActivate);
  jolt.destroy(body);
}

function build(points, faces) {
  make(points, faces);
  return (p, v) => {
    const f = past(Math.max(...points.map((point) => distance(p, point))), v);
    start.Set(...p);
    direction.Set(...v.map((x) => f * x));
    ray.mOrigin = start;
    ray.mDirection = direction;
    collector.Reset();
    system.GetNarrowPhaseQuery().CastRay(ray, settings, collector, ...filters);
    if (!collector.HadHit()) return undefined;
    return [shape.GetTriangleUserData(collector.mHit.mSubShapeID2), f * collector.mHit.mFraction];
  };
}

const coordinates = (v) => [v.GetX(), v.GetY(), v.GetZ()];

function casts(points, faces) {
  make(points, faces);
  return (p, v, radius) => {
    const f = past(radius + Math.max(...points.map((point) => distance(p, point))), v);
    const hit = castSphere(p, v.map((x) => f * x), radius);
    return hit && [shape.GetTriangleUserData(hit.mSubShapeID2), f * hit.mFraction, coordinates(hit.mContactPointOn2)];
  };
}

await serve("Jolt", "1.1.0 MeshShape", ofFaces(build), { casts: ofFaces(casts) });
