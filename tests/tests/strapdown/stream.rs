//! Streams: a row for every sample, whatever the window, the length and the way of reading.

use schuler::math::compensated::Pair;
use schuler::output::Output as _;
use schuler::record::Record;
use schuler::strapdown::block::window::Window;
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::{State, Strapdown};
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler_tests::{Course, bits, largest, reader};

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;

fn course() -> Course {
    Course::new("manoeuvre", 1.0, 1.0)
}

/// A hundred samples of motion that suits the window: a line or a parabola is for slow motion.
fn course_for<W: Window>() -> Course {
    if W::COEFFICIENTS < W::SAMPLES { Course::new("paper-perfect", 1.0, 5.0) } else { course() }
}

fn name<W: Window>() -> String {
    format!("H{} B{} A{}", W::HISTORY, W::BLOCK, W::LOOKAHEAD)
}

/// Rows that may be read after n samples: whole blocks with their look-ahead, and the first block of a
/// window with history when the first window is full.
fn ready<W: Window>(samples: usize) -> usize {
    let waits = if W::HISTORY > 0 { W::FIRST } else { 0 };
    let blocks = samples.saturating_sub(W::LOOKAHEAD) / W::BLOCK;
    if samples < waits { 0 } else { blocks * W::BLOCK }
}

/// A state is copied at every length of the stream, and its copy finished there.
fn one_row_each<F: Frame<Real = f64>, W: Window>()
where
    State<F, W>: Record,
{
    let (course, name) = (course_for::<W>(), name::<W>());
    let strapdown = Strapdown::<F, W>::new(course.interval_s).unwrap();
    let mut reading = strapdown.start(&course.initial()).unwrap();
    let mut silent = reading;
    let mut rows = 0;
    for (length, &sample) in (1..=60).zip(&course.samples) {
        let mut last = None;
        let mut read = |row, output: F::Output| {
            rows += 1;
            assert_eq!(row, rows, "{name}");
            last = Some(format!("{:?}", output.wide()));
        };
        strapdown.push_rows(&mut reading, sample, reader(&mut read)).unwrap();
        strapdown.push(&mut silent, sample).unwrap();
        assert_eq!(bits(&reading), bits(&silent), "{name} {length}");
        assert_eq!(rows as usize, ready::<W>(length), "{name} after {length}");
        assert_eq!(reading.integrated(), rows);
        if let Some(output) = last {
            // The last row of a block is the state itself.
            assert_eq!(output, format!("{:?}", reading.output().wide()));
        }

        // The stream's end, with and without reading; nothing is left to finish then.
        let (mut ended, mut silently) = (reading, reading);
        let mut all_rows = rows;
        let mut count = |row, _| {
            all_rows += 1;
            assert_eq!(row, all_rows, "{name} at the end of {length}");
        };
        strapdown.finish_rows(&mut ended, reader(&mut count));
        strapdown.finish(&mut silently);
        assert_eq!(all_rows, length as u64, "{name}");
        assert_eq!(bits(&ended), bits(&silently), "{name} at the end of {length}");
        strapdown.finish_rows(&mut ended, reader(&mut |row, _| panic!("{name}: {row} again")));
        assert_eq!(bits(&ended), bits(&silently));

        // A prediction is the end of a copy, and leaves the state alone.
        let predicted = format!("{:?}", strapdown.predict(&reading).wide());
        assert_eq!(predicted, format!("{:?}", ended.output().wide()));
        assert_eq!(bits(&reading), bits(&silent), "{name} {length}");
    }
}

#[test]
fn one_row_for_every_sample_in_local_level_axes() {
    for_every_window!(one_row_each, Local);
}

#[test]
fn one_row_for_every_sample_in_earth_fixed_axes() {
    for_every_window!(one_row_each, Earth);
}

#[test]
fn the_textbook_has_its_row_at_once() {
    fn check<M: Mechanization<Real = f64>>(mechanization: &M)
    where
        M::State: Record,
    {
        let course = course();
        let mut reading = mechanization.start(&course.initial()).unwrap();
        let mut silent = reading;
        for (n, &sample) in (1..).zip(&course.samples) {
            let mut rows = Vec::new();
            mechanization.push_rows(&mut reading, sample, |row, _| rows.push(row)).unwrap();
            mechanization.push(&mut silent, sample).unwrap();
            assert_eq!(rows, [n]);
            assert_eq!(bits(&reading), bits(&silent));
            assert_eq!(M::integrated(&silent), n);
        }
        mechanization.finish_rows(&mut reading, |row, _| panic!("{row} again"));
    }
    check(&Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap());
    check(&Textbook::<EarthFixedTextbook<f64>>::new(0.01).unwrap());
}

/// A row that look-ahead delayed is what it would have been in any other stream.
fn delayed_but_unchanged<W: Window>() {
    let course = course_for::<W>();
    let strapdown = Strapdown::<Local, W>::new(course.interval_s).unwrap();
    let rows = |length: usize| {
        let mut state = strapdown.start(&course.initial()).unwrap();
        let mut rows = Vec::new();
        for &sample in &course.samples[..length] {
            let mut read = |_, row| rows.push(format!("{row:?}"));
            strapdown.push_rows(&mut state, sample, reader(&mut read)).unwrap();
        }
        rows
    };
    let long = rows(course.samples.len());
    for length in [1, 7, 10, 23, 41, 64] {
        let short = rows(length);
        assert_eq!(short[..], long[..short.len()], "{}", name::<W>());
    }
}

#[test]
fn look_ahead_delays_a_row_and_never_changes_it() {
    for_every_window!(delayed_but_unchanged);
}

/// How well a window does on a motion at its best: its largest miss in an unbroken stream, m.
fn unbroken<F: Frame<Real = f64>, W: Window>(course: &Course) -> f64 {
    course.largest_miss(&Strapdown::<F, W>::new(course.interval_s).unwrap())
}

/// A stream that was finished goes on, twice: every row in order, and as near to the truth.
fn goes_on<F: Frame<Real = f64>, W: Window>() {
    let (course, name) = (course_for::<W>(), name::<W>());
    let strapdown = Strapdown::<F, W>::new(course.interval_s).unwrap();
    let floor = unbroken::<F, W>(&course);
    for cut in 1..45 {
        for again in [cut + 3, cut + 25] {
            let mut state = strapdown.start(&course.initial()).unwrap();
            let mut rows = Vec::new();
            let mut read = |row: u64, output: F::Output| {
                rows.push(output.wide());
                assert_eq!(row, rows.len() as u64, "{name} {cut}");
            };
            for (n, &sample) in course.samples.iter().enumerate() {
                if n == cut || n == again {
                    strapdown.finish_rows(&mut state, reader(&mut read));
                }
                strapdown.push_rows(&mut state, sample, reader(&mut read)).unwrap();
            }
            strapdown.finish_rows(&mut state, reader(&mut read));
            assert_eq!(rows.len(), course.samples.len(), "{name} {cut}");
            let worst = largest(rows.iter().zip(1..).map(|(row, n)| course.miss(n, row)));
            // What one to three samples alone cannot know of a turning, pulling vehicle.
            let blind = match cut {
                1 => 2e-4,
                2..=3 => 1e-6,
                _ => 3e-9,
            };
            assert!(worst <= 2.0 * floor + blind, "{name} {cut}: {worst:e} {floor:e}");
        }
    }
}

#[test]
fn a_finished_stream_may_go_on_in_local_level_axes() {
    for_every_window!(goes_on, Local);
}

#[test]
fn a_finished_stream_may_go_on_in_earth_fixed_axes() {
    for_every_window!(goes_on, Earth);
}

/// A short stream's last row is as near to the truth as any.
fn any_length<W: Window>() {
    let (course, name) = (course_for::<W>(), name::<W>());
    let strapdown = Strapdown::<Local, W>::new(course.interval_s).unwrap();
    let floor = unbroken::<Local, W>(&course);
    let mut state = strapdown.start(&course.initial()).unwrap();
    for (length, &sample) in (1..=40).zip(&course.samples) {
        strapdown.push(&mut state, sample).unwrap();
        let miss = course.miss(length, &strapdown.predict(&state).wide());
        let blind = match length {
            1 => 2e-5,
            2..=3 => 3e-8,
            _ => 3e-9,
        };
        assert!(miss <= 2.0 * floor + blind, "{name} {length}: {miss:e} {floor:e}");
    }
}

#[test]
fn a_stream_of_any_length_ends_near_the_truth() {
    for_every_window!(any_length);
}
