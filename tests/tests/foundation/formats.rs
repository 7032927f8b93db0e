//! Every public type of the core can be logged by defmt.

use std::fs;
use std::path::{Path, PathBuf};

fn sources(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, into);
        } else {
            into.push(path);
        }
    }
}

#[test]
fn every_public_type_has_a_format() {
    let mut files = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../core/src"), &mut files);
    let mut types = 0;
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        for (n, line) in lines.iter().enumerate() {
            let Some(rest) =
                line.strip_prefix("pub struct ").or_else(|| line.strip_prefix("pub enum "))
            else {
                continue;
            };
            types += 1;
            let name = rest.split(|c: char| !c.is_alphanumeric()).next().unwrap();
            let above = lines[..n].iter().rev().take_while(|line| line.starts_with(['#', '/']));
            let derived = above.into_iter().any(|line| line.contains("defmt::Format"));
            let by_hand = text.contains(&format!("defmt::Format for {name}"));
            assert!(derived || by_hand, "{}: {name}", file.display());
        }
    }
    assert!(types > 80, "{types}");
}
