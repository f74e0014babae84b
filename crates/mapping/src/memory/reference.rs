use cogmap_geometry::{DVec2, Metric, Pose, Segment, line_angle_between, normalize_angle, trig};
use serde::{Deserialize, Serialize};

use super::{Match, Mfis, StoredSurface, SurfaceId, matching::end_of};
use crate::perception::{End, Surface};

/// What makes a recognised surface a good reference target (§3.2.3, after Fig. 3.18: length,
/// distance and orientation). Only quantities free of odometry enter, so that two odometry streams
/// that lead to the same matches choose the same reference. The formula is ours; the thesis gives none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ReferenceQuality {
    /// What makes one pair better than another.
    pub rule: ReferenceRule,
    /// Recognised surfaces shorter than this, in either sighting, are no candidates, metres.
    pub min_length: f64,
    /// A range below this counts as this, metres: very near is no better than near.
    pub range_floor: f64,
    /// Two true ends whose lengths disagree by this much halve the quality, metres.
    pub length_agreement: f64,
    /// Lines turned less than this against each other cannot fix each other's place, radians.
    pub crossing_angle: f64,
    /// Candidates whose robot lies farther than this from where half of them put it are set aside, metres.
    pub agreement: f64,
    /// Factor on the quality of a reference whose place along its line is a guess.
    pub weak: f64,
}

impl Default for ReferenceQuality {
    fn default() -> Self {
        Self {
            rule: ReferenceRule::Quality,
            min_length: 0.3,
            range_floor: 2.0,
            length_agreement: 0.1,
            crossing_angle: 30.0 * trig::PI / 180.0,
            agreement: 0.25,
            weak: 0.1,
        }
    }
}

/// Which recognised pair becomes the reference target.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ReferenceRule {
    /// A long, near surface seen squarely: the thesis's program after the failure of Fig. 3.17.
    #[default]
    Quality,
    /// The closest-matching pair, as before that failure (§3.2.1, step 6). How closely two sightings match
    /// depends on the rough movement, so odometry has a say in the choice, though not in the placing.
    ClosestPair,
}

/// What fixes the place along the reference's own line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Along {
    /// The first end: a true end in both sightings.
    FirstEnd,
    /// The second end: a true end in both sightings.
    SecondEnd,
    /// Another recognised surface that crosses its line.
    Crossing(SurfaceId),
    /// An end that may be another spot of the object each time (the flaw of Fig. 3.17).
    GuessedEnd,
}

/// A pair that can serve as reference target: a surface of the view and what it is in the map.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Which surface of the current view.
    pub seen: usize,
    /// Which surface of the map.
    pub known: SurfaceId,
    /// What the choice goes by; higher is better, without unit.
    pub quality: f64,
    /// What fixes the place along its line.
    pub along: Along,
    /// Where the robot is if this pair is trusted: measuring a surface relative to the reference in
    /// the view and copying distance and angle to the map is the same as chaining this pose.
    pub map_from_robot: Pose,
}

/// A recognised pair, its two versions side by side.
struct Pair<'a> {
    seen_index: usize,
    seen: &'a Surface,
    known: &'a StoredSurface,
    quality: f64,
}

/// §3.2.1 step 6: every pair that can serve as reference target, best first.
#[must_use]
pub fn rank_references(
    view: &[Surface],
    matches: &[Match],
    mfis: &Mfis,
    params: &ReferenceQuality,
) -> Vec<Reference> {
    let by_quality = params.rule == ReferenceRule::Quality;
    let pairs: Vec<Pair<'_>> = matches
        .iter()
        .filter_map(|m| Some((m, view.get(m.seen)?, mfis.get(m.known)?)))
        .filter(|(_, seen, known)| {
            !by_quality || seen.length().min(known.segment.length()) >= params.min_length
        })
        .map(|(m, seen, known)| Pair {
            seen_index: m.seen,
            seen,
            known,
            quality: if by_quality { quality(seen, known, params) } else { 1.0 / m.fit.error },
        })
        .collect();
    let mut references: Vec<Reference> =
        pairs.iter().filter_map(|pair| reference(pair, &pairs, params)).collect();
    if by_quality {
        set_aside_outliers(&mut references, params);
    }
    references.sort_by(|a, b| b.quality.total_cmp(&a.quality).then(a.seen.cmp(&b.seen)));
    references
}

/// Length over range, less where the surface was seen at a glance or its two lengths disagree.
fn quality(seen: &Surface, known: &StoredSurface, params: &ReferenceQuality) -> f64 {
    let length = seen.length().min(known.segment.length());
    let facing = trig::cos(seen.incidence);
    let both_true = [&seen.ends, &known.ends].iter().all(|ends| **ends == [End::True; 2]);
    let disagreement = if both_true { (seen.length() - known.segment.length()).abs() } else { 0.0 };
    let agreement = params.length_agreement / (params.length_agreement + disagreement);
    length * facing.max(0.05) * agreement / seen.range.max(params.range_floor)
}

fn reference(pair: &Pair<'_>, pairs: &[Pair<'_>], params: &ReferenceQuality) -> Option<Reference> {
    let heading = normalize_angle(pair.known.segment.heading() - pair.seen.segment.heading());
    let (along, position, factor) = match shared_true_end(pair) {
        Some(end) => {
            let along = if end == 0 { Along::FirstEnd } else { Along::SecondEnd };
            (along, position_by_end(pair, end, heading), 1.0)
        }
        None => match crossing_partner(pair, pairs, params) {
            Some(partner) => {
                (Along::Crossing(partner.known.id), position_by_crossing(pair, partner, heading)?, 1.0)
            }
            None => {
                let factor = if params.rule == ReferenceRule::Quality { params.weak } else { 1.0 };
                (Along::GuessedEnd, position_by_end(pair, guessed_end(pair)?, heading), factor)
            }
        },
    };
    Some(Reference {
        seen: pair.seen_index,
        known: pair.known.id,
        quality: pair.quality * factor,
        along,
        map_from_robot: Pose { position, heading },
    })
}

/// The end that both sightings saw as a true end; of two, the one nearer to the robot.
fn shared_true_end(pair: &Pair<'_>) -> Option<usize> {
    let nearness = |end: usize| end_of(pair.seen.segment, end).norm();
    (0..2)
        .filter(|&end| pair.seen.ends[end] == End::True && pair.known.ends[end] == End::True)
        .min_by(|&a, &b| nearness(a).total_cmp(&nearness(b)))
}

/// An end that is no limit of the sensor: something to hold on to, if a poor one. A corridor's walls
/// have none, and there the thesis's robot was lost (§3.2.3).
fn guessed_end(pair: &Pair<'_>) -> Option<usize> {
    let nearness = |end: usize| end_of(pair.seen.segment, end).norm();
    (0..2)
        .filter(|&end| pair.seen.ends[end] != End::RangeLimit && pair.known.ends[end] != End::RangeLimit)
        .min_by(|&a, &b| nearness(a).total_cmp(&nearness(b)))
}

fn position_by_end(pair: &Pair<'_>, end: usize, heading: f64) -> DVec2 {
    let turned = Pose::new(0.0, 0.0, heading).rotate(end_of(pair.seen.segment, end));
    end_of(pair.known.segment, end) - turned
}

fn crossing_partner<'a>(
    pair: &Pair<'_>,
    pairs: &'a [Pair<'a>],
    params: &ReferenceQuality,
) -> Option<&'a Pair<'a>> {
    let angle = |a: Segment, b: Segment| line_angle_between(a.heading(), b.heading());
    pairs
        .iter()
        .filter(|other| angle(pair.seen.segment, other.seen.segment) >= params.crossing_angle)
        .filter(|other| angle(pair.known.segment, other.known.segment) >= params.crossing_angle)
        .max_by(|a, b| a.quality.total_cmp(&b.quality).then(b.seen_index.cmp(&a.seen_index)))
}

/// Slides the reference along its own line until the partner's sighting lies on the partner's line.
fn position_by_crossing(pair: &Pair<'_>, partner: &Pair<'_>, heading: f64) -> Option<DVec2> {
    let turn = Pose::new(0.0, 0.0, heading);
    let start = pair.known.segment.a - turn.rotate(pair.seen.segment.a);
    let along = pair.known.segment.direction()?;
    let partner_seen = start + turn.rotate(partner.seen.segment.midpoint());
    let offset = partner.known.segment.offset_of(partner_seen)?;
    let slope = partner.known.segment.direction()?.perp_dot(along);
    Some(start - along * (offset / slope))
}

/// A wrongly recognised pair puts the robot where the others do not: candidates that disagree with
/// the median place are dropped, if at least three speak. (Used by later programs of the same
/// laboratory; needs no odometry.)
fn set_aside_outliers(references: &mut Vec<Reference>, params: &ReferenceQuality) {
    let sure: Vec<DVec2> = references
        .iter()
        .filter(|r| r.along != Along::GuessedEnd)
        .map(|r| r.map_from_robot.position)
        .collect();
    if sure.len() < 3 {
        return;
    }
    let median = DVec2::new(median_of(sure.iter().map(|p| p.x)), median_of(sure.iter().map(|p| p.y)));
    references.retain(|r| r.map_from_robot.position.distance_from(median) <= params.agreement);
}

fn median_of(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests;
