use std::collections::BTreeSet;

use cogmap_geometry::{DVec2, Segment};

use super::{AsrId, ExitId, Now, Places, sight};
use crate::memory::{Memory, SurfaceId};

/// A line of sight is followed through so many exits.
const EXITS_IN_A_ROW: usize = 3;

impl Places {
    /// Gives the surfaces of a view to the space that they were seen in: the robot's own, or one behind
    /// a known exit that they were seen through.
    pub(super) fn share_out(&mut self, now: Now<'_>) {
        for &id in &now.report.placed {
            let current = self.network.current();
            let asr = self.first_sight(now.memory, id).map_or(current, |(eye, surface)| {
                self.space_in_sight((current, None), eye, surface, EXITS_IN_A_ROW)
            });
            self.network.assign(id, asr);
        }
    }

    /// From where a surface was first seen, and where it lies, in the robot's frame.
    pub(super) fn first_sight(&self, memory: &Memory, id: SurfaceId) -> Option<(DVec2, Segment)> {
        let stored = memory.mfis().get(id)?;
        let surface = self.nearby.here_from(stored.frame)? * stored.segment;
        Some((self.here_from_robot_at(memory, stored.step)?.position, surface))
    }

    /// The space that a surface belongs to when it is seen from inside a space: behind the first exit
    /// that the line of sight goes through, and so on.
    fn space_in_sight(
        &self,
        (asr, entered): (AsrId, Option<ExitId>),
        eye: DVec2,
        surface: Segment,
        left: usize,
    ) -> AsrId {
        let near_exits = self.network.asr(asr).into_iter().flat_map(|asr| &asr.exits);
        let behind = near_exits
            .filter(|&&exit| Some(exit) != entered)
            .filter_map(|&exit| self.network.exit(exit))
            .find_map(|exit| {
                let segment = self.nearby.here_from(exit.frame)? * exit.segment;
                let other = exit.leads_from(asr).filter(|&other| other != asr)?;
                sight::is_behind(segment, eye, surface).then_some((other, Some(exit.id)))
            });
        match (behind, left) {
            (Some(next), 1..) => self.space_in_sight(next, eye, surface, left - 1),
            _ => asr,
        }
    }

    /// Of the surfaces recognised since a view, those of the space left behind that the robot sees from nearer than
    /// at first sight, and not back through the exit, belong where it is (ours): they had been seen through
    /// another opening. The thesis's rule of the line of sight (§3.2.2), applied from the other side.
    pub(super) fn claim(&mut self, now: Now<'_>, exit: Segment, (left, into): (AsrId, AsrId), since: usize) {
        let here = now.here.frame_from_robot.position;
        let belongs_here = |id: &SurfaceId| {
            self.first_sight(now.memory, *id).is_some_and(|(eye, surface)| {
                surface.distance_to(here) < surface.distance_to(eye)
                    && !sight::is_behind(exit, here, surface)
                    && exit
                        .offset_of(surface.midpoint())
                        .zip(exit.offset_of(here))
                        .is_some_and(|(a, b)| a * b > 0.0)
            })
        };
        let recognised = self.sightings.since(since).filter(|&id| self.network.asr_of(id) == Some(left));
        let claimed: BTreeSet<SurfaceId> = recognised.filter(belongs_here).collect();
        for surface in claimed {
            self.network.assign(surface, into);
        }
    }

    /// The surfaces of a space that belong behind an exit (§3.2.2, Fig. 3.15): those seen since the robot
    /// went through it, but for what it saw looking back, and those seen through it before.
    pub(super) fn behind(
        &self,
        memory: &Memory,
        (left, crossed): (AsrId, usize),
        exit: Segment,
    ) -> Vec<SurfaceId> {
        let belongs_behind = |&id: &SurfaceId| {
            let Some(stored) = memory.mfis().get(id) else { return false };
            let Some((eye, surface)) = self.first_sight(memory, id) else { return stored.step > crossed };
            let through = sight::is_behind(exit, eye, surface);
            if stored.step > crossed { !through } else { through }
        };
        self.network.surfaces_of(left).iter().copied().filter(belongs_behind).collect()
    }
}
