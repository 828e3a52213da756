// A system that knows spheres: it reads the rays of `durero conform run` and writes its hits.
use std::io::{stdin, stdout, Write};

fn main() {
    let mut spheres: Vec<(String, Vec<f64>)> = vec![]; // name, centre and radius
    println!("system example-rust 1");
    for line in stdin().lines().map(Result::unwrap) {
        let words: Vec<&str> = line.split(' ').collect();
        let numbers = |from| words[from..].iter().map(|w: &&str| w.parse().unwrap()).collect();
        match words[0] {
            "scene" => spheres.clear(),
            "esfera" => spheres.push((words[1].to_string(), numbers(2))),
            "rays" => {}
            _ => {
                let (x, mut nearest): (Vec<f64>, _) = (numbers(0), (f64::INFINITY, ""));
                for (name, s) in &spheres {
                    let sum = |f: &dyn Fn(usize) -> f64| (0..3).map(f).sum::<f64>();
                    let (a, b) = (sum(&|i| x[3 + i].powi(2)), sum(&|i| (x[i] - s[i]) * x[3 + i]));
                    let c = sum(&|i| (x[i] - s[i]).powi(2)) - s[3] * s[3];
                    for root in [-(b * b - a * c).sqrt(), (b * b - a * c).sqrt()] {
                        let t = (root - b) / a; // NaN where there is no root
                        if t > 0.0 && t < nearest.0 { nearest = (t, name) }
                    }
                }
                let (t, name) = nearest;
                println!("{}", if name.is_empty() { "miss".into() } else { format!("hit {name} {t:?}") });
            }
        }
        stdout().flush().unwrap();
    }
}
