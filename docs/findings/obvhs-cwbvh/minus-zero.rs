// obvhs 0.4.0: missed
// Expected m:804 at t = 16, point (0.75, 0, -1); got a miss.
// the exact answer: m:804 at t = 16
// m:804:
//   t = 16
//     = 16
// the first point:
//   x = 0.75
//   y = 0
//   z = -1
//
// In a project with: cargo add obvhs glam
use glam::vec3a;
use obvhs::{BvhBuildParams, cwbvh::builder::build_cwbvh_from_tris, ray::Ray, ray::RayHit, triangle::Triangle};

fn main() {
    let (mut names, mut triangles) = (Vec::new(), Vec::new());
    names.push("m:804");
    triangles.push(Triangle { v0: vec3a(0.0, 0.0, 0.0), v1: vec3a(1.0, 0.0, 0.0), v2: vec3a(1.0, 0.0, -2.0) });
    let tree = build_cwbvh_from_tris(&triangles, BvhBuildParams::medium_build(), &mut Default::default());
    let face = |i: usize| tree.primitive_indices[i] as usize;
    let ray = Ray::new_inf(vec3a(0.75, -16.0, -1.0), vec3a(-0.0, 1.0, -0.0));
    let mut hit = RayHit::none();
    if tree.ray_traverse(ray, &mut hit, |ray, i| triangles[face(i)].intersect(ray)) {
        println!("got: hit {} {:e}", names[face(hit.primitive_id as usize)], hit.t);
    } else {
        println!("got: miss");
    }
    println!("expected: hit m:804 16");
}
