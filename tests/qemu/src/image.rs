//! A linked image: its sizes, its symbols, and words that a test sets otherwise.

use object::{Object as _, ObjectSection as _, ObjectSymbol as _};
use std::path::{Path, PathBuf};

/// An ELF image.
#[derive(Clone, Debug)]
pub struct Image {
    /// Where it was read from.
    pub path: PathBuf,
    /// The whole file.
    pub bytes: Vec<u8>,
}

impl Image {
    /// Reads a file.
    pub fn read(path: &Path) -> Result<Self, String> {
        let bytes = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let image = Self { path: path.to_owned(), bytes };
        image.elf()?;
        Ok(image)
    }

    /// Its name.
    pub fn name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    fn elf(&self) -> Result<object::File<'_>, String> {
        object::File::parse(&*self.bytes).map_err(|error| self.complain(&error.to_string()))
    }

    fn complain(&self, what: &str) -> String {
        format!("{}: {what}", self.path.display())
    }

    /// Bytes in the sections of these names.
    pub fn size(&self, sections: &[&str]) -> Result<u64, String> {
        let elf = self.elf()?;
        let wanted = elf.sections().filter(|s| s.name().is_ok_and(|name| sections.contains(&name)));
        Ok(wanted.map(|section| section.size()).sum())
    }

    /// Bytes of what has such a name.
    pub fn size_of(&self, is_meant: impl Fn(&str) -> bool) -> Result<u64, String> {
        let elf = self.elf()?;
        let meant = elf.symbols().filter(|symbol| symbol.name().is_ok_and(&is_meant));
        match meant.map(|symbol| symbol.size()).sum() {
            0 => Err(self.complain("nothing of that name in it")),
            size => Ok(size),
        }
    }

    /// The names of all that is linked.
    pub fn symbols(&self) -> Result<Vec<String>, String> {
        let elf = self.elf()?;
        let linked = elf.symbols().filter(|symbol| symbol.is_definition());
        Ok(linked.filter_map(|symbol| symbol.name().ok().map(str::to_owned)).collect())
    }

    /// The names of all that lies in memory that is written to.
    pub fn statics(&self) -> Result<Vec<String>, String> {
        let elf = self.elf()?;
        let is_written = |symbol: &object::Symbol<'_, '_>| {
            let section = symbol.section_index().and_then(|index| elf.section_by_index(index).ok());
            section.is_some_and(|s| s.name().is_ok_and(|name| [".data", ".bss"].contains(&name)))
        };
        let written = elf.symbols().filter(|symbol| symbol.size() > 0 && is_written(symbol));
        Ok(written.filter_map(|symbol| symbol.name().ok().map(str::to_owned)).collect())
    }

    /// The version of the compiler that left its name in the image.
    pub fn compiler(&self) -> Result<String, String> {
        let elf = self.elf()?;
        let comment = elf.section_by_name(".comment").and_then(|section| section.data().ok());
        let text = String::from_utf8_lossy(comment.unwrap_or_default()).into_owned();
        let own = text.split('\0').find_map(|line| line.strip_prefix("rustc version "));
        let version = own.and_then(|version| version.split(' ').next());
        version.map(str::to_owned).ok_or_else(|| self.complain("no compiler's name in it"))
    }

    /// Sets a word of the image, `NAME=VALUE`: an f32 where the value has a point, else a u32.
    pub fn set(&mut self, assignment: &str) -> Result<(), String> {
        let accepted = "accepted: NAME=VALUE, with a whole number or one with a point";
        let complaint = || format!("{assignment}: {accepted}");
        let (name, value) = assignment.split_once('=').ok_or_else(complaint)?;
        let word = if value.contains('.') {
            value.parse::<f32>().map_err(|_| complaint())?.to_le_bytes()
        } else {
            value.parse::<u32>().map_err(|_| complaint())?.to_le_bytes()
        };
        let place = self.place(name)?;
        let slot = self.bytes.get_mut(place..place + word.len());
        slot.ok_or_else(|| format!("{name}: beyond the end of the image"))?.copy_from_slice(&word);
        Ok(())
    }

    /// Where in the file the word of a static lies.
    fn place(&self, name: &str) -> Result<usize, String> {
        let elf = self.elf()?;
        let is_named = |symbol: &str| symbol.contains(&format!("{}{name}", name.len()));
        let found = elf.symbols().find(|s| s.size() == 4 && s.name().is_ok_and(is_named));
        let address =
            found.ok_or_else(|| self.complain(&format!("no word {name} in it")))?.address();
        let place = elf.sections().find_map(|section| {
            let (start, size) = section.file_range()?;
            let offset = address.checked_sub(section.address()).filter(|&o| o + 4 <= size)?;
            usize::try_from(start + offset).ok()
        });
        place.ok_or_else(|| self.complain(&format!("{name} is not stored in it")))
    }
}

/// Whether a symbol, mangled, belongs to formatting or to panicking.
pub fn can_panic(symbol: &str) -> bool {
    ["4core9panicking", "4core3fmt", "slice_index_fail"].iter().any(|part| symbol.contains(part))
}

/// Whether a symbol is arithmetic of f64 in software.
pub fn is_soft_double(symbol: &str) -> bool {
    let of_arm = ["__aeabi_d", "__aeabi_f2d", "__aeabi_i2d", "__aeabi_ui2d", "__aeabi_l2d"];
    let of_gcc = symbol.starts_with("__") && (symbol.ends_with("df3") || symbol.ends_with("df2"));
    of_gcc || of_arm.iter().any(|start| symbol.starts_with(start) && symbol != "__aeabi_drsub")
}

/// Whether a symbol, mangled, belongs to the core.
pub fn is_of_core(symbol: &str) -> bool {
    symbol.contains("7schuler") || symbol.contains("schuler..")
}

/// Whether a symbol, mangled, is part of a step: its own, or another function of the core or of libm.
pub fn is_of_step(symbol: &str) -> bool {
    symbol.contains("every_sample") || is_of_core(symbol) || symbol.contains("4libm")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_known_by_their_names() {
        assert!(can_panic("_RNvNtCs7ldSeZOOJos_4core9panicking9panic_fmt"));
        assert!(can_panic("_ZN4core3fmt9Formatter3pad17h0123456789abcdefE"));
        assert!(is_soft_double("__aeabi_dmul") && is_soft_double("__aeabi_f2d"));
        assert!(is_soft_double("__muldf3") && is_soft_double("__ltdf2"));
        assert!(is_of_core("_RNvNtCs1_7schuler5noise3mix"));
        assert!(is_of_core(
            "_ZN75_$LT$schuler..strapdown..LocalLevel$u20$as$u20$Frame$GT$4step17h0E"
        ));
        assert!(is_of_step("_ZN16schuler_firmware6single12every_sample17h0E"));
        assert!(is_of_step("_ZN4libm4math4sqrt5sqrtf17h0E"));
        for symbol in ["__aeabi_memcpy", "_RNvCs1_16schuler_firmware4main", "__mulsf3", "memcpy"] {
            assert!(
                !can_panic(symbol) && !is_soft_double(symbol) && !is_of_step(symbol),
                "{symbol}"
            );
        }
    }

    #[test]
    fn the_core_has_no_unsafe_code() {
        assert!(include_str!("../../../core/src/lib.rs").contains("#![forbid(unsafe_code)]"));
    }
}
