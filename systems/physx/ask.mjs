// Asks PhysX by PxScene.raycastSingle of one triangle mesh, from both sides; it does not say which triangle.
import { distance, ofFaces, packages, past, serve, unit } from "../protocol.mjs";

const { default: start } = await import(packages + "@cocos/physx/builds/physx.release.asm.js");
const px = await new Promise((resolve) => start().then((it) => { delete it.then; resolve(it); }));
const version = px.PX_PHYSICS_VERSION;
const foundation = px.PxCreateFoundation(version, new px.PxDefaultAllocator(), new px.PxDefaultErrorCallback());
const tolerances = new px.PxTolerancesScale();
const physics = px.PxCreatePhysics(version, foundation, tolerances, false, null);
const cooking = px.PxCreateCooking(version, foundation, new px.PxCookingParams(tolerances));
const material = physics.createMaterial(0.5, 0.5, 0.5);
const scene = physics.createScene(px.getDefaultSceneDesc(physics.getTolerancesScale(), 0, null));
const flags = new px.PxShapeFlags(px.PxShapeFlag.eSCENE_QUERY_SHAPE.value);
const sides = new px.PxMeshGeometryFlags(0);
const wanted = px.PxHitFlag.eDEFAULT.value | px.PxHitFlag.eMESH_BOTH_SIDES.value;
const hit = new px.PxRaycastHit(), filter = new px.PxQueryFilterData();
const vector = ([x, y, z]) => ({ x, y, z });
let body;

function meshOf(points, faces) {
  const [vertices, indices] = [new px.PxVec3Vector(), new px.PxU16Vector()];
  for (const point of points) vertices.push_back(vector(point));
  for (const index of faces.flat()) indices.push_back(index);
  return cooking.createTriMeshExt(vertices, indices, physics);
}

function build(points, faces) {
  if (body) scene.removeActor(body, false);
  body = undefined;
  const rotation = { x: 0, y: 0, z: 0, w: 1 };
  const scale = new px.PxMeshScale(vector([1, 1, 1]), rotation);
  const geometry = new px.PxTriangleMeshGeometry(meshOf(points, faces), scale, sides);
  body = physics.createRigidStatic({ translation: vector([0, 0, 0]), rotation });
  body.attachShape(physics.createShape(geometry, material, true, flags));
  scene.addActor(body, null);
  return (p, v) => {
    const far = past(Math.max(...points.map((point) => distance(p, point))), unit(v));
    if (!scene.raycastSingle(vector(p), vector(unit(v)), far, wanted, hit, filter, null, null)) return undefined;
    const [point, normal] = [hit.position, hit.normal].map(({ x, y, z }) => [x, y, z]);
    return [undefined, hit.distance, point, { normal }];
  };
}

await serve("PhysX", `${version >> 24}.${(version >> 16) & 255}.${(version >> 8) & 255}`, ofFaces(build));
