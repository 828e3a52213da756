// Asks three.js by Ray, shape by shape.
import { nearest, packages, serve, unit } from "../protocol.mjs";

const { Plane, Ray, REVISION, Sphere, Vector3 } = await import(packages + "three/build/three.module.js");
const vector = (n) => new Vector3(...n);

// What asks the ray for its point of the element.
function asked(element) {
  if (element.tipo === "esfera") {
    const sphere = new Sphere(vector(element.centro), element.radio);
    return (ray) => ray.intersectSphere(sphere, new Vector3());
  }
  if (element.tipo === "plano") {
    const plane = new Plane().setFromNormalAndCoplanarPoint(vector(element.vector), vector(element.centro));
    return (ray) => ray.intersectPlane(plane, new Vector3());
  }
  const [a, b, c] = element.vertices.map(vector);
  return (ray) => ray.intersectTriangle(a, b, c, false, new Vector3());
}

function load(elements) {
  const shapes = elements.map((element) => [element.name, asked(element)]);
  return (p, v) => {
    const ray = new Ray(vector(p), vector(unit(v)));
    const hits = shapes.map(([name, ask]) => [name, ask(ray)]).filter(([, point]) => point);
    const hit = nearest(hits.map(([name, point]) => [name, ray.origin.distanceTo(point), point.toArray()]));
    return hit && [hit[0], undefined, hit[2]];
  };
}

await serve("three.js", REVISION, load);
