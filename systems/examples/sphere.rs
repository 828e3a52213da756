use std::io::{stdin, stdout, Write}; // A system that knows spheres: it reads the rays of `durero conform run`, writes hits.

fn main() {
    let mut spheres: Vec<(String, Vec<f64>)> = vec![];
    println!("system example-rust 1");
    for line in stdin().lines().map(|line| line.unwrap()) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let numbers = |from: usize| -> Vec<f64> { words[from..].iter().map(|w| w.parse().unwrap()).collect() };
        match words[0] {
            "scene" => spheres.clear(),
            "esfera" => spheres.push((words[1].to_string(), numbers(2))),
            "rays" => {}
            _ => {
                let (x, mut nearest, mut answer) = (numbers(0), f64::INFINITY, "miss".to_string());
                for (name, s) in &spheres {
                    let q: Vec<f64> = (0..3).map(|i| x[i] - s[i]).collect();
                    let dot = |f: &dyn Fn(usize) -> f64| (0..3).map(f).sum::<f64>();
                    let (a, b, c) = (dot(&|i| x[3 + i] * x[3 + i]), dot(&|i| q[i] * x[3 + i]), dot(&|i| q[i] * q[i]) - s[3] * s[3]);
                    for side in [-1.0, 1.0] {
                        let t = (-b + side * (b * b - a * c).sqrt()) / a; // NaN where there is no root
                        if t > 0.0 && t < nearest { nearest = t; answer = format!("hit {name} {t:?}"); }
                    }
                }
                println!("{answer}");
            }
        }
        stdout().flush().unwrap();
    }
}
