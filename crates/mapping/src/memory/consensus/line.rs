use cogmap_geometry::{DVec2, Pose, Segment, normalize_angle, trig};

use crate::perception::{End, Surface};

/// Noise of a laser's range at least, metres: a fit through few points looks better than it is.
const NOISE_FLOOR: f64 = 0.01;

/// A straight piece of boundary prepared for alignment; `along` points counter-clockwise as seen
/// from its visible side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// Which surface it is: of the view, or of the map.
    pub(super) tag: u32,
    pub(super) a: DVec2,
    pub(super) along: DVec2,
    pub(super) heading: f64,
    pub(super) length: f64,
    pub(super) ends: [End; 2],
    /// Variance of its place across itself, square metres.
    pub(super) variance: f64,
    /// How far an end may lie from the true one because beams are sparse, metres.
    pub(super) spacing: f64,
    /// What it was told apart as by sight, where it was.
    pub(super) label: Option<u32>,
}

/// The lines of a view, in the robot's frame.
#[allow(clippy::cast_possible_truncation, reason = "a scan has a few hundred surfaces at most")]
pub(super) fn of_view(surfaces: &[Surface]) -> Vec<Line> {
    surfaces.iter().enumerate().filter_map(|(index, surface)| Line::of(index as u32, surface)).collect()
}

impl Line {
    #[allow(clippy::cast_precision_loss, reason = "a scan has a few hundred points")]
    fn of(tag: u32, surface: &Surface) -> Option<Self> {
        let Segment { a, .. } = surface.segment;
        let along = surface.segment.direction()?;
        let (heading, length) = (surface.segment.heading(), surface.length());
        let sigma = surface.residual.max(NOISE_FLOOR);
        let variance = 2.0 * sigma * sigma / surface.points.max(1) as f64;
        let spacing = length / (surface.points.max(2) - 1) as f64;
        Some(Self {
            tag,
            a,
            along,
            heading,
            length,
            ends: surface.ends,
            variance,
            spacing,
            label: surface.label,
        })
    }

    pub(super) fn b(&self) -> DVec2 {
        self.a + self.along * self.length
    }

    pub(super) fn end(&self, end: usize) -> DVec2 {
        if end == 0 { self.a } else { self.b() }
    }

    pub(super) fn point(&self, at: f64) -> DVec2 {
        self.a + self.along * at
    }

    pub(super) fn seen_from(&self, other_from_this: Pose) -> Self {
        let turn = other_from_this.forward();
        Self {
            a: other_from_this.position + turn.rotate(self.a),
            along: turn.rotate(self.along),
            heading: normalize_angle(self.heading + other_from_this.heading),
            ..*self
        }
    }

    /// How far it is turned against another, which faces the same way; `[0, π]` radians.
    pub(super) fn turn_to(&self, other: &Self) -> f64 {
        normalize_angle(self.heading - other.heading).abs()
    }

    /// Metres from the infinite line to a point, positive on its left.
    pub(super) fn across(&self, point: DVec2) -> f64 {
        self.along.perp_dot(point - self.a)
    }

    /// Metres along the line from its first end to a point.
    pub(super) fn at(&self, point: DVec2) -> f64 {
        self.along.dot(point - self.a)
    }

    /// Whether both may be of the same thing: two that were told apart by sight are not.
    pub(super) fn may_be(&self, other: &Self) -> bool {
        self.label.zip(other.label).is_none_or(|(mine, others)| mine == others)
    }

    /// The part of this line beside another, as metres along this one.
    pub(super) fn beside(&self, other: &Self) -> Option<(f64, f64)> {
        let (s, t) = (self.at(other.a), self.at(other.b()));
        let (from, to) = (s.min(t).max(0.0), s.max(t).min(self.length));
        (to > from).then_some((from, to))
    }

    /// How far the part of this line beside another lies from it, at most, metres; and that part.
    pub(super) fn gap(&self, other: &Self) -> Option<(f64, f64, f64)> {
        let (from, to) = self.beside(other)?;
        let gap = other.across(self.point(from)).abs().max(other.across(self.point(to)).abs());
        Some((gap, from, to))
    }

    /// Metres of this line that lie beside any of the others: nearer than `distance` and turned less
    /// than `angle`.
    pub(super) fn covered_by<'a>(
        &self,
        others: impl IntoIterator<Item = &'a Self>,
        distance: f64,
        angle: f64,
    ) -> f64 {
        let parallel = trig::cos(angle);
        let mut parts: Vec<(f64, f64)> = others
            .into_iter()
            .filter(|other| self.along.dot(other.along) > parallel)
            .filter_map(|other| self.gap(other))
            .filter(|(gap, ..)| *gap < distance)
            .map(|(_, from, to)| (from, to))
            .collect();
        parts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut covered, mut until) = (0.0, 0.0_f64);
        for (from, to) in parts {
            covered += (to - from.max(until)).max(0.0);
            until = until.max(to);
        }
        covered
    }
}
