// Asks ammo.js, which is Bullet, by rayTest of one btBvhTriangleMeshShape, of a segment that no point is beyond; it does
// not say which triangle.
import { distance, ofFaces, packages, past, serve } from "../protocol.mjs";

const { default: ammo } = await import(packages + "ammo.js/ammo.js");
const vector = (n) => new ammo.btVector3(...n);
const configuration = new ammo.btDefaultCollisionConfiguration();
const solver = new ammo.btSequentialImpulseConstraintSolver();
const parts = [new ammo.btCollisionDispatcher(configuration), new ammo.btDbvtBroadphase(), solver, configuration];
const world = new ammo.btDiscreteDynamicsWorld(...parts);
let body, mesh;

function build(points, faces) {
  if (body) world.removeRigidBody(body);
  body = undefined;
  mesh = new ammo.btTriangleMesh(true, true);
  for (const face of faces) mesh.addTriangle(...face.map((i) => vector(points[i])), false);
  const shape = new ammo.btBvhTriangleMeshShape(mesh, true, true);
  const place = new ammo.btTransform();
  place.setIdentity();
  const motion = new ammo.btDefaultMotionState(place);
  body = new ammo.btRigidBody(new ammo.btRigidBodyConstructionInfo(0, motion, shape, vector([0, 0, 0])));
  world.addRigidBody(body);
  return (p, v) => {
    const f = past(Math.max(...points.map((point) => distance(p, point))), v);
    const ends = [vector(p), vector(p.map((x, i) => x + f * v[i]))];
    const result = new ammo.ClosestRayResultCallback(...ends);
    world.rayTest(...ends, result);
    if (!result.hasHit()) return undefined;
    const [point, normal] = [result.get_m_hitPointWorld(), result.get_m_hitNormalWorld()].map((of) => [of.x(), of.y(), of.z()]);
    return [undefined, undefined, point, { normal }];
  };
}

await serve("ammo.js", "0.0.10", ofFaces(build));
