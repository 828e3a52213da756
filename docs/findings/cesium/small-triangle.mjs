// CesiumJS 26.3.0: missed
// Expected e3 at t = 7.940933880509066e-22, point (-8.602678370551488e-23, 6.617444900424221e-23, 0); got a miss.
// A determinant below 10⁻⁶ counts as parallel, whatever the size of the triangle.
// the exact answer: e3 at t = 7.940933880509066e-22
// e3:
//   t = 7.940933880509065678765523443871643394232e-22
//     = 15/18889465931478580854784
// the first point:
//   x = -8.602678370551487818662650397527613677084e-23
//   y = 6.617444900424221398971269536559702828526e-23
//   z = 0
//
// npm install @cesium/engine && node small-triangle.mjs
import { Cartesian3, IntersectionTests, Ray } from "@cesium/engine";

const ray = new Ray(new Cartesian3(2.117582368135751e-22, -5.293955920339377e-22, 7.940933880509066e-22), new Cartesian3(-0.375, 0.75, -1.0));
const triangles = {
  "e3": [new Cartesian3(0.0, 0.0, 0.0), new Cartesian3(0.0, 2.117582368135751e-22, 0.0), new Cartesian3(-2.117582368135751e-22, 0.0, 0.0)],
};

const hits = Object.entries(triangles).map(([name, corners]) => [name, IntersectionTests.rayTriangleParametric(ray, ...corners, false)]);
const [first] = hits.filter(([, t]) => t >= 0).sort((a, b) => a[1] - b[1]);
console.log(first ? `got: hit ${first[0]} ${first[1]}` : "got: miss");
console.log("expected: hit e3 1.0363222959938388e-21");
