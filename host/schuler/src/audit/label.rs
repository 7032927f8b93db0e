//! Names of the words of a stage.

use super::chain::Stage;
use schuler_simulator::scene::Axes;

const AXES: [&str; 3] = ["x", "y", "z"];

impl Stage {
    /// What a word is called: its field, and which component it is. The frame of the navigator says
    /// which those of `nav` are; without it they are numbered.
    pub fn label(&self, word: usize, frame: Option<Axes>) -> String {
        let Some(name) = self.fields.get(word) else { return format!("word {word}") };
        let of_name = |field: &&String| *field == name;
        let count = self.fields.iter().filter(of_name).count();
        let index = self.fields.iter().take(word).filter(of_name).count();
        let vector = match (self.name.as_str(), frame) {
            ("trajectory", _) => ["value", "first derivative", "second derivative"],
            ("nav", None) => ["1", "2", "3"],
            ("nav", Some(Axes::LocalLevel)) if name == "position" => {
                ["latitude", "longitude", "altitude"]
            }
            ("nav", Some(Axes::LocalLevel)) => ["north", "east", "down"],
            _ => AXES,
        };
        let quaternion = ["w", "x", "y", "z"];
        let halves = ["hi", "lo"];
        let half = halves[index % 2];
        match count {
            1 => name.clone(),
            2 => format!("{name} {half}"),
            3 => format!("{name} {}", vector[index]),
            4 => format!("{name} {}", quaternion[index]),
            6 => format!("{name} {}.{half}", vector[index / 2]),
            8 => format!("{name} {}.{half}", quaternion[index / 2]),
            _ => format!("{name} {}", index + 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::chain::Width;
    use super::*;

    #[test]
    fn components_are_those_of_the_frame() {
        let labels = |stage: &str, frame, fields: &str| {
            let mut stage = Stage::new(stage, Width::Double);
            stage.fields = fields.split(' ').map(str::to_owned).collect();
            let count = stage.fields.len();
            (0..count).map(|word| stage.label(word, frame)).collect::<Vec<_>>().join(", ")
        };
        let (level, fixed) = (Some(Axes::LocalLevel), Some(Axes::EarthFixed));
        let twice = "position position position position position position sine sine curvature";
        assert_eq!(
            labels("nav", level, twice),
            "position latitude.hi, position latitude.lo, position longitude.hi, \
             position longitude.lo, position altitude.hi, position altitude.lo, sine hi, sine lo, \
             curvature"
        );
        let vector = "velocity velocity velocity";
        assert_eq!(labels("nav", level, vector), "velocity north, velocity east, velocity down");
        assert_eq!(labels("nav", fixed, vector), "velocity x, velocity y, velocity z");
        assert_eq!(labels("nav", None, vector), "velocity 1, velocity 2, velocity 3");
        assert_eq!(labels("body", level, vector), "velocity x, velocity y, velocity z");
        assert_eq!(labels("body", None, "q q q q"), "q w, q x, q y, q z");
        assert_eq!(
            labels("trajectory", None, "roll roll roll"),
            "roll value, roll first derivative, roll second derivative"
        );
    }
}
