//! Devices at the end of a line: a TCP connection, and a serial port that is a pseudo-terminal.

use super::{fly, scene};
use schuler_host::hil::Manner;
use schuler_host::hil::device::Device;
use schuler_host::hil::in_process::InProcess;
use schuler_simulator::twin::application;
use std::io::{ErrorKind, Read, Write};
use std::net::TcpListener;
use std::path::Path;
use std::thread;

/// A target behind a line, until the line ends.
fn serve(mut line: impl Read + Write) {
    let mut target = application::every();
    let mut answers = Vec::new();
    target.hello(&mut |bytes| answers.extend_from_slice(bytes));
    let mut buffer = [0; 64];
    loop {
        if line.write_all(&answers).is_err() {
            return;
        }
        answers.clear();
        match line.read(&mut buffer) {
            Ok(0) => return,
            Ok(length) => {
                target.take(&buffer[..length], &mut |bytes| answers.extend_from_slice(bytes));
            }
            Err(error) if error.kind() == ErrorKind::TimedOut => {}
            Err(_) => return,
        }
    }
}

fn flies_the_same_bits(device: &str) {
    let scene = scene("paper", 5.0);
    let (alone, _) = fly(&scene, InProcess::every(), &Manner::default());
    let channel = Device::parse(device).unwrap().open(Path::new("")).unwrap();
    let (flown, ended) = fly(&scene, channel, &Manner { retries: 5, ..Manner::default() });
    assert_eq!(flown.unwrap().digest, alone.unwrap().digest);
    assert_eq!(ended.tally.lost, 0);
}

#[test]
fn a_target_behind_a_tcp_connection() {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap();
    let target = thread::spawn(move || serve(listener.accept().unwrap().0));
    flies_the_same_bits(&format!("tcp:{address}"));
    target.join().unwrap();
}

#[cfg(unix)]
#[test]
fn a_target_behind_a_serial_port() {
    use serialport::{SerialPort, TTYPort};
    let (far, near) = TTYPort::pair().unwrap();
    let name = near.name().unwrap();
    // The port's own end is opened by name, and this one kept, so that the line lasts.
    thread::spawn(move || serve(far));
    flies_the_same_bits(&format!("serial:{name}@921600"));
    drop(near);
}
