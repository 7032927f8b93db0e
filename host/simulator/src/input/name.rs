//! Paths as text, whatever their bytes: a name stands for a file in scenes, errors and summaries.
//!
//! Where a path is not Unicode, each byte b that is not stands in its name as the private character U+10FE00 + b, and
//! is that byte again where the file is opened.

use std::path::{Path, PathBuf};

/// Where the bytes stand.
const FIRST: u32 = 0x10_FE00;

/// The name of a path.
pub fn name_of(path: &Path) -> String {
    let mut name = String::new();
    for chunk in path.as_os_str().as_encoded_bytes().utf8_chunks() {
        name.push_str(chunk.valid());
        let strange = chunk.invalid().iter();
        name.extend(strange.filter_map(|&byte| char::from_u32(FIRST + u32::from(byte))));
    }
    name
}

/// The path of a name.
pub fn path_of(name: &str) -> PathBuf {
    #[cfg(unix)]
    if name.chars().any(|c| byte(c).is_some()) {
        use std::os::unix::ffi::OsStringExt;
        let mut bytes = Vec::with_capacity(name.len());
        for character in name.chars() {
            match byte(character) {
                Some(byte) => bytes.push(byte),
                None => bytes.extend(character.encode_utf8(&mut [0; 4]).bytes()),
            }
        }
        return std::ffi::OsString::from_vec(bytes).into();
    }
    PathBuf::from(name)
}

#[cfg(unix)]
fn byte(character: char) -> Option<u8> {
    let byte = u32::from(character).checked_sub(FIRST)?;
    u8::try_from(byte).ok().filter(|byte| *byte >= 0x80)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    #[test]
    fn every_path_comes_back() {
        let all: Vec<u8> = (1..=255).collect();
        for bytes in [
            b"plain/scene.toml".as_slice(),
            "Flüge/Ω.csv".as_bytes(),
            b"caf\xe9/\xff\xfe.csv",
            &all,
        ] {
            let path = Path::new(OsStr::from_bytes(bytes));
            assert_eq!(path_of(&name_of(path)), path);
        }
        assert_eq!(name_of(Path::new("Ω.csv")), "Ω.csv");
    }
}
