use cogmap_geometry::trig::{PI, TAU};

use super::line::Line;

/// How many sectors of headings the lines are sorted into.
const SECTORS: usize = 24;

/// Remembered lines in one frame, sorted by heading: what could be parallel to a line is found
/// without looking at the rest.
#[derive(Clone, Debug)]
pub(super) struct Known {
    sectors: Vec<Vec<Line>>,
}

impl Default for Known {
    fn default() -> Self {
        Self { sectors: vec![Vec::new(); SECTORS] }
    }
}

impl Known {
    pub(super) fn add(&mut self, line: Line) {
        self.sectors[sector_of(line.heading)].push(line);
    }

    /// The lines turned less than `angle` against a heading, and a few more.
    pub(super) fn facing(&self, heading: f64, angle: f64) -> impl Iterator<Item = &Line> {
        let first = sector_of(heading - angle);
        let last = sector_of(heading + angle);
        let count = if 2.0 * angle >= TAU * (SECTORS - 1) as f64 / SECTORS as f64 {
            SECTORS
        } else {
            (last + SECTORS - first) % SECTORS + 1
        };
        (0..count).flat_map(move |step| &self.sectors[(first + step) % SECTORS])
    }

    pub(super) fn all(&self) -> impl Iterator<Item = &Line> {
        self.sectors.iter().flatten()
    }
}

impl FromIterator<Line> for Known {
    fn from_iter<Lines: IntoIterator<Item = Line>>(lines: Lines) -> Self {
        let mut known = Self::default();
        for line in lines {
            known.add(line);
        }
        known
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the share is from 0 to 1")]
fn sector_of(heading: f64) -> usize {
    let share = (heading + PI) / TAU;
    ((share - share.floor()) * SECTORS as f64) as usize % SECTORS
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::{DVec2, normalize_angle, trig};
    use proptest::prelude::*;

    use super::*;
    use crate::perception::End;

    fn line(heading: f64) -> Line {
        let (sin, cos) = trig::sin_cos(heading);
        Line {
            tag: 0,
            a: DVec2::ZERO,
            along: DVec2::new(cos, sin),
            heading,
            length: 1.0,
            ends: [End::True; 2],
            variance: 1e-4,
            spacing: 0.01,
            label: None,
        }
    }

    proptest! {
        #[test]
        fn nothing_parallel_is_missed(
            headings in prop::collection::vec(-PI..PI, 1..30), towards in -PI..PI, angle in 0.0f64..3.2,
        ) {
            let known: Known = headings.iter().map(|&heading| line(heading)).collect();
            let parallel = |heading: f64| normalize_angle(heading - towards).abs() <= angle - 1e-9;
            let found = known.facing(towards, angle).filter(|line| parallel(line.heading)).count();
            prop_assert_eq!(found, headings.iter().filter(|heading| parallel(**heading)).count());
            prop_assert_eq!(known.all().count(), headings.len());
        }
    }
}
