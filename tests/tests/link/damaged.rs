//! States that were damaged before they came back over the link.

use super::line::Line;
use super::session::frame;
use schuler::link::bytes::Bytes;
use schuler::link::fleet::Fleet;
use schuler::link::gap::Policy;
use schuler::link::message::{MOST_WORDS, Request};

/// The words of a flight's state.
pub fn words_of(line: &Line) -> Vec<u64> {
    let mut words = Vec::new();
    line.target.flight().unwrap().words(&mut |bits| words.push(bits));
    words
}

/// Writes a whole state back over the link; what the target says to the last piece.
fn restore(line: &mut Line, words: &[u64], sequence: &mut u32) -> String {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let mut said = String::new();
    for (n, piece) in bytes.chunks(8 * MOST_WORDS).enumerate() {
        *sequence += 1;
        let offset = (n * MOST_WORDS) as u16;
        let request = Request::Restore { words: words.len() as u16, offset, piece: Bytes(piece) };
        said = line.tell(&frame(&request, *sequence)).remove(0).2;
    }
    said
}

#[test]
fn a_damaged_state_is_refused_and_a_sound_one_awaited() {
    let mut line = Line::new(Policy::Bridge);
    for number in 1..=14 {
        let frame = line.sample(number, number + 1);
        line.tell(&frame);
    }
    let sound = words_of(&line);
    let mut sequence = 15;
    let mut refused = 0;
    for word in 0..sound.len() {
        for bit in (0..64).step_by(3) {
            let mut damaged = sound.clone();
            damaged[word] ^= 1 << bit;
            let said = restore(&mut line, &damaged, &mut sequence);
            sequence += 1;
            let next = line.sample(15, sequence);
            let heard = line.tell(&next).remove(0).2;
            if said.starts_with("Damaged") {
                refused += 1;
                assert!(heard.starts_with("NotStarted"), "word {word}, bit {bit}: {heard}");
            } else {
                // Whatever may be right is flown, or its next sample refused: the target answers.
                assert!(said.contains(" of "), "word {word}, bit {bit}: {said}");
            }
        }
    }
    assert!(refused > sound.len(), "{refused} of {} words", sound.len());
    let said = restore(&mut line, &sound, &mut sequence);
    assert_eq!(said, "at 12 of 14: 11111111111111");
    assert_eq!(words_of(&line), sound);
}

#[test]
fn a_count_of_pending_samples_beyond_the_store_is_refused() {
    let mut line = Line::new(Policy::Bridge);
    for number in 1..=14 {
        let frame = line.sample(number, number + 1);
        line.tell(&frame);
    }
    let sound = words_of(&line);
    // Two samples wait: every word that says so, and any other of 2, told to be 1000.
    let waiting: Vec<_> = (0..sound.len()).filter(|&word| sound[word] == 2).collect();
    assert!(!waiting.is_empty());
    let mut sequence = 15;
    for word in waiting {
        let mut damaged = sound.clone();
        damaged[word] = 1000;
        let said = restore(&mut line, &damaged, &mut sequence);
        assert!(said.starts_with("Damaged"), "word {word}: {said}");
    }
}
