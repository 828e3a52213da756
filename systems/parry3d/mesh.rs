//! Asks parry by the cast of a ray on one triangle mesh, in the format that the argument names: f32 or f64.
#[path = "../protocol.rs"]
mod protocol;
use protocol::{Element, claim, mesh};

macro_rules! asks {
    ($ask:ident, $parry:ident, $real:ty) => {
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
    };
}
asks!(ask_f32, parry3d, f32);
asks!(ask_f64, parry3d_f64, f64);

fn main() {
    let ask = if std::env::args().nth(1).unwrap() == "f32" { ask_f32 } else { ask_f64 };
    protocol::serve("parry3d 0.31.1 TriMesh", ask);
}
