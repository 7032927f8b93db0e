//! What bandwidth, latency, temperature and matrices may be.

use super::errors::expect_more;

#[test]
fn temperature_and_latency() {
    expect_more("[gyro]\nlatency_s = 0.5\n", 4, "gyro.latency_s", &["8 samples", "from 0 to 0.4"]);
    let words = &["is missing", "ramp_k_min"];
    expect_more("[gyro]\ntemperature_bias_deg_h_k = 1\n", 1, "temperature", words);
    expect_more("[temperature]\noffset_k = 1\n", 3, "temperature", &["changes nothing"]);
    expect_more("[gyro]\nbandwidth_hz = 0\n", 4, "gyro.bandwidth_hz", &["out of range"]);
    expect_more(
        "[gyro]\nmisalignment_matrix_arcsec = [[0, 1, 2], 3, [4, 5, 6]]\n",
        4,
        "gyro.misalignment_matrix_arcsec[1]",
        &["three rows [x, y, z]"],
    );
}
