//! A file appears when it is complete, or not at all.

use super::{scratch, text};
use schuler_simulator::output::{NumberTable, OutputFile, write};
use std::fs;
use std::io::Write;

#[test]
fn an_unfinished_file_leaves_the_old_one() {
    let folder = scratch();
    let path = folder.path().join("out.csv");
    fs::write(&path, "old").expect("the disk has room");
    let mut file = OutputFile::create(&path).expect("the folder is there");
    file.write_all(b"half").expect("the disk has room");
    file.flush().expect("the disk has room");
    drop(file);
    assert_eq!(fs::read_to_string(&path).expect("it is there"), "old");
    assert_eq!(fs::read_dir(folder.path()).expect("it is there").count(), 1, "no rest remains");

    let mut file = OutputFile::create(&path).expect("the folder is there");
    file.write_all(b"new").expect("the disk has room");
    assert_eq!(fs::read_to_string(&path).expect("it is there"), "old", "until it is finished");
    file.finish().expect("the disk has room");
    assert_eq!(fs::read_to_string(&path).expect("it is there"), "new");
    assert_eq!(fs::read_dir(folder.path()).expect("it is there").count(), 1);
}

#[test]
fn missing_folders_are_made() {
    let folder = scratch();
    let path = folder.path().join("a/b/c.txt");
    write(&path, "text").expect("the disk has room");
    assert_eq!(fs::read_to_string(&path).expect("it is there"), "text");
}

#[cfg(unix)]
#[test]
fn others_may_read_it_as_any_file() {
    use std::os::unix::fs::PermissionsExt;
    let folder = scratch();
    let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
    write(&ours, "").expect("the disk has room");
    fs::write(&plain, "").expect("the disk has room");
    let mode = |path| fs::metadata(path).expect("it is there").permissions().mode();
    assert_eq!(mode(&ours), mode(&plain));
}

#[cfg(unix)]
#[test]
fn a_device_is_written_in_place() {
    write("/dev/null", "text").expect("it takes everything");
    assert!(!fs::metadata("/dev/null").expect("it is still there").is_file());
}

#[cfg(unix)]
#[test]
fn a_link_stays_and_its_target_is_written() {
    use std::os::unix::fs::symlink;
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("elsewhere")).expect("the disk has room");
    fs::write(at("elsewhere/old"), "old").expect("the disk has room");
    symlink("elsewhere/old", at("link")).expect("links can be made");
    symlink(at("link"), at("second")).expect("links can be made");
    symlink("elsewhere/new", at("dangling")).expect("links can be made");
    for (link, target) in [("second", "elsewhere/old"), ("dangling", "elsewhere/new")] {
        write(at(link), link).expect("the disk has room");
        assert_eq!(fs::read_to_string(at(target)).expect("it is there"), link);
        assert!(fs::symlink_metadata(at(link)).expect("it is there").is_symlink(), "{link}");
    }
    symlink("b", at("a")).expect("links can be made");
    symlink("a", at("b")).expect("links can be made");
    let error = write(at("a"), "").expect_err("it leads nowhere").to_string();
    assert!(error.contains("cannot be written"), "{error}");
    symlink("/dev/null", at("device")).expect("links can be made");
    write(at("device"), "text").expect("it takes everything");
    assert!(fs::symlink_metadata(at("device")).expect("it is there").is_symlink());
}

#[test]
fn folders_made_for_a_file_that_is_not_finished_go_again() {
    let folder = scratch();
    let path = folder.path().join("a/b/c.txt");
    let first = OutputFile::create(&path).expect("folders can be made");
    let second = OutputFile::create(folder.path().join("a/d.txt")).expect("folders can be made");
    drop(first);
    second.fill("text").expect("the disk has room");
    assert!(!folder.path().join("a/b").exists());
    assert!(folder.path().join("a/d.txt").is_file());
    drop(OutputFile::create(folder.path().join("e/f/g.txt")).expect("folders can be made"));
    assert!(!folder.path().join("e").exists());
}

#[test]
fn a_folder_in_its_place_is_an_error() {
    let folder = scratch();
    let error = OutputFile::create(folder.path()).expect_err("it is a folder").to_string();
    assert!(
        error.starts_with(text(folder.path())) && error.contains("cannot be written"),
        "{error}"
    );
}

#[test]
fn numbers_keep_their_bits() {
    let folder = scratch();
    let path = folder.path().join("n.csv");
    let numbers = [0.1 + 0.2, -0.0, 1e-310, f64::MAX, 5e-324, 1.0 / 3.0, 123456789.0];
    let mut table = NumberTable::create(&path, &["a", "b", "c", "d", "e", "f", "g"]).expect("fine");
    table.row(&numbers).expect("the disk has room");
    table.finish().expect("the disk has room");
    let written = fs::read_to_string(&path).expect("it is there");
    let (header, row) = written.split_once('\n').expect("two lines");
    assert_eq!(header, "a,b,c,d,e,f,g");
    let again: Vec<f64> = row.trim_end().split(',').map(|n| n.parse().expect("a number")).collect();
    assert_eq!(again.len(), numbers.len());
    assert!(again.iter().zip(numbers).all(|(a, b)| a.to_bits() == b.to_bits()), "{row}");
}
