// SPDX-License-Identifier: Apache-2.0
//! Runs the starter vectors against your function: `rustc run.rs && ./run`, with your controller in the place of example.rs.
//! It defines `SECTIONS` and `NEEDS`, which name what it knows, and `your_function`, which says where the axes go at the end
//! of each move, in the order of `vector.axes`, and the alarm if one ends the program.
//! Exit status: 0 all agree, 1 one does not, or nothing was compared.

use std::collections::HashMap;

mod example;

const VECTORS: &str = include_str!("../../starter.csv");

/// A row of starter.csv. `settings` has offsets, parameters and the tool by name: D1, H1.wear, 5003#0, R2.
pub struct Vector {
    pub text: HashMap<String, String>,
    pub axes: Vec<char>,
    pub program: Vec<String>,
    pub settings: HashMap<String, f64>,
}

/// What the controller says: points, and the line and the number or cause of an alarm.
pub struct Answer {
    pub points: Vec<Vec<f64>>,
    pub alarm: Option<(usize, String)>,
}

/// Fields of a CSV text in quotes, a row of them after the other.
fn rows(text: &str) -> Vec<Vec<String>> {
    let (mut rows, mut row, mut field, mut quoted) = (Vec::new(), Vec::new(), String::new(), false);
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => field.push(letters.next().unwrap()),
            '"' => quoted = !quoted,
            ',' if !quoted => row.push(std::mem::take(&mut field)),
            '\n' if !quoted => {
                row.push(std::mem::take(&mut field));
                rows.push(std::mem::take(&mut row));
            }
            _ => field.push(letter),
        }
    }
    rows
}

fn vector(names: &[String], row: &[String]) -> Vector {
    let text: HashMap<String, String> = names.iter().cloned().zip(row.iter().cloned()).collect();
    let pairs = ["offsets", "parameters", "tool"].iter().flat_map(|name| text[*name].split_whitespace());
    let settings = pairs.map(|pair| pair.split_once('=').unwrap()).map(|(name, value)| (name.to_string(), value.parse().unwrap())).collect();
    Vector { axes: text["axes"].chars().collect(), program: text["program"].lines().map(String::from).collect(), settings, text }
}

fn shown(axes: &[char], point: Option<&Vec<f64>>) -> String {
    let round = |value: &f64| (value * 1e8).round() / 1e8;
    point.map_or("nothing".into(), |point| axes.iter().zip(point).map(|(axis, value)| format!("{axis}{}", round(value))).collect::<Vec<_>>().join(" "))
}

/// The first thing that is not as expected; none where all agrees.
fn difference(vector: &Vector, answer: &Answer) -> Option<String> {
    let tolerance: f64 = vector.text["tolerance"].parse().unwrap();
    let wanted: Vec<Vec<&str>> = vector.text["points"].split("; ").map(|point| point.split(' ').collect()).collect();
    for index in 0..wanted.len().max(answer.points.len()) {
        let want: Option<Vec<f64>> = wanted.get(index).map(|words| words[2..].iter().map(|word| word[1..].parse().unwrap()).collect());
        let got = answer.points.get(index);
        // A NaN compares with nothing, so it does not agree.
        let agrees = matches!((&want, got), (Some(want), Some(got)) if want.len() == got.len() && want.iter().zip(got).all(|(w, g)| (g - w).abs() <= tolerance));
        if !agrees {
            let line = wanted.get(index).map_or(String::new(), |words| format!(", line {}", words[0]));
            return Some(format!("point {}{line}: expected {}, got {}", index + 1, shown(&vector.axes, want.as_ref()), shown(&vector.axes, got)));
        }
    }
    let (line, number, cause) = (&vector.text["alarm_line"], &vector.text["alarm_number"], &vector.text["alarm_cause"]);
    let agrees = match &answer.alarm {
        None => line.is_empty(),
        Some((at, name)) => *line == at.to_string() && (name == number || name == cause),
    };
    (!agrees).then(|| format!("alarm: expected {line} {number} ({cause}), got {:?}", answer.alarm))
}

fn main() {
    let rows = rows(VECTORS);
    let (mut agreed, mut failed) = (0, 0);
    for row in &rows[1..] {
        let vector = vector(&rows[0], row);
        let text = &vector.text;
        if !example::SECTIONS.contains(&text["section"].as_str()) || !text["needs"].split_whitespace().all(|need| example::NEEDS.contains(&need)) {
            continue;
        }
        match difference(&vector, &example::your_function(&vector)) {
            None => agreed += 1,
            Some(wrong) => {
                failed += 1;
                println!("FAILED {}: {}\n  mistake: {}\n  {wrong}\n  see {}", text["name"], text["shows"], text["catches"], text["picture"]);
            }
        }
    }
    println!("{agreed} vectors agree, {failed} do not, {} skipped: their section or a need is not named", rows.len() - 1 - agreed - failed);
    std::process::exit(i32::from(agreed == 0 || failed > 0));
}
