//! The rows of the matrix: what is built how, and what runs it.

use super::tools::Machine;

/// A row of the matrix.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Its name on the command line.
    pub name: &'static str,
    /// The compiler's name of it; absent where it is this machine.
    pub triple: Option<&'static str>,
    /// How much is optimised.
    pub profile: Profile,
    /// Options of the compiler.
    pub flags: &'static [&'static str],
    /// Settings of cargo.
    pub settings: &'static [&'static str],
    /// Features of the audit program.
    pub features: &'static str,
    /// The program that runs it and its arguments, before the image; empty where it runs by itself.
    pub runner: &'static [&'static str],
    /// Where the runner comes from.
    pub package: &'static str,
}

/// How much is optimised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Nothing.
    Debug,
    /// All that can be.
    Release,
}

impl Profile {
    /// The compiler's level of optimisation.
    pub fn level(self) -> &'static str {
        match self {
            Self::Debug => "0",
            Self::Release => "3",
        }
    }

    /// The folder that cargo builds into.
    pub fn folder(self) -> &'static str {
        match self {
            Self::Debug => "debug",
            Self::Release => "release",
        }
    }
}

const QEMU_M3: &[&str] = &cortex_m("mps2-an385", "cortex-m3");
const QEMU_M4: &[&str] = &cortex_m("mps2-an386", "cortex-m4");

/// A board in QEMU that prints through semihosting.
const fn cortex_m(board: &'static str, processor: &'static str) -> [&'static str; 16] {
    [
        "qemu-system-arm",
        "-machine",
        board,
        "-cpu",
        processor,
        "-display",
        "none",
        "-monitor",
        "none",
        "-serial",
        "none",
        "-chardev",
        "stdio,id=out,signal=off",
        "-semihosting-config",
        "enable=on,target=native,chardev=out",
        "-kernel",
    ]
}

const MACHINE: Target = Target {
    name: "release",
    triple: None,
    profile: Profile::Release,
    flags: &[],
    settings: &[],
    features: "std",
    runner: &[],
    package: "",
};

const fn other(
    triple: &'static str,
    runner: &'static [&'static str],
    package: &'static str,
) -> Target {
    Target { name: triple, triple: Some(triple), features: "", runner, package, ..MACHINE }
}

/// Every row; the first is what the others are compared with.
pub const TARGETS: [Target; 12] = [
    MACHINE,
    Target { name: "debug", profile: Profile::Debug, ..MACHINE },
    Target { name: "native", flags: &["-Ctarget-cpu=native"], ..MACHINE },
    Target {
        name: "native-std",
        flags: &["-Ctarget-cpu=native"],
        features: "std,schuler/std",
        ..MACHINE
    },
    other("thumbv7em-none-eabihf", QEMU_M4, "qemu-system-arm"),
    other("thumbv7em-none-eabi", QEMU_M4, "qemu-system-arm"),
    other("thumbv6m-none-eabi", QEMU_M3, "qemu-system-arm"),
    other("riscv32imac-unknown-none-elf", &["qemu-riscv32"], "qemu-user"),
    other("aarch64-unknown-none", &["qemu-aarch64"], "qemu-user"),
    other("wasm32-unknown-unknown", &["node", "run.mjs"], "nodejs"),
    Target {
        flags: &["-Clinker-flavor=ld.lld", "-Crelocation-model=static"],
        // QEMU 7.2 takes the wrong half of a register in MDEBR, which multiplies two f32 into an f64;
        // the optimiser makes one of libm's sincosf.
        settings: &["profile.release.package.libm.opt-level=0"],
        ..other("s390x-unknown-linux-gnu", &["qemu-s390x"], "qemu-user")
    },
    Target {
        // Its vectors multiply only by adding −0 to the product, and flush subnormals unless told.
        flags: &[
            "-Clinker-flavor=ld.lld",
            "-Crelocation-model=static",
            "-Clink-self-contained=no",
            "-Ctarget-feature=-altivec,-vsx",
        ],
        ..other("powerpc64-unknown-linux-musl", &["qemu-ppc64"], "qemu-user")
    },
];

impl Target {
    /// The compiler's name of it.
    pub fn triple<'a>(&self, machine: &'a Machine) -> &'a str
    where
        Self: 'a,
    {
        self.triple.unwrap_or(&machine.triple)
    }

    /// The same, not optimised.
    pub fn debug(&self) -> Self {
        Self { profile: Profile::Debug, settings: &[], ..*self }
    }

    /// What sets its build apart, for people.
    pub fn options(&self) -> String {
        let mut options = format!("opt-level {}", self.profile.level());
        for flag in self.flags.iter().filter(|flag| flag.starts_with("-Ctarget-")) {
            options += &format!(", {}", flag.trim_start_matches("-C"));
        }
        for setting in self.settings {
            options += &format!(", {}", setting.trim_start_matches("profile.release.package."));
        }
        if self.features.contains("schuler/std") {
            options += ", core's std";
        }
        options
    }
}
