//! Asks parry by the cast of a ray, or of a ball, on one triangle mesh, in the format that the argument names: f32 or
//! f64.
#[path = "../protocol.rs"]
mod protocol;
use protocol::{Ask, Element, claim, mesh, touch};

macro_rules! asks {
    ($ask:ident, $cast:ident, $parry:ident, $real:ty) => {
        fn $ask(elements: &[Element], rays: &[Vec<f64>]) -> Vec<String> {
            use $parry::math::Vector;
            use $parry::query::Ray;
            use $parry::shape::{CompositeShapeRef, TriMesh};
            let vector = |n: &[f64]| Vector::new(n[0] as $real, n[1] as $real, n[2] as $real);
            let (points, faces) = mesh(elements);
            let mesh = TriMesh::new(points.iter().map(|point| vector(point)).collect(), faces).unwrap();
            let first = |ray: &Vec<f64>| {
                let ray = Ray::new(vector(&ray[..3]), vector(&ray[3..]));
                let hit = CompositeShapeRef(&mesh).cast_local_ray(&ray, <$real>::MAX, false);
                claim(hit.map(|(face, t)| (face as usize, t as f64)), elements)
            };
            rays.iter().map(first).collect()
        }
        fn $cast(elements: &[Element], rays: &[Vec<f64>]) -> Vec<String> {
            use $parry::math::{Pose, Vector};
            use $parry::query::{DefaultQueryDispatcher, ShapeCastOptions};
            use $parry::shape::{Ball, CompositeShapeRef, TriMesh};
            let vector = |n: &[f64]| Vector::new(n[0] as $real, n[1] as $real, n[2] as $real);
            let (points, faces) = mesh(elements);
            let mesh = TriMesh::new(points.iter().map(|point| vector(point)).collect(), faces).unwrap();
            let first = |ray: &Vec<f64>| {
                let (pose, ball) = (Pose::from_translation(vector(&ray[..3])), Ball::new(ray[6] as $real));
                let options = ShapeCastOptions::with_max_time_of_impact(<$real>::MAX);
                let way = vector(&ray[3..6]);
                let hit = CompositeShapeRef(&mesh).cast_shape(&DefaultQueryDispatcher, &pose, way, &ball, options);
                touch(hit.map(|(face, hit)| {
                    let q = hit.witness1;
                    (face as usize, hit.time_of_impact as f64, [q.x as f64, q.y as f64, q.z as f64])
                }), elements)
            };
            rays.iter().map(first).collect()
        }
    };
}
asks!(ask_f32, cast_f32, parry3d, f32);
asks!(ask_f64, cast_f64, parry3d_f64, f64);

fn main() {
    let is_f32 = std::env::args().nth(1).unwrap() == "f32";
    let (ask, cast): (Ask, Ask) = if is_f32 { (ask_f32, cast_f32) } else { (ask_f64, cast_f64) };
    protocol::serve_all("parry3d 0.31.1 TriMesh", &[("rays ", ask), ("casts ", cast)]);
}
