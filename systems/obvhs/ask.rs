//! Asks obvhs by ray_traverse of the tree that the argument names, cwbvh or bvh2, and Triangle::intersect.
#[path = "../protocol.rs"]
mod protocol;
use glam::{Vec3A, vec3a};
use obvhs::{
    BvhBuildParams,
    bvh2::builder::build_bvh2_from_tris,
    cwbvh::builder::build_cwbvh_from_tris,
    ray::{Ray, RayHit},
    triangle::Triangle,
};
use protocol::{Element, claim};
use std::time::Duration;

fn vector(n: &[f64]) -> Vec3A {
    vec3a(n[0] as f32, n[1] as f32, n[2] as f32)
}

macro_rules! asks {
    ($ask:ident, $build:ident) => {
        fn $ask(elements: &[Element], rays: &[Vec<f64>]) -> Vec<String> {
            let triangle = |e: &Element| Triangle { v0: vector(&e.n), v1: vector(&e.n[3..]), v2: vector(&e.n[6..]) };
            let triangles: Vec<Triangle> = elements.iter().map(triangle).collect();
            let tree = $build(&triangles, BvhBuildParams::medium_build(), &mut Duration::default());
            let face = |i: usize| tree.primitive_indices[i] as usize;
            let first = |ray: &Vec<f64>| {
                let ray = Ray::new_inf(vector(&ray[..3]), vector(&ray[3..]));
                let mut hit = RayHit::none();
                let is_hit = tree.ray_traverse(ray, &mut hit, |ray, i| triangles[face(i)].intersect(ray));
                claim(is_hit.then(|| (face(hit.primitive_id as usize), hit.t as f64)), elements)
            };
            rays.iter().map(first).collect()
        }
    };
}
asks!(ask_cwbvh, build_cwbvh_from_tris);
asks!(ask_bvh2, build_bvh2_from_tris);

fn main() {
    let is_wide = std::env::args().nth(1).unwrap() == "cwbvh";
    protocol::serve("obvhs 0.4.0", if is_wide { ask_cwbvh } else { ask_bvh2 });
}
