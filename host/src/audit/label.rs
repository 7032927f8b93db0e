//! What the words of a stage are called.

use super::chain::Stage;

impl Stage {
    /// What a word is called: its field, and which component it is.
    pub fn label(&self, word: usize) -> String {
        let Some(name) = self.fields.get(word) else { return format!("word {word}") };
        let of_name = |field: &&String| *field == name;
        let count = self.fields.iter().filter(of_name).count();
        let index = self.fields.iter().take(word).filter(of_name).count();
        let components: &[&str] = match count {
            1 => return name.clone(),
            2 => &["hi", "lo"],
            3 if self.name == "trajectory" => &["value", "first derivative", "second derivative"],
            3 => &["x", "y", "z"],
            4 => &["w", "x", "y", "z"],
            6 => &["x.hi", "x.lo", "y.hi", "y.lo", "z.hi", "z.lo"],
            8 => &["w.hi", "w.lo", "x.hi", "x.lo", "y.hi", "y.lo", "z.hi", "z.lo"],
            _ => &[],
        };
        match components.get(index) {
            Some(component) => format!("{name} {component}"),
            None => format!("{name} {}", index + 1),
        }
    }
}
