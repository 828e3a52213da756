//! Asks the crate bvh by Bvh::traverse and Ray::intersects_triangle, of which the least distance counts.
#[path = "../protocol.rs"]
mod protocol;
use bvh::{
    aabb::{Aabb, Bounded},
    bounding_hierarchy::BHShape,
    bvh::Bvh,
    ray::Ray,
};
use nalgebra::{Point3, Vector3};
use protocol::{Element, claim};

struct Triangle {
    corners: [Point3<f64>; 3],
    element: usize,
    node: usize,
}

impl Bounded<f64, 3> for Triangle {
    fn aabb(&self) -> Aabb<f64, 3> {
        self.corners.iter().fold(Aabb::empty(), |all, corner| all.grow(corner))
    }
}

impl BHShape<f64, 3> for Triangle {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }
    fn bh_node_index(&self) -> usize {
        self.node
    }
}

fn ask(elements: &[Element], rays: &[Vec<f64>]) -> Vec<String> {
    let corner = |e: &Element, i: usize| Point3::new(e.n[i], e.n[i + 1], e.n[i + 2]);
    let triangle = |(element, e)| Triangle { corners: [0, 3, 6].map(|i| corner(e, i)), element, node: 0 };
    let mut triangles: Vec<Triangle> = elements.iter().enumerate().map(triangle).collect();
    let tree = Bvh::build(&mut triangles);
    let first = |r: &Vec<f64>| {
        let ray = Ray::new(Point3::new(r[0], r[1], r[2]), Vector3::new(r[3], r[4], r[5]));
        let hit = |triangle: &&Triangle| {
            let [a, b, c] = &triangle.corners;
            (triangle.element, ray.intersects_triangle(a, b, c).distance)
        };
        let hits = tree.traverse(&ray, &triangles).iter().map(hit).filter(|(_, t)| t.is_finite()).collect::<Vec<_>>();
        claim(hits.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)), elements)
    };
    rays.iter().map(first).collect()
}

fn main() {
    protocol::serve("bvh 0.13.0", ask);
}
