// Asks Babylon.js by Ray.intersectsMesh of one mesh.
import { ofFaces, packages, serve, unit } from "../protocol.mjs";

const core = packages + "@babylonjs/core/";
const { NullEngine } = await import(core + "Engines/nullEngine.js");
await import(core + "Materials/standardMaterial.js");  // without which no mesh has a material, and none is met
const { Scene } = await import(core + "scene.js");
const { Mesh } = await import(core + "Meshes/mesh.js");
const { VertexData } = await import(core + "Meshes/mesh.vertexData.js");
const { Ray } = await import(core + "Culling/ray.js");
const { Vector3 } = await import(core + "Maths/math.vector.js");
const scene = new Scene(new NullEngine());
let mesh;

function build(points, faces) {
  mesh?.dispose();
  mesh = new Mesh("mesh", scene);
  const data = new VertexData();
  data.positions = points.flat();
  data.indices = faces.flat();
  data.applyToMesh(mesh);
  return (p, v) => {
    const hit = new Ray(new Vector3(...p), new Vector3(...unit(v)), Number.MAX_VALUE, 0).intersectsMesh(mesh);
    if (!hit.hit) return undefined;
    const { faceId, distance, bu, bv, pickedPoint } = hit;
    return [faceId, distance, pickedPoint.asArray(), { uv: [bv, 1 - bu - bv] }];
  };
}

await serve("Babylon.js", "9.31.0", ofFaces(build));
