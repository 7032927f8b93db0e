//! Where a chain comes from: program, compiler, libm, machine and day.

use std::time::SystemTime;

/// In one line.
pub fn line() -> String {
    let day = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
    format!(
        "schuler {}, {}, libm {}, {}-{}, {}",
        env!("CARGO_PKG_VERSION"),
        env!("SCHULER_COMPILER"),
        env!("SCHULER_LIBM_VERSION"),
        std::env::consts::ARCH,
        std::env::consts::OS,
        day.split('T').next().unwrap_or_default()
    )
}
