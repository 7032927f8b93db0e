//! Numbers as text that a page's script reads: short, in seven digits.

/// A series: `[first, last, count]` where its steps are equal to seven digits, else its values as little-endian singles in
/// base 64 (RFC 4648, section 4), in quotes. What is not finite is not a number there.
pub fn packed(values: &[f64]) -> String {
    if let [first, .., last] = values
        && is_even(values)
    {
        return format!("[{first:e},{last:e},{}]", values.len());
    }
    let bytes: Vec<u8> = values.iter().flat_map(|&value| (value as f32).to_le_bytes()).collect();
    format!("\"{}\"", base64(&bytes))
}

/// Whether each value lies on the line from the first to the last.
fn is_even(values: &[f64]) -> bool {
    let [first, .., last] = values else { return false };
    let (step, most) = ((last - first) / (values.len() - 1) as f64, first.abs().max(last.abs()));
    let near = |(i, value): (usize, &f64)| (value - (first + i as f64 * step)).abs() <= 1e-9 * most;
    values.iter().enumerate().all(near)
}

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

fn base64(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let word = three.iter().fold(0u32, |word, &byte| word << 8 | u32::from(byte));
        let word = word << (8 * (3 - three.len()));
        for place in 0..4 {
            let digit = DIGITS[(word >> (18 - 6 * place) & 63) as usize];
            text.push(if place <= three.len() { digit.into() } else { '=' });
        }
    }
    text
}

/// A text in quotes, safe inside a script of a page.
pub fn quoted(text: &str) -> String {
    let mut safe = String::with_capacity(text.len() + 2);
    safe.push('"');
    for character in text.chars() {
        match character {
            '"' | '\\' => safe.extend(['\\', character]),
            '<' | '>' | '&' | '\u{0}'..='\u{1f}' | '\u{2028}' | '\u{2029}' => {
                safe += &format!("\\u{:04x}", u32::from(character));
            }
            _ => safe.push(character),
        }
    }
    safe.push('"');
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_64_is_the_standards() {
        // RFC 4648, section 10.
        for (plain, coded) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
    }

    #[test]
    fn equal_steps_take_three_numbers() {
        let times: Vec<f64> = (0..1000).map(|k| f64::from(k) * 0.05).collect();
        assert_eq!(packed(&times), "[0e0,4.995e1,1000]");
        assert_eq!(packed(&[3.0; 5]), "[3e0,3e0,5]");
        // 1, 2 and 4 as singles: 3f800000, 40000000, 40800000.
        assert_eq!(packed(&[1.0, 2.0, 4.0]), "\"AACAPwAAAEAAAIBA\"");
        assert_eq!(packed(&[1.0]), "\"AACAPw==\"");
        assert!(packed(&[0.0, f64::NAN, 2.0]).starts_with('"'));
        assert_eq!(packed(&[]), "\"\"");
    }

    #[test]
    fn text_cannot_end_its_script() {
        assert_eq!(quoted("</script>\"\\\n"), "\"\\u003c/script\\u003e\\\"\\\\\\u000a\"");
    }
}
