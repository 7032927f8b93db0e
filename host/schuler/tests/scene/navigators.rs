//! Navigators that there are not.

use super::errors::expect_more;
use super::scene;

#[test]
fn what_does_not_go_together() {
    let navigator = |keys: &str| format!("[navigator]\n{keys}");
    let two_float = navigator("frame = \"earth-fixed\"\nprecision = \"f32x2\"\n");
    scene(&two_float).expect("f32x2 has both frames");
    let two_float = navigator("algorithm = \"textbook\"\nprecision = \"f32x2\"\n");
    expect_more(&two_float, 5, "navigator.precision", &["f32x2 is not to be had", "taylor"]);
    let window = |shape: &str| {
        let [history, block, lookahead] = [0, 2, 4].map(|i| &shape[i..=i]);
        format!("window = {{ history = {history}, block = {block}, lookahead = {lookahead} }}\n")
    };
    let two_float = navigator("precision = \"f32x2\"\n") + &window("0,8,0");
    let error = scene(&two_float).expect_err("no such window").to_string();
    let accepted = "f32x2 has no window 0,8,0; accepted: auto; 0,4,0; 4,4,0; 2,4,2; 4,4,4";
    assert_eq!(error, format!("folder/bad.toml:5: navigator.window: {accepted}"));
    for shape in ["0,4,0", "4,4,0", "2,4,2", "4,4,4"] {
        scene(&(navigator("precision = \"f32x2\"\n") + &window(shape))).expect(shape);
    }
    let textbook = navigator("algorithm = \"textbook\"\n") + &window("2,4,2");
    expect_more(&textbook, 5, "navigator.window", &["textbook has no window", "auto, or taylor"]);
}
