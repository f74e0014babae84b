use cogmap_geometry::{DVec2, Segment};

use super::Disc;

/// Metres from the world's origin beyond which nothing is met: no coordinate
/// there has a millimetre left.
const WORLD_MAX: f64 = 1e9;

/// Anything a beam can meet.
#[derive(Clone, Copy)]
pub(super) enum Solid {
    Segment(Segment),
    Disc(Disc),
}

impl Solid {
    /// Segments first, then discs: the order that [`super::Hit::solid`] counts in.
    pub(super) fn all(segments: &[Segment], discs: &[Disc]) -> Vec<Self> {
        let segments = segments.iter().copied().map(Self::Segment);
        segments.chain(discs.iter().copied().map(Self::Disc)).collect()
    }

    /// Lowest and highest corner of the box around it; `None` for what cannot be
    /// met: numbers that are not finite or far out of any world.
    pub(super) fn bounds(&self) -> Option<[DVec2; 2]> {
        let (low, high) = match self {
            Self::Segment(s) => (s.a.min(s.b), s.a.max(s.b)),
            Self::Disc(d) => (d.center - d.radius, d.center + d.radius),
        };
        let finite = match self {
            Self::Segment(s) => s.a.is_finite() && s.b.is_finite(),
            Self::Disc(d) => d.center.is_finite() && d.radius >= 0.0,
        };
        (finite && low.min_element() > -WORLD_MAX && high.max_element() < WORLD_MAX).then_some([low, high])
    }

    /// Lowest and highest coordinate across `axis` (0 for x, 1 for y) of the part
    /// whose coordinate along it is in `low..=high`.
    pub(super) fn across(&self, axis: usize, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
        match self {
            Self::Segment(s) => segment_across(s.a.to_array(), s.b.to_array(), axis, [low, high]),
            Self::Disc(d) => {
                let (along, across) = (d.center.to_array()[axis], d.center.to_array()[1 - axis]);
                let away = along - along.clamp(low, high);
                let half = (d.radius * d.radius - away * away).max(0.0).sqrt();
                (away.abs() <= d.radius).then_some([across - half, across + half])
            }
        }
    }
}

fn segment_across(a: [f64; 2], b: [f64; 2], axis: usize, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
    let run = b[axis] - a[axis];
    let (from, to) = (a[1 - axis], b[1 - axis]);
    let share = |at: f64| if run == 0.0 { 0.0 } else { ((at - a[axis]) / run).clamp(0.0, 1.0) };
    let meets = a[axis].min(b[axis]) <= high && a[axis].max(b[axis]) >= low;
    let [first, second] = match run == 0.0 {
        true => [from, to],
        false => [low, high].map(|at| from + (to - from) * share(at)),
    };
    meets.then_some([first.min(second), first.max(second)])
}
