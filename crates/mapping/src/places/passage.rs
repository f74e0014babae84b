use cogmap_geometry::{DVec2, Metric, Segment};
use serde::{Deserialize, Serialize};

use super::{
    nearby::Near,
    trail::{Sample, Trail},
};

/// What makes a minimum of wideness an exit: narrower than both spaces that it joins (§3.2.2). The
/// thesis names no numbers; these are ours.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Narrowness {
    /// No exit is wider, metres.
    pub max_width: f64,
    /// On both sides of it the way gets so wide that it is at most this share of that …
    pub ratio: f64,
    /// … within so many metres of way.
    pub window: f64,
    /// No two exits lie nearer to each other along the way, metres.
    pub spacing: f64,
    /// The robot is at least this far beyond it when it is reported, metres.
    pub beyond: f64,
    /// It is reported within so many metres of way after the crossing or not at all.
    pub at_latest: f64,
    /// A wall that goes on outward from a jamb is worth so many metres of width (`recommended`; 0 in the
    /// literal form): with a wall on one side only, no exit is wider than the greatest width less that …
    pub jamb_bonus: f64,
    /// … and with a wall on fewer of its sides than this a narrow place is furniture (0 in the literal form).
    pub min_jambs: u8,
}

impl Default for Narrowness {
    fn default() -> Self {
        Self {
            max_width: 1.5,
            ratio: 0.7,
            window: 2.5,
            spacing: 1.2,
            beyond: 0.5,
            at_latest: 3.0,
            jamb_bonus: 0.0,
            min_jambs: 0,
        }
    }
}

/// How much a metre beside its chord costs a place, in metres of width.
const ASIDE: f64 = 0.2;

impl Narrowness {
    /// With walls beside an exit as evidence.
    pub(super) fn with_jambs() -> Self {
        Self { jamb_bonus: 0.48, min_jambs: 1, ..Self::default() }
    }

    /// How much of the way must be remembered, metres.
    pub(super) fn memory(&self) -> f64 {
        self.window + self.at_latest
    }
}

/// A narrow place that the robot has gone through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Passage {
    pub(super) way: f64,
    pub(super) at: DVec2,
    /// From the jamb on the left to the one on the right.
    pub(super) segment: Segment,
    /// The last view before it.
    pub(super) view: usize,
    pub(super) jambs: u8,
}

impl Passage {
    pub(super) fn width(&self) -> f64 {
        self.segment.length()
    }
}

/// The narrowest place between `since` and where the robot is now that it has gone through (Fig.
/// 3.14: wide, narrow, wide); it is known only now that it lies behind the robot.
pub(super) fn find(trail: &Trail, since: f64, robot: DVec2, params: &Narrowness) -> Option<Passage> {
    let samples = trail.samples();
    let newest = samples.back()?.way;
    let is_candidate = |sample: &&Sample| {
        sample.way >= since
            && sample.way >= newest - params.at_latest
            && sample.way <= newest - if is_plain(sample, params) { params.beyond } else { params.spacing }
            && rank(sample, params) <= params.max_width - 2.0 * params.jamb_bonus
            && sample.jambs >= params.min_jambs
            && gone_through(sample, trail, robot, params)
            && is_narrow(sample, trail, params)
            && is_least(sample, trail, params)
    };
    let best = samples
        .iter()
        .filter(is_candidate)
        .min_by(|a, b| rank_between(a, params).total_cmp(&rank_between(b, params)))?;
    Some(Passage {
        way: best.way,
        at: best.at,
        segment: best.chord.segment,
        view: best.view,
        jambs: best.jambs,
    })
}

/// Whether there is no need to see whether a better place follows: the literal form never does, the
/// recommended one not between two walls.
fn is_plain(sample: &Sample, params: &Narrowness) -> bool {
    params.jamb_bonus == 0.0 || sample.jambs == 2
}

/// What candidates are compared by: narrow, and between walls; less is better.
fn rank(sample: &Sample, params: &Narrowness) -> f64 {
    sample.chord.width - params.jamb_bonus * f64::from(sample.jambs)
}

/// The same of two places that share their jambs: better is the one that lies between them.
fn rank_between(sample: &Sample, params: &Narrowness) -> f64 {
    rank(sample, params) + ASIDE * sample.chord.segment.distance_to(sample.at)
}

/// Whether the robot came from one side and stands on the other: who turns back in a doorway has not
/// left the room.
fn gone_through(sample: &Sample, trail: &Trail, robot: DVec2, params: &Narrowness) -> bool {
    let Some(across) = sample.chord.segment.direction().map(DVec2::perp) else { return false };
    let forward = if across.dot(sample.direction) >= 0.0 { across } else { -across };
    let beyond = |point: DVec2| (point - sample.chord.segment.a).dot(forward);
    let before = trail
        .samples()
        .iter()
        .filter(|other| other.way < sample.way && other.way >= sample.way - params.window)
        .any(|other| beyond(other.at) <= -params.beyond.min(0.3));
    before && beyond(robot) >= params.beyond
}

/// Whether it gets wider on both sides.
fn is_narrow(sample: &Sample, trail: &Trail, params: &Narrowness) -> bool {
    let widest = |before: bool| {
        trail
            .samples()
            .iter()
            .filter(|other| (other.way < sample.way) == before)
            .filter(|other| (other.way - sample.way).abs() <= params.window)
            .map(|other| other.chord.width)
            .fold(0.0, f64::max)
    };
    sample.chord.width <= params.ratio * widest(true) && sample.chord.width <= params.ratio * widest(false)
}

/// Whether no place within the spacing is a better one.
fn is_least(sample: &Sample, trail: &Trail, params: &Narrowness) -> bool {
    trail
        .samples()
        .iter()
        .filter(|other| (other.way - sample.way).abs() < params.spacing)
        .all(|other| rank_between(other, params) >= rank_between(sample, params) - 1e-9)
}

/// A jamb is sought within this of where the chord through the way found it, metres.
const JAMB_ERROR: f64 = 0.5;

/// The narrowest chord between the two sides of the way near one that goes through a point of it: jambs face each
/// other, and the way need not lead right between them.
pub(super) fn narrowest_near(chord: Segment, at: DVec2, near: &[Near], debris: f64) -> Segment {
    let Some(right) = chord.direction() else { return chord };
    let nearest = |jamb: DVec2, other: DVec2, outward: DVec2| {
        let points = near
            .iter()
            .filter(|surface| surface.length >= debris)
            .map(|surface| surface.segment.closest_point(other));
        points
            .filter(|point| point.distance_from(jamb) <= JAMB_ERROR && (*point - at).dot(outward) > 0.0)
            .min_by(|a, b| a.distance_from(other).total_cmp(&b.distance_from(other)))
            .unwrap_or(jamb)
    };
    let mut best = chord;
    for _ in 0..3 {
        best.a = nearest(chord.a, best.b, -right);
        best.b = nearest(chord.b, best.a, right);
    }
    best
}

/// How far outward of a jamb its wall is looked for, metres.
const JAMB_REACH: f64 = 1.0;
/// How much of that must be wall, metres: a piece of furniture is less deep.
const JAMB_WALL: f64 = 0.45;
/// How far the wall may lie from the chord's line, metres: a wall has two faces.
const JAMB_OFFSET: f64 = 0.3;
/// How far it may be turned against the chord, as the cosine: 25°.
const JAMB_COS: f64 = 0.906;
/// Shares of the reach that are looked at.
const JAMB_CELLS: u32 = 20;

/// On how many sides of a chord a wall goes on outward along its line.
pub(super) fn jambs_of(chord: Segment, near: &[Near]) -> u8 {
    let Some(right) = chord.direction() else { return 0 };
    let goes_on = |jamb: DVec2, outward: DVec2| u8::from(wall_beyond(jamb, outward, near) >= JAMB_WALL);
    goes_on(chord.a, -right) + goes_on(chord.b, right)
}

/// Metres of wall outward of a jamb.
fn wall_beyond(jamb: DVec2, outward: DVec2, near: &[Near]) -> f64 {
    let mut covered = [false; JAMB_CELLS as usize];
    for surface in near {
        let Near { segment, direction: Some(direction), .. } = *surface else { continue };
        if direction.dot(outward).abs() < JAMB_COS || segment.distance_to(jamb) > JAMB_REACH + JAMB_OFFSET {
            continue;
        }
        for (cell, covered) in (0..JAMB_CELLS).zip(&mut covered).filter(|(_, covered)| !**covered) {
            let along = JAMB_REACH * (f64::from(cell) + 0.5) / f64::from(JAMB_CELLS);
            let point = jamb + outward * along;
            let share = segment.share_of(point);
            *covered = (0.0..=1.0).contains(&share) && segment.distance_to(point) <= JAMB_OFFSET;
        }
    }
    let cells: u32 = covered.iter().map(|&covered| u32::from(covered)).sum();
    JAMB_REACH * f64::from(cells) / f64::from(JAMB_CELLS)
}
