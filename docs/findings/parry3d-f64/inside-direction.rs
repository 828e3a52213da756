// parry3d 0.31.1: misplaced
// Expected e1 at t = 2, point (2, 0, 2); got e1 at t = 4.071360705084288.
// From inside a cylinder the support-map algorithm mixes a length along v/|v| with a parameter of v; a ray's direction is documented as one that does not need to be normalized.
// the exact answer: e1 at t = 2
// e1:
//   t = 2
//     = 2
// the first point:
//   x = 2
//   y = 0
//   z = 2
//
// cargo new reproduce && cd reproduce && cargo add parry3d-f64@=0.31.1, with this file as src/main.rs; then cargo run
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query::Ray;
use parry3d_f64::shape::*;

fn main() {
    let names = [
        "e1",
    ];
    let parts = vec![
        (
            Pose::from_parts(
                Vector::new(4.0, 0.0, 0.0),
                Rotation::from_array([0.0, 0.0, -0.7071067811865475, 0.7071067811865475]),
            ),
            SharedShape::new(Cylinder::new(4.0, 2.0)),
        ),
    ];
    let compound = Compound::new(parts);
    let ray = Ray::new(Vector::new(0.0, 0.0, 0.0), Vector::new(1.0, 0.0, 1.0));
    match CompositeShapeRef(&compound).cast_local_ray(&ray, f64::MAX, false) {
        Some((part, t)) => println!("got: hit {} {t:?}", names[part as usize]),
        None => println!("got: miss"),
    }
    println!("expected: hit e1 2");
}
