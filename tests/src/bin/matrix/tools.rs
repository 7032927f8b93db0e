//! What this machine has: compilers, linkers, emulators.

use super::target::Target;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The compilers of this machine.
#[derive(Clone, Debug)]
pub struct Machine {
    compilers: Vec<Compiler>,
    /// The first one's own target.
    pub triple: String,
}

/// A compiler and its cargo.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Compiler {
    /// `rustc`, as it is called.
    pub rustc: &'static str,
    /// `cargo`, as it is called.
    pub cargo: &'static str,
    /// Its name and version.
    pub version: String,
    host: String,
    sysroot: PathBuf,
}

/// How a target is built.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Toolchain {
    /// With which compiler.
    pub compiler: Compiler,
    /// Whether it has to build `core` first.
    pub builds_core: bool,
    /// The linker, where the compiler has none.
    pub linker: Option<PathBuf>,
}

/// Compilers, in order of preference: the one that is set up, then the system's own.
const COMPILERS: [(&str, &str); 2] = [("rustc", "cargo"), ("/usr/bin/rustc", "/usr/bin/cargo")];

impl Machine {
    /// What is found; `None` without any compiler.
    pub fn look() -> Option<Self> {
        let found = COMPILERS.iter().filter_map(|&(rustc, cargo)| Compiler::look(rustc, cargo));
        let compilers: Vec<_> = found.collect();
        let triple = compilers.first()?.host.clone();
        Some(Self { compilers, triple })
    }

    /// How a target is built here, or what is missing for it.
    pub fn toolchain(&self, target: &Target) -> Result<Toolchain, String> {
        let triple = target.triple(self);
        let ready = self.compilers.iter().find(|compiler| compiler.has_core(triple));
        if let Some(compiler) = ready {
            return Ok(Toolchain { compiler: compiler.clone(), builds_core: false, linker: None });
        }
        let Some(compiler) = self.compilers.iter().find(|compiler| compiler.has_sources()) else {
            return Err(format!(
                "no compiler for {triple}: rustup target add {triple}, \
                 or apt-get install rustc-web cargo-web rust-web-src"
            ));
        };
        let name = if triple.starts_with("wasm") { "wasm-ld" } else { "ld.lld" };
        let linker = self.linker(name).ok_or_else(|| format!("no {name}: apt-get install lld"))?;
        Ok(Toolchain { compiler: compiler.clone(), builds_core: true, linker: Some(linker) })
    }

    /// The linker of some compiler, or the system's.
    fn linker(&self, name: &str) -> Option<PathBuf> {
        let of_compiler = self.compilers.iter().find_map(|compiler| {
            let folder = compiler.sysroot.join("lib/rustlib").join(&compiler.host).join("bin");
            Some(folder.join("rust-lld")).filter(|linker| linker.is_file())
        });
        of_compiler.or_else(|| version(name).map(|_| PathBuf::from(name)))
    }
}

impl Compiler {
    fn look(rustc: &'static str, cargo: &'static str) -> Option<Self> {
        version(cargo)?;
        let verbose = output(Command::new(rustc).arg("-vV"))?;
        let host = verbose.lines().find_map(|line| line.strip_prefix("host: "))?.to_owned();
        let words: Vec<_> = verbose.lines().next()?.split_whitespace().take(2).collect();
        let sysroot = output(Command::new(rustc).args(["--print", "sysroot"]))?;
        let sysroot = PathBuf::from(sysroot.trim());
        Some(Self { rustc, cargo, version: words.join(" "), host, sysroot })
    }

    /// Whether the target's `core` is installed.
    fn has_core(&self, triple: &str) -> bool {
        let folder = ["--print", "target-libdir", "--target", triple];
        output(Command::new(self.rustc).args(folder))
            .is_some_and(|folder| Path::new(folder.trim()).is_dir())
    }

    /// Whether the sources of `core` are installed.
    fn has_sources(&self) -> bool {
        self.sysroot.join("lib/rustlib/src/rust/library/core/Cargo.toml").is_file()
    }
}

/// A program's name and version, as it tells them; `None` if there is no such program.
pub fn version(program: &str) -> Option<String> {
    let text = output(Command::new(program).arg("--version"))?;
    let mut words = text.split_whitespace().map(|word| word.trim_start_matches('v'));
    let number = words.find(|word| word.starts_with(|c: char| c.is_ascii_digit()));
    Some(format!("{program} {}", number.unwrap_or_default()))
}

/// The standard output of a program that succeeds.
fn output(command: &mut Command) -> Option<String> {
    let output = command.stdin(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}
