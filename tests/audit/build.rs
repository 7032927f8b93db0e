//! Gives the linker what a target without an operating system needs.

fn main() {
    println!("cargo::rerun-if-changed=mps2.ld");
    if std::env::var("CARGO_CFG_TARGET_ARCH").as_deref() == Ok("arm") {
        let folder = std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
        println!("cargo::rustc-link-arg-bins=-T{folder}/mps2.ld");
    }
}
