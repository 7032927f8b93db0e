//! Parts that are damaged, incomplete or of another ensemble are refused, with what is wrong and where.

use super::shards::{SCENE, done, schuler};
use std::fs;
use std::path::Path;

/// The words of a command that is refused.
fn refused(folder: &Path, line: &str) -> String {
    let done = schuler(folder, line);
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(2), "{line}: {said}");
    said
}

fn says(said: &str, words: &[&str]) {
    for word in words {
        assert!(said.contains(word), "{word}: {said}");
    }
}

const WHOLE: &str = "ensemble scene.toml --runs 24";

/// A folder with the scene, and its ensemble in three parts of two blocks each.
fn parts() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.toml"), SCENE.replace("saturation_deg_s = 41.8\n", ""))
        .unwrap();
    for k in 1..=3 {
        done(folder.path(), &format!("{WHOLE} --shard {k}/3 --batch 4 --out p"));
    }
    folder
}

const ALL: &str = "p/shard-1-of-3.part p/shard-2-of-3.part p/shard-3-of-3.part";

#[test]
fn a_damaged_byte_is_found_wherever_it_is() {
    let folder = parts();
    let part = folder.path().join("p/shard-2-of-3.part");
    let bytes = fs::read(&part).unwrap();
    let merge = format!("ensemble merge {ALL} --out m");
    let first = bytes.iter().position(|&byte| byte == b'\n').unwrap() + 1;
    let mut places: Vec<usize> = (0..bytes.len()).step_by(bytes.len() / 40).collect();
    places.extend([first - 1, first, first + 8, bytes.len() - 2, bytes.len() - 1]);
    for place in places {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x04;
        fs::write(&part, &damaged).unwrap();
        let said = refused(folder.path(), &merge);
        assert!(said.contains("p/shard-2-of-3.part: "), "{place}: {said}");
        if place >= first && !said.contains("ends in the block") {
            let block = said.contains("in the block of run 8, at byte ")
                || said.contains("in the block of run 12, at byte ");
            assert!(block, "{place}: {said}");
        }
    }
    // In the middle of a block: its first run and where it begins.
    let mut damaged = bytes.clone();
    let middle = first + (bytes.len() - first) / 4;
    damaged[middle] ^= 1;
    fs::write(&part, &damaged).unwrap();
    let said = refused(folder.path(), &merge);
    let place =
        format!("is damaged in the block of run 8, at byte {first}: its bytes have another");
    says(&said, &[&place, "SHA-256"]);
    // It is not gone on with either.
    let said = refused(folder.path(), &format!("{WHOLE} --shard 2/3 --resume --out p"));
    says(&said, &[&place]);
    assert!(fs::read(&part).unwrap() == damaged, "it was changed");
}

#[test]
fn what_is_missing_doubled_or_cut_is_said() {
    let folder = parts();
    let at = |name: &str| folder.path().join(name);
    let merge = |parts: &str| refused(folder.path(), &format!("ensemble merge {parts} --out m"));
    let said = merge("p/shard-1-of-3.part p/shard-3-of-3.part");
    says(&said, &["PART: of 3 shards there is no shard 2; accepted: all shards of an ensemble"]);
    fs::copy(at("p/shard-1-of-3.part"), at("copy.part")).unwrap();
    let said = merge(&format!("{ALL} copy.part"));
    says(&said, &["copy.part: is shard 1 of 3, and so is p/shard-1-of-3.part", "each shard once"]);
    let whole = fs::read(at("p/shard-3-of-3.part")).unwrap();
    fs::write(at("p/shard-3-of-3.part"), &whole[..whole.len() - 100]).unwrap();
    let said = merge(ALL);
    says(&said, &["p/shard-3-of-3.part: ends in the block of run 20, at byte "]);
    says(
        &said,
        &["it holds 4 of 8 runs of shard 3 of 3", "--shard 3/3 --resume --out p` makes of it"],
    );
    // At the end of a block.
    let end = whole.len() - (whole.len() - first_line(&whole)) / 2;
    fs::write(at("p/shard-3-of-3.part"), &whole[..block_end(&whole, end)]).unwrap();
    says(&merge(ALL), &["p/shard-3-of-3.part: holds 4 of 8 runs of shard 3 of 3"]);
    fs::write(at("p/shard-3-of-3.part"), "").unwrap();
    says(&merge(ALL), &["p/shard-3-of-3.part: is no part of an ensemble: it is empty"]);
    fs::write(at("p/shard-3-of-3.part"), SCENE).unwrap();
    says(&merge(ALL), &["its first line is not JSON", "a file of `schuler ensemble --shard`"]);
    let text =
        String::from_utf8_lossy(&whole[..first_line(&whole)]).replace("\"form\":1", "\"form\":2");
    fs::write(at("p/shard-3-of-3.part"), text).unwrap();
    says(&merge(ALL), &["has the form 2 of another version; accepted: 1"]);
    assert!(!at("m").exists());
    says(&merge("nowhere.part"), &["nowhere.part: cannot be read"]);
}

fn first_line(bytes: &[u8]) -> usize {
    bytes.iter().position(|&byte| byte == b'\n').unwrap() + 1
}

/// The end of the block before a place: behind the line of its checksum.
fn block_end(bytes: &[u8], near: usize) -> usize {
    let is_sum = |end: &usize| {
        let line = &bytes[end - 65..*end];
        line[64] == b'\n' && line[..64].iter().all(u8::is_ascii_hexdigit)
    };
    (first_line(bytes) + 65..near + 200).rev().find(is_sum).unwrap()
}

#[test]
fn parts_of_other_ensembles_are_told_apart() {
    let folder = parts();
    let path = folder.path();
    let merge = |other: &str| {
        let parts = format!("p/shard-1-of-3.part {other} p/shard-3-of-3.part");
        refused(path, &format!("ensemble merge {parts} --out m"))
    };
    fs::write(path.join("other.toml"), format!("{SCENE}# another text\n")).unwrap();
    for (line, words) in [
        ("ensemble other.toml --runs 24 --shard 2/3", "its scene is other (SHA-256 "),
        ("ensemble scene.toml --runs 24 --seed 6 --shard 2/3", "its seed is 6, here 5"),
        ("ensemble scene.toml --runs 25 --shard 2/3", "it has runs in all: 25, here 24"),
        ("ensemble scene.toml --runs 24 --shard 2/4", "its shards are 4, here 3"),
        ("ensemble scene.toml --runs 24 --rate 40 --shard 2/3", "other options or other files"),
        (
            "ensemble scene.toml --runs 24 --window 2,4,2 --shard 2/3",
            "other options or other files",
        ),
        ("ensemble scene.toml --runs 24 --at 3 --shard 2/3", "it is read at samples [28, 52, 80]"),
    ] {
        done(path, &format!("{line} --out q"));
        let name = line.split_whitespace().last().unwrap().replace('/', "-of-");
        let said = merge(&format!("q/shard-{name}.part"));
        says(&said, &[&format!("q/shard-{name}.part: is of another ensemble: "), words]);
        fs::remove_dir_all(path.join("q")).unwrap();
    }
    // Nor does a part go on with other options than it was begun with.
    let said = refused(path, "ensemble scene.toml --runs 24 --seed 7 --shard 2/3 --resume --out p");
    says(&said, &["its seed is 5, here 7", "the options that it was begun with"]);
    // The scene has changed, or is elsewhere.
    let text = fs::read_to_string(path.join("scene.toml")).unwrap();
    fs::rename(path.join("scene.toml"), path.join("moved.toml")).unwrap();
    let said = refused(path, &format!("ensemble merge {ALL} --out m"));
    says(&said, &["was flown with a scene that cannot be read here", "--scene"]);
    done(path, &format!("ensemble merge {ALL} --scene moved.toml --out m"));
    fs::write(path.join("moved.toml"), text.replace("amplitude = 20", "amplitude = 21")).unwrap();
    let said = refused(path, &format!("ensemble merge {ALL} --scene moved.toml --out n"));
    says(&said, &["is of another ensemble: its scene is scene (SHA-256 ", "here moved (SHA-256 "]);
    assert!(!path.join("n").exists());
}

#[test]
fn options_that_do_not_go_together_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (line, words) in [
        ("ensemble --shard 0/3", ["is no shard", "K/N with K from 1 to N"]),
        ("ensemble --shard 4/3", ["is no shard", "3/8"]),
        ("ensemble --shard 3", ["is no shard", "3/8"]),
        ("ensemble --runs 8 --shard 1/9", ["of 8 runs there are no 9 shards", "N up to 8"]),
        ("ensemble --shard 1/2 --keep", ["--shard", "--keep"]),
        ("ensemble --shard 1/2 --budget", ["--shard", "--budget"]),
        ("ensemble --at 0", ["--at", "is neither a number of times nor times"]),
        ("ensemble --at 5s,x", ["--at", "60s,600s"]),
        ("ensemble --at 5s,9999s", ["9999 s is after the end", "times up to 1800 s"]),
        ("ensemble --threads 0", ["--threads", "an integer from 1 to 1024"]),
        ("ensemble --batch 0", ["--batch", "an integer from 1 up"]),
        ("ensemble merge", ["PART", "required"]),
        ("ensemble merge --shard 1/2", ["--shard", "unexpected"]),
        ("run --run -1", ["--run", "is not the number of a run"]),
    ] {
        let said = refused(folder.path(), line);
        says(&said, &words);
        assert!(!folder.path().join("out").exists(), "{line}");
    }
}
