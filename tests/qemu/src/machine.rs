//! The machines that images are built for and flown on.

/// A machine of QEMU's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Machine {
    /// QEMU's name of it.
    pub name: &'static str,
    /// The core that it stands for.
    pub core: &'static str,
    /// The compiler's target.
    pub target: &'static str,
    /// The firmware's feature that chooses its board support.
    pub board: &'static str,
    /// The emulator.
    pub program: &'static str,
    /// What chooses the machine.
    pub arguments: &'static [&'static str],
    /// Length of the self-test's flight, s.
    pub flight_s: u32,
}

/// Every machine, the reference board first.
pub const MACHINES: &[Machine] = &[
    Machine {
        name: "mps2-an386",
        core: "Cortex-M4F",
        target: "thumbv7em-none-eabihf",
        board: "mps2",
        program: "qemu-system-arm",
        arguments: &["-machine", "mps2-an386", "-cpu", "cortex-m4"],
        flight_s: 1800,
    },
    Machine {
        name: "mps2-an500",
        core: "Cortex-M7",
        target: "thumbv7em-none-eabihf",
        board: "mps2",
        program: "qemu-system-arm",
        arguments: &["-machine", "mps2-an500", "-cpu", "cortex-m7"],
        flight_s: 60,
    },
    Machine {
        name: "mps2-an505",
        core: "Cortex-M33",
        target: "thumbv8m.main-none-eabihf",
        board: "mps2-an505",
        program: "qemu-system-arm",
        arguments: &["-machine", "mps2-an505", "-cpu", "cortex-m33"],
        flight_s: 60,
    },
    Machine {
        name: "mps2-an385",
        core: "Cortex-M3",
        target: "thumbv7m-none-eabi",
        board: "mps2",
        program: "qemu-system-arm",
        arguments: &["-machine", "mps2-an385", "-cpu", "cortex-m3"],
        flight_s: 60,
    },
    Machine {
        name: "microbit",
        core: "Cortex-M0",
        target: "thumbv6m-none-eabi",
        board: "microbit",
        program: "qemu-system-arm",
        arguments: &["-machine", "microbit"],
        flight_s: 60,
    },
    Machine {
        name: "virt",
        core: "RV32IMAC",
        target: "riscv32imac-unknown-none-elf",
        board: "virt",
        program: "qemu-system-riscv32",
        arguments: &["-machine", "virt", "-bios", "none"],
        flight_s: 60,
    },
];

/// The machine of a name.
pub fn named(name: &str) -> Result<Machine, String> {
    let names: Vec<_> = MACHINES.iter().map(|machine| machine.name).collect();
    let found = MACHINES.iter().find(|machine| machine.name == name);
    found.copied().ok_or_else(|| format!("{name}: no such machine; accepted: {}", names.join(", ")))
}

/// Every target with its board once: what has to be built.
pub fn builds() -> Vec<(&'static str, &'static str)> {
    let mut builds: Vec<_> = MACHINES.iter().map(|m| (m.target, m.board)).collect();
    builds.dedup();
    builds
}
