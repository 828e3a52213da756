//! Asks parry by the cast of a ray, or of a ball, on a compound of the elements, in the format that the argument names:
//! f32 or f64.
#[path = "../protocol.rs"]
mod protocol;
use protocol::{Ask, Element, touch};

/// x, y, z and w of the least rotation that takes the y axis, which is that of parry's shapes, to the vector.
fn quaternion(v: &[f64]) -> [f64; 4] {
    let (x, y, z) = (v[0], v[1], v[2]);
    let w = if y > 0.0 { 1.0 + y } else { (x * x + z * z) / (1.0 - y) };
    if w == 0.0 {
        return [1.0, 0.0, 0.0, 0.0];
    }
    let length = (x * x + z * z + w * w).sqrt();
    [z / length, 0.0, -x / length, w / length]
}

macro_rules! asks {
    ($ask:ident, $cast:ident, $compound:ident, $parry:ident, $real:ty) => {
        fn $compound(elements: &[Element]) -> $parry::shape::Compound {
            use $parry::math::{Pose, Rotation, Vector};
            use $parry::shape::{Ball, Compound, Cone, Cylinder, HalfSpace, SharedShape, Triangle};
            let vector = |n: &[f64]| Vector::new(n[0] as $real, n[1] as $real, n[2] as $real);
            let placed = |e: &Element| {
                let n = &e.n;
                let upright = |half: f64| {
                    let middle: Vec<f64> = (0..3).map(|i| n[i] + half * n[i + 3]).collect();
                    let q = quaternion(&n[3..6]).map(|x| x as $real);
                    Pose::from_parts(vector(&middle), Rotation::from_array(q))
                };
                match e.tipo.as_str() {
                    "esfera" => (Pose::from_translation(vector(n)), SharedShape::new(Ball::new(n[3] as $real))),
                    "cilindro" => {
                        let half = n[7] / 2.0;
                        (upright(half), SharedShape::new(Cylinder::new(half as $real, n[6] as $real)))
                    }
                    "cono" => {
                        let (half, radius) = (n[7] / 2.0, n[6] * n[7]);
                        (upright(half), SharedShape::new(Cone::new(half as $real, radius as $real)))
                    }
                    "plano" => (Pose::from_translation(vector(n)), SharedShape::new(HalfSpace::new(vector(&n[3..6])))),
                    "triangulo" => {
                        let triangle = Triangle::new(vector(n), vector(&n[3..6]), vector(&n[6..9]));
                        (Pose::IDENTITY, SharedShape::new(triangle))
                    }
                    tipo => panic!("no {tipo}"),
                }
            };
            Compound::new(elements.iter().map(placed).collect())
        }
        fn $ask(elements: &[Element], rays: &[Vec<f64>]) -> Vec<String> {
            use $parry::math::Vector;
            use $parry::query::Ray;
            use $parry::shape::CompositeShapeRef;
            let vector = |n: &[f64]| Vector::new(n[0] as $real, n[1] as $real, n[2] as $real);
            let compound = $compound(elements);
            let first = |ray: &Vec<f64>| {
                let ray = Ray::new(vector(&ray[..3]), vector(&ray[3..]));
                match CompositeShapeRef(&compound).cast_local_ray(&ray, <$real>::MAX, false) {
                    Some((part, t)) => format!("hit {} {}", elements[part as usize].name, t.to_string().to_lowercase()),
                    None => "miss".to_string(),
                }
            };
            rays.iter().map(first).collect()
        }
        fn $cast(elements: &[Element], rays: &[Vec<f64>]) -> Vec<String> {
            use $parry::math::{Pose, Vector};
            use $parry::query::{DefaultQueryDispatcher, ShapeCastOptions};
            use $parry::shape::{Ball, CompositeShapeRef};
            let vector = |n: &[f64]| Vector::new(n[0] as $real, n[1] as $real, n[2] as $real);
            let compound = $compound(elements);
            let first = |ray: &Vec<f64>| {
                let (pose, ball) = (Pose::from_translation(vector(&ray[..3])), Ball::new(ray[6] as $real));
                let options = ShapeCastOptions::with_max_time_of_impact(<$real>::MAX);
                let way = vector(&ray[3..6]);
                let hit = CompositeShapeRef(&compound).cast_shape(&DefaultQueryDispatcher, &pose, way, &ball, options);
                touch(hit.map(|(part, hit)| {
                    let q = hit.witness1;
                    (part as usize, hit.time_of_impact as f64, [q.x as f64, q.y as f64, q.z as f64])
                }), elements)
            };
            rays.iter().map(first).collect()
        }
    };
}
asks!(ask_f32, cast_f32, compound_f32, parry3d, f32);
asks!(ask_f64, cast_f64, compound_f64, parry3d_f64, f64);

fn main() {
    let is_f32 = std::env::args().nth(1).unwrap() == "f32";
    let (ask, cast): (Ask, Ask) = if is_f32 { (ask_f32, cast_f32) } else { (ask_f64, cast_f64) };
    protocol::serve_all("parry3d 0.31.1", &[("rays ", ask), ("casts ", cast)]);
}
