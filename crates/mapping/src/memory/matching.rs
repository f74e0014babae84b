use cogmap_geometry::{Metric, Pose, Segment, normalize_angle, trig};
use serde::{Deserialize, Serialize};

use super::{SurfaceId, Tracked};
use crate::perception::{End, Surface};

/// How far apart two sightings may be and still be one surface (§3.1.3, Fig. 3.4).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Matching {
    /// Largest end-point distance of a pair, metres.
    pub distance: f64,
    /// Largest difference of orientation of a pair, radians.
    pub angle: f64,
    /// Added to both end-point distances before multiplying, metres: without it two lines that share
    /// one end would fit perfectly.
    pub distance_floor: f64,
    /// Added to the difference of orientation, radians: without it any parallel pair would.
    pub angle_floor: f64,
    /// Factor on both gates where the two sightings carry the same label (ours): what is told apart by
    /// sight need not be near to where it was expected.
    pub label_reach: f64,
}

impl Default for Matching {
    fn default() -> Self {
        Self {
            distance: 0.5,
            angle: 15.0 * trig::PI / 180.0,
            distance_floor: 0.05,
            angle_floor: 0.02,
            label_reach: 4.0,
        }
    }
}

/// How badly two surfaces fit (Fig. 3.4).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PairError {
    /// Distance of their first ends, metres.
    pub d1: f64,
    /// Distance of their second ends, metres.
    pub d2: f64,
    /// Difference of orientation, radians.
    pub phi: f64,
    /// `(d1 + a) (d2 + a) (φ + b)`: the thesis's product with its special cases taken care of.
    pub error: f64,
}

/// A surface of the current view that was recognised.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Match {
    /// Which surface of the current view.
    pub seen: usize,
    /// Which surface of the previous view; `None` where the view was compared with the map itself.
    pub previous: Option<usize>,
    /// The surface of the map that it is, by descent from its first sighting.
    pub known: SurfaceId,
    /// How well the two sightings fit under the rough movement.
    pub fit: PairError,
}

/// The error of a pair in one frame. An end that either sighting did not see as a true end says
/// nothing about where the object ends, so its distance is measured across the line only.
#[must_use]
pub fn pair_error(seen: &Surface, known: &Tracked, params: &Matching) -> PairError {
    let (d1, d2) = (end_distance(seen, known, 0), end_distance(seen, known, 1));
    fit(d1, d2, turned(seen, known), params)
}

/// The error of a pair that passes the gates. Most pairs fail at their first end.
fn error_within(gates: &Matching, seen: &Surface, known: &Tracked, params: &Matching) -> Option<PairError> {
    let near = |end: usize| Some(end_distance(seen, known, end)).filter(|&d| d <= gates.distance);
    let (d1, d2) = (near(0)?, near(1)?);
    let phi = turned(seen, known);
    (phi <= gates.angle).then(|| fit(d1, d2, phi, params))
}

fn fit(d1: f64, d2: f64, phi: f64, params: &Matching) -> PairError {
    let error = (d1 + params.distance_floor) * (d2 + params.distance_floor) * (phi + params.angle_floor);
    PairError { d1, d2, phi, error }
}

fn turned(seen: &Surface, known: &Tracked) -> f64 {
    normalize_angle(seen.segment.heading() - known.segment.heading()).abs()
}

fn end_distance(seen: &Surface, known: &Tracked, end: usize) -> f64 {
    let (own, other) = (end_of(seen.segment, end), end_of(known.segment, end));
    if seen.ends[end] == End::True && known.ends[end] == End::True {
        return own.distance_from(other);
    }
    let (to_known, to_seen) = (known.segment.distance_to(own), seen.segment.distance_to(other));
    to_known.min(to_seen)
}

pub(super) fn end_of(segment: Segment, end: usize) -> cogmap_geometry::DVec2 {
    if end == 0 { segment.a } else { segment.b }
}

/// §3.2.1, identifying common surfaces: the previous view is projected onto the current one by the
/// rough movement, every surface takes at most one partner, the best pairs first. The movement is
/// used here and nowhere else.
#[must_use]
pub fn match_views(
    current: &[Surface],
    previous: &[Tracked],
    previous_from_current: Pose,
    params: &Matching,
) -> Vec<Match> {
    let current_from_previous = previous_from_current.inverse();
    let projected: Vec<Tracked> =
        previous.iter().map(|known| known.seen_from(current_from_previous)).collect();
    let mut pairs = Vec::new();
    for (seen, surface) in current.iter().enumerate() {
        for (previous, known) in projected.iter().enumerate() {
            let Some(gates) = gates(surface.label, known.label, params) else { continue };
            let fit = error_within(&gates, surface, known, params);
            pairs.extend(fit.map(|fit| Pair { seen, previous, fit }));
        }
    }
    let partners = best_partners(pairs, current.len(), previous.len()).into_iter();
    partners
        .filter_map(|Pair { seen, previous: place, fit }| {
            Some(Match { seen, previous: Some(place), known: previous[place].known?, fit })
        })
        .collect()
}

/// Two sightings that may be of one surface.
struct Pair {
    seen: usize,
    previous: usize,
    fit: PairError,
}

/// The gates that a pair must pass. Two labels that differ are two things, and `None` says so; the same
/// label may be farther off; a sighting without one may be of anything.
fn gates(seen: Option<u32>, known: Option<u32>, params: &Matching) -> Option<Matching> {
    let reach = match (seen, known) {
        (Some(seen), Some(known)) if seen != known => return None,
        (Some(_), Some(_)) => params.label_reach,
        _ => 1.0,
    };
    Some(Matching { distance: params.distance * reach, angle: params.angle * reach, ..*params })
}

/// One partner each: the pair with the least error takes both of its surfaces.
fn best_partners(mut pairs: Vec<Pair>, current: usize, previous: usize) -> Vec<Pair> {
    pairs.sort_by(|a, b| {
        a.fit.error.total_cmp(&b.fit.error).then(a.seen.cmp(&b.seen)).then(a.previous.cmp(&b.previous))
    });
    let (mut seen_taken, mut previous_taken) = (vec![false; current], vec![false; previous]);
    pairs.retain(|pair| {
        let free = !seen_taken[pair.seen] && !previous_taken[pair.previous];
        if free {
            seen_taken[pair.seen] = true;
            previous_taken[pair.previous] = true;
        }
        free
    });
    pairs.sort_by_key(|pair| pair.seen);
    pairs
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::DVec2;
    use proptest::prelude::*;

    use super::*;

    fn wall(a: DVec2, b: DVec2, ends: [End; 2]) -> Surface {
        let segment = Segment::new(a, b);
        Surface {
            segment,
            ends,
            beams: [0, 9],
            points: 10,
            residual: 0.0,
            range: 2.0,
            incidence: 0.3,
            label: None,
        }
    }

    fn true_wall(ax: f64, ay: f64, bx: f64, by: f64) -> Surface {
        wall(DVec2::new(ax, ay), DVec2::new(bx, by), [End::True; 2])
    }

    fn error(seen: &Surface, known: &Surface) -> PairError {
        pair_error(seen, &Tracked::seen(known, None), &Matching::default())
    }

    proptest! {
        #[test]
        fn the_error_grows_with_each_of_its_parts(d1 in 0.0f64..0.4, d2 in 0.0f64..0.4, more in 0.001f64..0.1) {
            // Both ends shifted outwards along the wall: distances grow, the direction stays.
            let known = true_wall(0.0, 1.0, 4.0, 1.0);
            let less = error(&true_wall(-d1, 1.0, 4.0 + d2, 1.0), &known);
            prop_assert!(error(&true_wall(-d1 - more, 1.0, 4.0 + d2, 1.0), &known).error > less.error);
            prop_assert!(error(&true_wall(-d1, 1.0, 4.0 + d2 + more, 1.0), &known).error > less.error);
        }

        #[test]
        fn the_error_grows_with_the_angle_also_from_zero(turn in 0.0f64..0.2, more in 0.001f64..0.05) {
            // Turned about its middle: both ends move alike.
            let turned = |angle: f64| {
                let (sin, cos) = trig::sin_cos(angle);
                true_wall(-2.0 * cos, 1.0 - 2.0 * sin, 2.0 * cos, 1.0 + 2.0 * sin)
            };
            let known = turned(0.0);
            prop_assert!(error(&turned(turn + more), &known).error > error(&turned(turn), &known).error);
            prop_assert!(error(&known, &known).error > 0.0);
        }
    }

    #[test]
    fn a_hidden_end_says_nothing_about_where_the_wall_ends() {
        let known = true_wall(0.0, 1.0, 4.0, 1.0);
        let partly = wall(DVec2::new(1.5, 1.02), DVec2::new(4.0, 1.02), [End::Occlusion, End::True]);
        let fit = error(&partly, &known);
        assert!((fit.d1 - 0.02).abs() < 1e-9 && (fit.d2 - 0.02).abs() < 1e-9);
    }

    #[test]
    fn a_wall_is_never_taken_for_its_back() {
        let front = true_wall(2.0, -1.0, 2.0, 1.0);
        let back = true_wall(2.05, 1.0, 2.05, -1.0);
        let tracked = [Tracked::seen(&front, Some(SurfaceId(0)))];
        assert!(match_views(&[back], &tracked, Pose::IDENTITY, &Matching::default()).is_empty());
    }

    #[test]
    fn the_better_of_two_candidates_becomes_the_partner() {
        let tracked = [true_wall(2.0, -1.0, 2.0, 1.0), true_wall(2.2, -1.0, 2.2, 1.0)]
            .map(|surface| Tracked::seen(&surface, Some(SurfaceId(0))));
        let matches =
            match_views(&[true_wall(2.18, -1.0, 2.18, 1.0)], &tracked, Pose::IDENTITY, &Matching::default());
        assert_eq!(matches.len(), 1);
        assert_eq!(matches[0].previous, Some(1));
    }

    #[test]
    fn a_surface_without_a_stored_version_takes_its_partner_and_gives_no_match() {
        let unnamed = Tracked::seen(&true_wall(2.2, -1.0, 2.2, 1.0), None);
        let named = Tracked::seen(&true_wall(2.0, -1.0, 2.0, 1.0), Some(SurfaceId(0)));
        let seen = [true_wall(2.18, -1.0, 2.18, 1.0)];
        assert_eq!(match_views(&seen, &[named, unnamed], Pose::IDENTITY, &Matching::default()), []);
    }

    /// What a camera tells apart is not confused, and is known from farther off.
    #[test]
    fn two_labels_pair_only_if_they_are_one_and_then_within_wider_gates() {
        let labelled = |x: f64, label| Surface { label, ..true_wall(x, -1.0, x, 1.0) };
        let found = |seen: Option<u32>, known: Option<u32>, apart: f64| {
            let tracked = [Tracked::seen(&labelled(2.0, known), Some(SurfaceId(0)))];
            let seen = [labelled(2.0 + apart, seen)];
            !match_views(&seen, &tracked, Pose::IDENTITY, &Matching::default()).is_empty()
        };
        assert!(found(None, None, 0.1) && !found(None, None, 1.5));
        assert!(found(Some(7), Some(7), 1.5) && !found(Some(7), Some(7), 2.5));
        assert!(!found(Some(7), Some(8), 0.1));
        assert!(found(Some(7), None, 0.1) && !found(Some(7), None, 1.5) && found(None, Some(7), 0.1));
    }
}
