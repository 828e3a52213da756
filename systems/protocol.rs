//! The question protocol: reads questions, writes answers. Not every program needs all of it.
#![allow(dead_code)]
use std::collections::HashMap;
use std::io::{BufRead, Lines, StdinLock, Write, stdin, stdout};
use std::panic::{AssertUnwindSafe, catch_unwind};

pub struct Element {
    pub tipo: String,
    pub name: String,
    pub n: Vec<f64>,
}

fn numbers<'a>(words: impl Iterator<Item = &'a str>) -> Vec<f64> {
    words.map(|word| word.parse().unwrap()).collect()
}

fn element(line: &str) -> Element {
    let mut words = line.split_whitespace();
    let mut word = || words.next().unwrap().to_string();
    Element { tipo: word(), name: word(), n: numbers(words) }
}

/// The points of triangles, each once, and of each triangle the numbers of its three points.
pub fn mesh(elements: &[Element]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let (mut points, mut numbers) = (Vec::new(), HashMap::new());
    let mut number = |n: &[f64]| {
        let point = [n[0] + 0.0, n[1] + 0.0, n[2] + 0.0]; // no -0
        *numbers.entry(point.map(f64::to_bits)).or_insert_with(|| {
            points.push(point);
            points.len() as u32 - 1
        })
    };
    let faces = elements.iter().map(|e| [number(&e.n[..3]), number(&e.n[3..6]), number(&e.n[6..])]).collect();
    (points, faces)
}

/// A miss, or a hit of the element at t.
pub fn claim(hit: Option<(usize, f64)>, elements: &[Element]) -> String {
    hit.map_or("miss".to_string(), |(i, t)| format!("hit {} {}", elements[i].name, t.to_string().to_lowercase()))
}

/// A miss, or a touch of the element at t, in a point.
pub fn touch(hit: Option<(usize, f64, [f64; 3])>, elements: &[Element]) -> String {
    let numbers = |t: f64, q: [f64; 3]| [t, q[0], q[1], q[2]].map(|x| x.to_string().to_lowercase()).join(" ");
    hit.map_or("miss".to_string(), |(i, t, q)| format!("hit {} {}", elements[i].name, numbers(t, q)))
}

fn rays(count: usize, lines: &mut Lines<StdinLock>) -> Vec<Vec<f64>> {
    lines.take(count).map(|line| numbers(line.unwrap().split_whitespace())).collect()
}

/// The answers to rays, each of an origin, a direction, and the numbers behind them.
pub type Ask = fn(&[Element], &[Vec<f64>]) -> Vec<String>;

/// Answers until the questions end.
pub fn serve(system: &str, ask: Ask) {
    serve_all(system, &[("rays ", ask)]);
}

/// The same of a system that answers other questions, too: the word before the number of rays, and what answers them.
pub fn serve_all(system: &str, asks: &[(&str, Ask)]) {
    println!("system {system}");
    let mut lines = stdin().lock().lines();
    let mut elements = Vec::new();
    while let Some(Ok(line)) = lines.next() {
        if line.starts_with("scene") {
            elements.clear();
        } else if let Some((count, ask)) = asks.iter().find_map(|(word, ask)| Some((line.strip_prefix(word)?, ask))) {
            let rays = rays(count.trim().parse().unwrap(), &mut lines);
            let refused = |_| vec!["refused it panicked".to_string(); rays.len()];
            let claims = if elements.is_empty() {
                vec!["miss".to_string(); rays.len()]
            } else {
                catch_unwind(AssertUnwindSafe(|| ask(&elements, &rays))).unwrap_or_else(refused)
            };
            println!("{}", claims.join("\n"));
            stdout().flush().unwrap();
        } else {
            elements.push(element(&line));
        }
    }
}
