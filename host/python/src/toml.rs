//! A scene's text from a dict, in which numbers keep all their digits.

use crate::error::{Answer, Fault};
use crate::log::Logs;
use pyo3::prelude::*;
use pyo3::types::{PyMapping, PyString};
use std::fmt::Write as _;

/// The text of a table, a line for each key. Arrays of a log go to files.
pub fn document(table: &Bound<'_, PyMapping>, logs: &mut Logs) -> Answer<String> {
    let mut text = String::new();
    for (key, item) in entries(table, "")? {
        let before = text.len();
        quote(&mut text, &key);
        text += " = ";
        if value(&mut text, &item, &key, logs)? {
            text.push('\n');
        } else {
            text.truncate(before);
        }
    }
    Ok(text)
}

/// Keys with their values.
fn entries<'py>(
    table: &Bound<'py, PyMapping>,
    name: &str,
) -> Answer<Vec<(String, Bound<'py, PyAny>)>> {
    let mut entries = Vec::new();
    for pair in table.items()?.iter() {
        let (key, item): (Bound<'py, PyAny>, Bound<'py, PyAny>) = pair.extract()?;
        let key: String = key.extract().map_err(|_| {
            Fault::argument(name, format!("has the key {key}, which is not text"), "text")
        })?;
        entries.push((key, item));
    }
    Ok(entries)
}

/// The value of a dotted key; false where there is none.
fn value(text: &mut String, item: &Bound<'_, PyAny>, name: &str, logs: &mut Logs) -> Answer<bool> {
    if item.is_none() {
        return Ok(false);
    }
    if let Ok(truth) = item.extract::<bool>() {
        text.push_str(if truth { "true" } else { "false" });
    } else if let Ok(string) = item.cast::<PyString>() {
        quote(text, &string.to_string());
    } else if let Ok(integer) = item.extract::<i64>() {
        write(text, format_args!("{integer}"));
    } else if let Ok(integer) = item.extract::<u64>() {
        write(text, format_args!("{integer}"));
    } else if let Ok(number) = item.extract::<f64>() {
        // Debug has a point or an exponent, and the shortest digits that round-trip.
        match number {
            _ if number.is_finite() => write(text, format_args!("{number:?}")),
            _ if number.is_nan() => text.push_str("nan"),
            _ => text.push_str(if number > 0.0 { "inf" } else { "-inf" }),
        }
    } else if let Ok(table) = item.cast::<PyMapping>() {
        text.push_str("{ ");
        let mut is_first = true;
        let file = if name == "trajectory.log" { logs.write(table)? } else { None };
        for (key, item) in entries(table, name)? {
            if file.is_some() && Logs::is_column(&key) {
                continue;
            }
            let before = text.len();
            separate(text, &mut is_first);
            quote(text, &key);
            text.push_str(" = ");
            if !value(text, &item, &format!("{name}.{key}"), logs)? {
                text.truncate(before);
                is_first = text.ends_with("{ ");
            }
        }
        if let Some(file) = file {
            separate(text, &mut is_first);
            text.push_str("\"file\" = ");
            quote(text, &file);
        }
        text.push_str(" }");
    } else if let Ok(items) = item.try_iter() {
        text.push('[');
        let mut is_first = true;
        for (place, item) in items.enumerate() {
            separate(text, &mut is_first);
            let name = format!("{name}[{place}]");
            if !value(text, &item?, &name, logs)? {
                return Err(Fault::argument(&name, "is None", "a value"));
            }
        }
        text.push(']');
    } else {
        let what = format!("is a {}", item.get_type().name()?);
        let accepted = "a number, text, true or false, a list or a dict of such";
        return Err(Fault::argument(name, what, accepted));
    }
    Ok(true)
}

fn separate(text: &mut String, is_first: &mut bool) {
    if !std::mem::take(is_first) {
        text.push_str(", ");
    }
}

fn write(text: &mut String, what: std::fmt::Arguments<'_>) {
    // A string takes everything.
    let _ = text.write_fmt(what);
}

/// Text in quotes.
fn quote(text: &mut String, string: &str) {
    text.push('"');
    for character in string.chars() {
        match character {
            '"' | '\\' => {
                text.push('\\');
                text.push(character);
            }
            _ if character.is_control() => write(text, format_args!("\\u{:04X}", character as u32)),
            _ => text.push(character),
        }
    }
    text.push('"');
}
