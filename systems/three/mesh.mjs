// Asks three.js by Raycaster of one Mesh, or three-mesh-bvh by its MeshBVH, as the second argument says.
import { ofFaces, packages, serve, unit } from "../protocol.mjs";

const three = await import(packages + "three/build/three.module.js");
const { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial, Ray, Raycaster, REVISION, Vector3 } = three;
const isBvh = process.argv[3] === "bvh";
const { MeshBVH } = isBvh ? await import(packages + "three-mesh-bvh/src/index.js") : {};
const vector = (n) => new Vector3(...n);

function geometryOf(points, faces) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points.flat()), 3));
  return geometry.setIndex(faces.flat());
}

const claim = ({ faceIndex, distance, point, face, barycoord }, v) => [faceIndex, distance / Math.hypot(...v), point.toArray(),
  { normal: face.normal.toArray(), uv: barycoord && [barycoord.y, barycoord.z] }];

function ofMesh(points, faces) {
  const mesh = new Mesh(geometryOf(points, faces), new MeshBasicMaterial({ side: DoubleSide }));
  return (p, v) => {
    const [hit] = new Raycaster(vector(p), vector(unit(v))).intersectObject(mesh);
    return hit && claim(hit, v);
  };
}

// A new geometry for each tree, which puts its faces in another order unless it is indirect.
const treeOf = (points, faces) => new MeshBVH(geometryOf(points, faces), { indirect: true });

function ofTree(points, faces) {
  const tree = treeOf(points, faces);
  return (p, v, begin = 0, end = Infinity) => {
    const ends = [begin, end].map((t) => t * Math.hypot(...v));
    const hit = tree.raycastFirst(new Ray(vector(p), vector(unit(v))), DoubleSide, ...ends);
    return hit && claim(hit, v);
  };
}

function closestOf(points, faces) {
  const tree = treeOf(points, faces);
  return (p) => {
    const { faceIndex, distance, point } = tree.closestPointToPoint(vector(p));
    return [faceIndex, distance, point.toArray()];
  };
}

const tree = ofFaces(ofTree);
if (isBvh) await serve("three-mesh-bvh", "0.9.17", tree, { ranges: tree, points: ofFaces(closestOf) });
else await serve("three.js", `${REVISION} Mesh`, ofFaces(ofMesh));
