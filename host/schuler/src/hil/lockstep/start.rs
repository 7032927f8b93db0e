//! Starting a target, and restarting it at the state of its twin.

use super::super::conversation::Outcome;
use super::super::parted::{MOST_REBOOTS, Parted};
use super::super::reply::Reply;
use super::Lockstep;
use schuler::link::bytes::Bytes;
use schuler::link::message::{MOST_WORDS, Request};

impl Lockstep {
    /// Starts the target.
    pub(super) fn begin(&mut self) -> Result<Reply, Parted> {
        for _ in 0..MOST_REBOOTS {
            if let Some(reply) = self.try_to_begin()? {
                return Ok(reply);
            }
        }
        Err(Parted::Reboots)
    }

    /// A start, and the settings of the filter if there is one; `None` where the target was rebooted meanwhile.
    fn try_to_begin(&mut self) -> Result<Option<Reply>, Parted> {
        let start = Request::Start(self.beginning.start());
        let settings = self.beginning.settings().map(|settings| Request::Aid(Bytes(settings)));
        let mut last = None;
        for request in [Some(start), settings].into_iter().flatten() {
            match self.conversation.insist(&request, 0)? {
                Outcome::Answered(Reply::Standing(standing)) => {
                    last = Some(Reply::Standing(standing));
                }
                Outcome::Answered(other) => return Ok(Some(other)),
                Outcome::Silence => return Err(Parted::Silence("its start")),
                Outcome::Rebooted => return Ok(None),
            }
        }
        Ok(last)
    }

    /// Starts a target that has forgotten everything from its twin's state.
    pub(super) fn restore(&mut self) -> Result<(), Parted> {
        let words = self.twin.words();
        let all = (words.len() / 8) as u16;
        'again: for _ in 0..MOST_REBOOTS {
            match self.try_to_begin()? {
                Some(Reply::Standing(_)) => {}
                Some(_) => return Err(Parted::Answer("its start")),
                None => continue,
            }
            for (n, piece) in words.chunks(8 * MOST_WORDS).enumerate() {
                let offset = (n * MOST_WORDS) as u16;
                let request = Request::Restore { words: all, offset, piece: Bytes(piece) };
                match self.conversation.insist(&request, self.time_ns(self.reached))? {
                    Outcome::Answered(Reply::Restoring(_)) => {}
                    Outcome::Answered(Reply::Standing(standing)) => {
                        return self.compare(&standing);
                    }
                    Outcome::Answered(_) => return Err(Parted::Answer("its state")),
                    Outcome::Silence => return Err(Parted::Silence("its state")),
                    Outcome::Rebooted => continue 'again,
                }
            }
        }
        Err(Parted::Reboots)
    }
}
