use cogmap_geometry::{DVec2, is_inside};
use serde::{Deserialize, Serialize};

use super::Rate;

/// A detected exit is at most this far from the true doorway, metres …
const NEAR: f64 = 0.5;
/// … and the robot was at it at most so many metres of way before or after.
const NEAR_ALONG: f64 = 3.0;

/// A doorway that the true path goes through, or an exit that the robot says it went through. An exit is
/// put into the world by the true pose of the robot at the view nearest to the crossing, so that the
/// drift of its map, which is measured elsewhere, does not count here.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Doorway {
    /// Its middle in the world, metres.
    pub at: DVec2,
    /// Metres of true way when it was crossed.
    pub way: f64,
}

/// How well exits were found over all crossings of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ExitScore {
    /// Of the doorways crossed, those that an exit was found for.
    pub recall: Rate,
    /// Of the exits found, those that are doorways.
    pub precision: Rate,
    /// Metres from each doorway to the exit found for it.
    pub errors: Vec<f64>,
}

/// The room that a point lies in; `None` between rooms.
#[must_use]
pub fn room_at(rooms: &[Vec<DVec2>], point: DVec2) -> Option<usize> {
    rooms.iter().position(|outline| is_inside(outline, point))
}

/// Where a path goes from one room to another: half-way between its last point in the one and its first
/// point in the other.
#[must_use]
pub fn doorways(rooms: &[Vec<DVec2>], path: &[DVec2]) -> Vec<Doorway> {
    let mut found = Vec::new();
    let mut last: Option<(usize, DVec2, f64)> = None;
    let (mut way, mut before) = (0.0, None);
    for &point in path {
        way += before.map_or(0.0, |before: DVec2| before.distance(point));
        before = Some(point);
        let Some(room) = room_at(rooms, point) else { continue };
        if let Some((left, from, from_way)) = last
            && left != room
        {
            let (at, way) = ((from + point) * 0.5, f64::midpoint(from_way, way));
            found.push(Doorway { at, way });
        }
        last = Some((room, point, way));
    }
    found
}

/// Pairs each true doorway with the nearest exit that may be it, one each, nearest pairs first.
#[must_use]
pub fn score_exits(truth: &[Doorway], found: &[Doorway]) -> ExitScore {
    let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
    for (i, doorway) in truth.iter().enumerate() {
        for (j, exit) in found.iter().enumerate() {
            let distance = doorway.at.distance(exit.at);
            if distance <= NEAR && (doorway.way - exit.way).abs() <= NEAR_ALONG {
                pairs.push((distance, i, j));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut taken, mut given) = (vec![false; truth.len()], vec![false; found.len()]);
    let mut errors = Vec::new();
    for (distance, i, j) in pairs {
        if !taken[i] && !given[j] {
            (taken[i], given[j]) = (true, true);
            errors.push(distance);
        }
    }
    let hits = errors.len() as u64;
    ExitScore {
        recall: Rate { hits, runs: truth.len() as u64 },
        precision: Rate { hits, runs: found.len() as u64 },
        errors,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rooms() -> Vec<Vec<DVec2>> {
        let square = |x: f64| [[x, 0.0], [x + 4.0, 0.0], [x + 4.0, 4.0], [x, 4.0]].map(DVec2::from).to_vec();
        vec![square(0.0), square(4.2)]
    }

    fn along(xs: &[f64]) -> Vec<DVec2> {
        xs.iter().map(|&x| DVec2::new(x, 2.0)).collect()
    }

    #[test]
    fn a_doorway_lies_half_way_between_two_rooms() {
        let path = along(&[3.0, 3.5, 4.0 - 0.1, 4.1, 4.3, 5.0]);
        let found = doorways(&rooms(), &path);
        assert_eq!(found.len(), 1);
        assert!(found[0].at.distance(DVec2::new(4.1, 2.0)) < 1e-9 && (found[0].way - 1.1).abs() < 1e-9);
    }

    #[test]
    fn who_turns_back_in_a_doorway_has_crossed_none() {
        assert!(doorways(&rooms(), &along(&[3.0, 3.9, 4.1, 3.9, 3.0])).is_empty());
    }

    #[test]
    fn three_of_four_doorways_found_and_one_invented_is_three_quarters_both_ways() {
        let at = |x: f64, way: f64| Doorway { at: DVec2::new(x, 0.0), way };
        let truth = [at(0.0, 1.0), at(5.0, 6.0), at(10.0, 11.0), at(15.0, 16.0)];
        // The third is half a metre and a bit off; the fourth is passed a second time, much later.
        let found = [at(0.3, 1.2), at(5.0, 6.4), at(10.6, 11.0), at(15.0, 15.0)];
        let score = score_exits(&truth, &found);
        assert_eq!(score.recall, Rate { hits: 3, runs: 4 });
        assert_eq!(score.precision, Rate { hits: 3, runs: 4 });
        assert!((score.errors.iter().sum::<f64>() - 0.3).abs() < 1e-9);
        assert_eq!(score_exits(&truth[3..], &[at(15.0, 30.0)]).recall.hits, 0);
    }

    #[test]
    fn one_exit_is_found_for_one_doorway_only() {
        let at = |x: f64| Doorway { at: DVec2::new(x, 0.0), way: 1.0 };
        let score = score_exits(&[at(0.0), at(0.4)], &[at(0.3)]);
        assert_eq!((score.recall.hits, score.precision.hits), (1, 1));
        assert!((score.errors[0] - 0.1).abs() < 1e-9);
    }
}
