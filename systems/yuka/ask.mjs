// Asks Yuka by MeshGeometry.intersectRay of one mesh; it does not say which triangle.
import { ofFaces, packages, serve, unit } from "../protocol.mjs";

const { Matrix4, MeshGeometry, Ray, Vector3 } = await import(packages + "yuka/build/yuka.module.js");

function build(points, faces) {
  const mesh = new MeshGeometry(new Float32Array(points.flat()), new Uint32Array(faces.flat()));
  mesh.backfaceCulling = false;
  const normal = new Vector3();
  return (p, v) => {
    const ray = new Ray(new Vector3(...p), new Vector3(...unit(v)));
    const place = mesh.intersectRay(ray, new Matrix4(), true, new Vector3(), normal);
    return place && [undefined, undefined, place.toArray([]), { normal: normal.toArray([]) }];
  };
}

await serve("Yuka", "0.7.8", ofFaces(build));
