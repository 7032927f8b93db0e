//! What rides on any motion: a lever arm and vibration.

use super::channels::{angle, lever};
use crate::input::document::Section;
use crate::input::{Complaint, InputError, Range};
use crate::scene::keys::motion as keys;
use crate::scene::{Mounting, Vibration};

/// The unit in its vehicle.
pub fn read(section: &Section<'_>) -> Result<Mounting, InputError> {
    let lever_arm_m = match section.get(keys::LEVER_ARM.name) {
        None => [0.0; 3],
        Some(value) => {
            let accepted = "[forward, right, down], each from -1000 to 1000 m";
            let items = value.items(accepted)?;
            let [x, y, z] = items.as_slice() else {
                let what = format!("has {} values", items.len());
                return Err(value.error(Complaint::new(what, accepted)));
            };
            let metres = Range { accepted: "metres, from -1000 to 1000", ..keys::CHANNEL_LEVER };
            [x.number(&metres)?, y.number(&metres)?, z.number(&metres)?]
        }
    };
    let vibration = match section.table(keys::SHAKEN.name, &keys::VIBRATION)? {
        None => Vibration::default(),
        Some(section) => Vibration {
            roll: angle(&section, &keys::VIBRATION_ROLL)?,
            pitch: angle(&section, &keys::VIBRATION_PITCH)?,
            yaw: angle(&section, &keys::VIBRATION_YAW)?,
            forward: lever(&section, &keys::FORWARD)?,
            right: lever(&section, &keys::RIGHT)?,
            down: lever(&section, &keys::DOWN)?,
        },
    };
    Ok(Mounting { lever_arm_m, vibration })
}
