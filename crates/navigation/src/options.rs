use cogmap_geometry::{DVec2, Segment, trig};
use serde::{Deserialize, Serialize};

use crate::{
    MovementOption,
    direction::{Straightest, detour},
    surroundings::{Fan, Surroundings, Sweep},
};

/// How movement options are found (§3.3.2).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct OptionsParams {
    /// The farthest end of an option, metres: what one can see.
    pub sight: f64,
    /// Where the free way gets longer or shorter by more than this from one direction to the next, one
    /// opening ends and another begins, metres.
    pub edge: f64,
    /// Wide openings count as several options, one each so many radians.
    pub width: f64,
    /// Half the width that the seen part of the way needs, the robot and a margin, metres.
    pub half_width: f64,
    /// Half the width that the assumed part of the way needs, metres: the robot, without a margin.
    pub assumed_half_width: f64,
    /// What is kept between the robot and what is ahead of it, metres.
    pub gap: f64,
    /// A shorter option is none, metres.
    pub shortest: f64,
    /// So near to the target the assumed part is not looked at: only its rough place is known, metres.
    pub rough: f64,
    /// Of two options that end nearer to each other than this only the better counts, metres.
    pub apart: f64,
    /// Ends in one direction whose scores differ by no more than this are equally good.
    pub alike: f64,
    /// So much worse in its score an option straight ahead may be and still be taken: the robot has just turned to it, and
    /// what it saw on the way differs a little from what it had remembered. Ours: the thesis's robot turns
    /// and travels in one, so it cannot turn to and fro without moving.
    pub inertia: f64,
    /// Ends are tried this far apart along a direction, metres.
    pub spacing: f64,
}

impl Default for OptionsParams {
    fn default() -> Self {
        Self {
            sight: 8.0,
            edge: 0.5,
            width: 20.0 * trig::PI / 180.0,
            half_width: 0.28,
            assumed_half_width: 0.25,
            gap: 0.05,
            shortest: 0.1,
            rough: 0.5,
            apart: 1.0,
            alike: 0.01,
            inertia: 0.3,
            spacing: 0.5,
        }
    }
}

/// The cosine of 5°: straight ahead.
const AHEAD: f64 = 0.996;

/// What options are looked for with.
pub(crate) struct Search<'a> {
    pub(crate) params: &'a OptionsParams,
    pub(crate) straightest: Straightest,
    pub(crate) surroundings: &'a Surroundings,
    /// Where the robot is, metres …
    pub(crate) robot: DVec2,
    /// … and which way it faces, a unit vector, if it has just turned that way.
    pub(crate) facing: Option<DVec2>,
    /// How far the last scans let the robot go in a direction at once, metres; `None` where they do not
    /// hold it up.
    pub(crate) watch: &'a dyn Fn(DVec2) -> Option<f64>,
    /// Whether a way is not for choice although it is free.
    pub(crate) barred: &'a dyn Fn(&[DVec2]) -> bool,
}

impl Search<'_> {
    /// The openings through which the robot fits (§3.3.2, Fig. 3.25): each option is a straight way that is
    /// seen to be free up to its end, and from there a straight line to the target that nothing crosses
    /// which the robot still trusts. Counter-clockwise.
    pub(crate) fn toward(&self, target: DVec2) -> Vec<MovementOption> {
        let robot = self.robot;
        let OptionsParams { half_width: radius, gap, sight, .. } = *self.params;
        let fan = Fan::of(self.surroundings, robot, Sweep { radius, gap, sight });
        let mut directions: Vec<usize> = fan
            .openings(self.params.edge)
            .into_iter()
            .flat_map(|opening| fan.directions_in(opening, self.params.width))
            .collect();
        directions.extend(self.facing.into_iter().chain([target - robot]).map(|way| fan.toward(way)));
        directions.sort_unstable();
        directions.dedup();
        let options = directions.into_iter().filter_map(|k| {
            let direction = fan.direction(k);
            let reach = (self.watch)(direction).map_or(fan.reach(k), |free| fan.reach(k).min(free));
            self.best_end(direction * reach, target)
        });
        self.few(options.collect())
    }

    /// The best end of an option along a free way.
    fn best_end(&self, free: DVec2, target: DVec2) -> Option<MovementOption> {
        let (robot, reach) = (self.robot, free.length());
        let ahead = self.facing.is_some_and(|facing| free.dot(facing) > AHEAD * reach);
        let bonus = if ahead { self.params.inertia } else { 0.0 };
        let between = (1..).map(|k| f64::from(k) * self.params.spacing).take_while(|&s| s < reach);
        let beside = free.dot(target - robot) / reach.max(f64::MIN_POSITIVE);
        let ends = between.chain([reach]).chain((beside > 0.0 && beside < reach).then_some(beside));
        let ends = ends.filter(|&length| length >= self.params.shortest.min(robot.distance(target)));
        let options = ends.filter_map(|length| {
            let end = robot + free * (length / reach);
            self.assumed_free(end, target).then(|| MovementOption {
                end,
                detour: detour(robot, end, target),
                score: self.straightest.score(robot, end, target) - bonus,
                barred: (self.barred)(&[robot, end, target]),
            })
        });
        options.reduce(|best, next| if self.better(&next, &best) { next } else { best })
    }

    /// Whether an end beats another in the same direction; of ends that are equally good the farther one.
    fn better(&self, one: &MovementOption, other: &MovementOption) -> bool {
        let robot = self.robot;
        if one.barred != other.barred {
            return other.barred;
        }
        let alike = (one.score - other.score).abs() <= self.params.alike;
        if alike { robot.distance(one.end) > robot.distance(other.end) } else { one.score < other.score }
    }

    /// Whether the guess that the way goes straight on to the target contradicts nothing that is trusted.
    fn assumed_free(&self, end: DVec2, target: DVec2) -> bool {
        let way = assumed(end, target, self.params.rough);
        way.is_none_or(|way| self.surroundings.leave_free(way, self.params.assumed_half_width))
    }

    /// A limited number of options: of those whose ends lie close together, the best.
    fn few(&self, mut options: Vec<MovementOption>) -> Vec<MovementOption> {
        options.sort_by(|a, b| a.score.total_cmp(&b.score));
        let mut kept: Vec<MovementOption> = Vec::new();
        for option in options {
            let same = |other: &MovementOption| {
                other.barred == option.barred && other.end.distance(option.end) < self.params.apart
            };
            if !kept.iter().any(same) {
                kept.push(option);
            }
        }
        let bearing = |option: &MovementOption| {
            let seen = option.end - self.robot;
            trig::atan2(seen.y, seen.x)
        };
        kept.sort_by(|a, b| bearing(a).total_cmp(&bearing(b)));
        kept
    }
}

/// The assumed part of a way but for its last stretch; `None` where nothing is left of it.
pub(crate) fn assumed(end: DVec2, target: DVec2, rough: f64) -> Option<Segment> {
    let length = end.distance(target);
    (length > rough).then(|| Segment::new(end, end.lerp(target, 1.0 - rough / length)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(x1: f64, y1: f64, x2: f64, y2: f64) -> Segment {
        Segment::new(DVec2::new(x1, y1), DVec2::new(x2, y2))
    }

    /// The options of a robot at the origin whose home lies behind the given walls, 10 m to the east.
    fn options(surfaces: Vec<Segment>) -> Vec<MovementOption> {
        let surroundings = Surroundings { surfaces, points: Vec::new() };
        let search = Search {
            params: &OptionsParams::default(),
            straightest: Straightest::Shortest,
            surroundings: &surroundings,
            robot: DVec2::ZERO,
            facing: None,
            watch: &|_| None,
            barred: &|_| false,
        };
        search.toward(DVec2::new(10.0, 0.0))
    }

    fn best(options: &[MovementOption]) -> MovementOption {
        options[crate::direction::straightest(options).unwrap()]
    }

    /// A room of 6 m by 6 m whose eastern wall has a gap so wide.
    fn room(gap: f64) -> Vec<Segment> {
        let (low, high) = (1.5 - gap / 2.0, 1.5 + gap / 2.0);
        vec![
            wall(-3.0, -3.0, 3.0, -3.0),
            wall(3.0, -3.0, 3.0, low),
            wall(3.0, high, 3.0, 3.0),
            wall(3.0, 3.0, -3.0, 3.0),
            wall(-3.0, 3.0, -3.0, -3.0),
        ]
    }

    #[test]
    fn in_the_open_the_straight_line_is_the_best_option() {
        let best = best(&options(Vec::new()));
        assert!(best.detour < 1e-9 && best.end.distance(DVec2::new(8.0, 0.0)) < 1e-9, "{best:?}");
    }

    #[test]
    fn an_opening_counts_only_if_the_robot_fits_through() {
        let doorway = options(room(0.9));
        assert!(best(&doorway).end.distance(DVec2::new(3.0, 1.5)) < 1.5, "{doorway:?}");
        assert_eq!(options(room(0.45)), []);
    }

    #[test]
    fn around_a_corner_the_option_ends_where_the_way_home_bends() {
        let best = best(&options(vec![wall(4.0, -9.0, 4.0, 2.0)]));
        assert!(best.end.y > 0.8 && best.detour < 1.5, "{best:?}");
        let assumed = Segment::new(best.end, DVec2::new(10.0, 0.0));
        assert!(assumed.distance_to(DVec2::new(4.0, 2.0)) >= 0.25 - 1e-9);
    }

    #[test]
    fn two_corners_one_behind_the_other_leave_no_option() {
        let mut maze = room(0.9);
        maze.extend([wall(4.2, -9.0, 4.2, 9.0), wall(4.2, 9.0, -9.0, 9.0), wall(4.2, -9.0, -9.0, -9.0)]);
        assert_eq!(options(maze), []);
    }
}
