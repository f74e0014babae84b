use std::sync::Arc;

use cogmap_geometry::{DVec2, Metric, Pose, trig};
use serde::{Deserialize, Serialize};

use crate::perception::Scan;

/// About so many of a scan's beams are held against another scan …
const BEAMS: usize = 90;

/// When what two scans saw of free space contradicts itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct FreeSpace {
    /// A surface stands in what was seen free when it is nearer than the beam went by this, metres …
    pub margin: f64,
    /// … and this share of its range.
    pub margin_per_range: f64,
}

impl Default for FreeSpace {
    fn default() -> Self {
        Self { margin: 0.25, margin_per_range: 0.03 }
    }
}

/// What one scan saw of free space: how far each of its beams went, and from where.
#[derive(Clone, Debug)]
pub(super) struct Look {
    /// Where the laser was, in the frame that the look is kept in.
    pub(super) frame_from_laser: Pose,
    angle_min: f64,
    spacing: f64,
    /// … each against all beams of that within the angle between two of them, as an index.
    stride: usize,
    /// Metres; 0 where a beam saw nothing, which tells nothing.
    ranges: Arc<[f64]>,
    /// Where the beams ended that are held against others, in the laser's frame.
    points: Arc<[DVec2]>,
}

/// How far two looks, or more, bear each other out, in beams.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Agreement {
    /// Beams that end where the other look saw something end as well.
    pub(super) agreeing: u32,
    /// Beams that end where the other look saw free space.
    pub(super) contradicting: u32,
}

enum Verdict {
    Agrees,
    Contradicts,
    CannotTell,
}

impl Look {
    pub(super) fn of(scan: &Scan) -> Self {
        let stride = (scan.ranges.len() / BEAMS).max(1);
        let beams = 0..scan.ranges.len();
        Self {
            frame_from_laser: scan.robot_from_laser,
            angle_min: scan.angle_min,
            spacing: scan.angle_increment,
            stride,
            ranges: beams.clone().map(|beam| scan.range(beam).unwrap_or(0.0)).collect(),
            points: beams.step_by(stride).filter_map(|beam| scan.point(beam)).collect(),
        }
    }

    /// The same look in another frame.
    pub(super) fn seen_from(&self, other_from_this: Pose) -> Self {
        Self { frame_from_laser: other_from_this * self.frame_from_laser, ..self.clone() }
    }

    /// What this look and another in the same frame say of each other.
    pub(super) fn agreement(&self, other: &Self, params: &FreeSpace) -> Agreement {
        let mut agreement = Agreement::default();
        for (of, by) in [(self, other), (other, self)] {
            let by_from_of = by.frame_from_laser.from_here(of.frame_from_laser);
            let turn = by_from_of.forward();
            for &point in of.points.iter() {
                match by.judge(by_from_of.position + turn.rotate(point), params) {
                    Verdict::Agrees => agreement.agreeing += 1,
                    Verdict::Contradicts => agreement.contradicting += 1,
                    Verdict::CannotTell => {}
                }
            }
        }
        agreement
    }

    /// What this look says of something seen there, in its laser's frame.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        clippy::cast_sign_loss,
        reason = "checked to be within the scan"
    )]
    fn judge(&self, point: DVec2, params: &FreeSpace) -> Verdict {
        let beam = ((trig::atan2(point.y, point.x) - self.angle_min) / self.spacing).round();
        let stride = self.stride as f64;
        if !(stride..(self.ranges.len() as f64 - stride)).contains(&beam) {
            return Verdict::CannotTell;
        }
        let beside = &self.ranges[beam as usize - self.stride..=beam as usize + self.stride];
        let (nearest, farthest) = beside
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(least, most), &range| (least.min(range), most.max(range)));
        let range = point.norm();
        let margin = params.margin + params.margin_per_range * range;
        if nearest <= 0.0 || range > farthest + margin {
            Verdict::CannotTell
        } else if range < nearest - margin {
            Verdict::Contradicts
        } else {
            Verdict::Agrees
        }
    }
}

impl Agreement {
    /// The beams that contradict, as a share of those that tell anything.
    pub(super) fn contradiction(&self) -> f64 {
        let all = self.evidence();
        if all == 0 { 0.0 } else { f64::from(self.contradicting) / f64::from(all) }
    }

    /// How many beams tell anything.
    pub(super) fn evidence(&self) -> u32 {
        self.agreeing + self.contradicting
    }
}

impl std::iter::Sum for Agreement {
    fn sum<Items: Iterator<Item = Self>>(items: Items) -> Self {
        items.fold(Self::default(), |sum, item| Self {
            agreeing: sum.agreeing + item.agreeing,
            contradicting: sum.contradicting + item.contradicting,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a robot sees from a place in a square room from -`half` to `half`.
    fn room(half: f64, at: Pose) -> Look {
        let ranges = (0..181).map(|beam| {
            let (sin, cos) = trig::sin_cos(at.heading + f64::from(beam - 90).to_radians());
            let to = |start: f64, slope: f64| {
                if slope > 0.0 { (half - start) / slope } else { (half + start) / -slope }
            };
            to(at.position.x, cos).min(to(at.position.y, sin))
        });
        let scan = Scan {
            robot_from_laser: Pose::IDENTITY,
            angle_min: -trig::FRAC_PI_2,
            angle_increment: trig::PI / 180.0,
            range_max: 20.0,
            ranges: ranges.collect(),
            labels: Vec::new(),
        };
        Look::of(&scan).seen_from(at)
    }

    #[test]
    fn two_looks_into_one_room_agree() {
        let looks = room(3.0, Pose::new(0.5, 0.2, 0.3))
            .agreement(&room(3.0, Pose::new(-0.6, 1.0, 1.2)), &FreeSpace::default());
        assert!(looks.evidence() > 60 && looks.contradicting == 0, "{looks:?}");
    }

    #[test]
    fn looks_into_rooms_of_different_size_contradict() {
        let (small, large) = (room(1.5, Pose::IDENTITY), room(3.0, Pose::IDENTITY));
        for looks in
            [small.agreement(&large, &FreeSpace::default()), large.agreement(&small, &FreeSpace::default())]
        {
            assert!(looks.contradiction() > 0.9, "{looks:?}");
        }
    }
}
