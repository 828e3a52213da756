//! The question protocol: reads questions, writes answers.
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

fn rays(count: usize, lines: &mut Lines<StdinLock>) -> Vec<Vec<f64>> {
    lines.take(count).map(|line| numbers(line.unwrap().split_whitespace())).collect()
}

/// Answers until the questions end.
pub fn serve(system: &str, ask: fn(&[Element], &[Vec<f64>]) -> Vec<String>) {
    println!("system {system}");
    let mut lines = stdin().lock().lines();
    let mut elements = Vec::new();
    while let Some(Ok(line)) = lines.next() {
        if line.starts_with("scene") {
            elements.clear();
        } else if let Some(count) = line.strip_prefix("rays ") {
            let rays = rays(count.trim().parse().unwrap(), &mut lines);
            let refused = |_| vec!["refused it panicked".to_string(); rays.len()];
            let claims = catch_unwind(AssertUnwindSafe(|| ask(&elements, &rays))).unwrap_or_else(refused);
            println!("{}", claims.join("\n"));
            stdout().flush().unwrap();
        } else {
            elements.push(element(&line));
        }
    }
}
