//! What a part is of: parts of one ensemble agree in all but the shard.

use super::super::group::Ground;
use crate::scene::Scene;
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};
use std::fmt::{self, Write as _};
use std::ops::Range;

/// What the first line says the file is.
pub const KIND: &str = "part of a schuler ensemble";
/// The form of the file.
pub const FORM: u32 = 1;

/// The first line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Header {
    /// [`KIND`].
    pub kind: String,
    /// [`FORM`].
    pub form: u32,
    /// The version of the program.
    pub version: String,
    /// The command that flies the whole, an argument each, after the program's name.
    pub command: Vec<String>,
    /// The scene's name.
    pub scene: String,
    /// SHA-256 of its text.
    pub scene_sha256: String,
    /// SHA-256 of all that decides on the bits: motion, sensors, start, navigator with its window.
    pub flown_sha256: String,
    /// The seed.
    pub seed: u64,
    /// Runs of the whole.
    pub runs: u64,
    /// K of N: this part, from 1, and how many there are.
    pub shard: [u64; 2],
    /// Samples taken at each reading.
    pub stops: Vec<u64>,
    /// Whether its runs are aided: then each has what its filter says, too.
    #[serde(default, skip_serializing_if = "is_false")]
    pub aided: bool,
}

impl Header {
    /// Of a shard of an ensemble.
    pub fn new(
        ground: &Ground,
        command: Vec<String>,
        runs: u64,
        shard: [u64; 2],
        stops: &[u64],
    ) -> Self {
        let scene = ground.scene;
        Self {
            kind: KIND.to_owned(),
            form: FORM,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            command,
            scene: scene.name.clone(),
            scene_sha256: scene.text_sha256.clone(),
            flown_sha256: flown(ground),
            seed: scene.seed,
            runs,
            shard,
            stops: stops.to_vec(),
            aided: scene.aiding.is_there(),
        }
    }

    /// The numbers of the shard's runs.
    pub fn range(&self) -> Range<u64> {
        shard(self.runs, self.shard)
    }

    /// In what a part is of another ensemble than this one: the first difference, for people, as what it is there
    /// and here.
    pub fn difference(&self, other: &Self) -> Option<String> {
        let differ = |what: &str, there: &dyn fmt::Display, here: &dyn fmt::Display| {
            Some(format!("is of another ensemble: {what} {there}, here {here}"))
        };
        if self.version != other.version {
            return differ("it is by schuler", &self.version, &other.version);
        }
        if self.scene_sha256 != other.scene_sha256 {
            let [there, here] =
                [self, other].map(|h| format!("{} (SHA-256 {:.12}…)", h.scene, h.scene_sha256));
            return differ("its scene is", &there, &here);
        }
        if self.seed != other.seed {
            return differ("its seed is", &self.seed, &other.seed);
        }
        if self.runs != other.runs {
            return differ("it has runs in all:", &self.runs, &other.runs);
        }
        if self.shard[1] != other.shard[1] {
            return differ("its shards are", &self.shard[1], &other.shard[1]);
        }
        if self.flown_sha256 != other.flown_sha256 {
            let [there, here] = [self, other].map(|h| format!("`schuler {}`", h.command.join(" ")));
            return differ("its flight has other options or other files:", &there, &here);
        }
        if self.stops != other.stops {
            let [there, here] = [self, other].map(|h| format!("{:?}", h.stops));
            return differ("it is read at samples", &there, &here);
        }
        None
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands a reference")]
fn is_false(it: &bool) -> bool {
    !it
}

/// The numbers of the runs of shard K of N: as many in each, to one.
pub fn shard(runs: u64, [k, n]: [u64; 2]) -> Range<u64> {
    let bound = |k: u64| (u128::from(runs) * u128::from(k) / u128::from(n.max(1))) as u64;
    bound(k.saturating_sub(1))..bound(k)
}

/// SHA-256 of what decides on the bits, by its complete text.
fn flown(ground: &Ground) -> String {
    let nameless =
        Scene { name: String::new(), title: String::new(), ..Scene::clone(ground.scene) };
    let mut hasher = Hasher(Sha256::new());
    // A hash takes all that is written.
    let _ = write!(hasher, "{nameless:?} {:?}", ground.plan.window);
    hex(&hasher.0.finalize())
}

/// Bytes as hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

struct Hasher(Sha256);

impl fmt::Write for Hasher {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.update(text.as_bytes());
        Ok(())
    }
}
