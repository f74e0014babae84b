use cogmap_geometry::Pose;
use cogmap_mapping::perception::Moment;

use super::{Session, drive::Drive, feed::Feed};
use crate::{BoxObstacle, Command, Disc, Noise, Solids, TICK, World};

/// What only the simulation knows; nothing of it for logs.
impl Session {
    pub(super) fn driven(&self) -> Option<&Drive> {
        match &self.live.feed {
            Feed::Drive(drive) => Some(drive),
            Feed::Log { .. } => None,
        }
    }

    /// The building as it is now.
    #[must_use]
    pub fn world(&self) -> Option<&World> {
        self.driven().map(Drive::world)
    }

    /// The boxes by their numbers; `None` where one was taken away.
    #[must_use]
    pub fn boxes(&self) -> &[Option<BoxObstacle>] {
        self.driven().map_or(&[], Drive::boxes)
    }

    /// The people, where they are now.
    #[must_use]
    pub fn people(&self) -> &[Disc] {
        self.driven().map_or(&[], Drive::people)
    }

    /// How large the robot's errors are now, in multiples of its own.
    #[must_use]
    pub fn noise(&self) -> Noise {
        self.driven().map(Drive::noise).unwrap_or_default()
    }

    /// The building as the laser and the body meet it.
    #[must_use]
    pub fn solids(&self) -> Option<&Solids> {
        self.driven().map(Drive::solids)
    }

    /// Where the robot truly is.
    #[must_use]
    pub fn world_from_robot(&self) -> Option<Pose> {
        self.driven().map(Drive::world_from_robot)
    }

    /// When the robot was picked up and set down elsewhere so far, seconds: between the looks before and after
    /// such a moment it did not drive.
    #[allow(clippy::cast_precision_loss, reason = "no run lasts 2^53 ticks")]
    pub fn times_carried(&self) -> impl Iterator<Item = f64> {
        let so_far = self.record.commands().iter().take_while(|timed| timed.tick < self.position());
        let carried = so_far.filter(|timed| matches!(timed.command, Command::Kidnap { .. }));
        carried.map(|timed| timed.tick as f64 * TICK)
    }

    /// How the robot was moving when the laser saw what it saw last.
    #[must_use]
    pub fn last_moment(&self) -> Option<Moment> {
        self.driven().and_then(Drive::last_moment)
    }

    /// Which solid each beam of the last scan truly measured.
    #[must_use]
    pub fn last_beam_solids(&self) -> Option<&[Option<u32>]> {
        self.driven().and_then(Drive::last_beam_solids)
    }
}
