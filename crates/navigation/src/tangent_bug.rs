use cogmap_geometry::{DVec2, normalize_angle, trig};
use cogmap_mapping::{Sentence, say};
use serde::{Deserialize, Serialize};

use crate::{
    Anchored, Mode,
    strategy::{Proposal, Situation, Wish},
};

/// What [`StrategySetup::TangentBug`](crate::StrategySetup::TangentBug) goes by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TangentBugParams {
    /// How far it looks, metres.
    pub range: f64,
    /// Directions in which it looks.
    pub directions: u32,
    /// Free ways that differ by more than this end at different things, metres.
    pub jump: f64,
    /// The shortest free way along a boundary that it takes, metres.
    pub follow: f64,
    /// Home counts as out of reach when it has gone round a boundary and is back within this, metres.
    pub round: f64,
    /// Decisions without a step before it gives up.
    pub patience: u32,
}

impl Default for TangentBugParams {
    fn default() -> Self {
        Self { range: 3.0, directions: 90, jump: 0.5, follow: 0.3, round: 0.5, patience: 10 }
    }
}

/// The bug of Kamon, Rimon and Rivlin (1998) with a range-limited sensor: to the target round the end of
/// what it sees in the way; along the boundary once that leads away from it, until a place is seen that lies
/// nearer to the target than any of the boundary did.
#[derive(Clone, Debug)]
pub(crate) struct TangentBug {
    params: TangentBugParams,
    /// The least that the last way round an end would have cost, while it moves to the target, metres.
    heuristic: f64,
    boundary: Option<Boundary>,
    idle: u32,
}

/// A boundary that is followed is looked for from straight ahead to so far behind the robot's side, radians: what
/// stands on the other side of a corridor is another.
const BEHIND: f64 = 150.0 * trig::PI / 180.0;
/// The robot closes in on it aslant: on a way that is longer than the straight one by this.
const ASLANT: f64 = 1.5;

/// A boundary that is followed.
#[derive(Clone, Copy, Debug)]
struct Boundary {
    /// 1.0 with the obstacle on the right, -1.0 with it on the left.
    side: f64,
    /// The shortest distance between what was seen of the boundary and the target, metres.
    followed: f64,
    /// Where it began, and whether the robot has been away from there.
    began: Anchored<DVec2>,
    left: bool,
}

/// A direction, how far it is free for the robot, and where that ends.
#[derive(Clone, Copy, Debug)]
struct Ray {
    bearing: f64,
    free: f64,
    end: DVec2,
}

impl TangentBug {
    pub(crate) fn new(params: &TangentBugParams) -> Self {
        Self { params: params.clone(), heuristic: f64::INFINITY, boundary: None, idle: 0 }
    }

    pub(crate) fn decide(&mut self, situation: &Situation) -> Proposal {
        let Some(home) = situation.belief.home else {
            let why = say("the robot does not know where home is", &[]);
            return Proposal::new(Wish::GiveUp, Mode::Direction, why);
        };
        let target = home.position;
        let rays = self.look(situation);
        let here = situation.belief.here_from_robot.position;
        // A boundary is left for a place nearer to the target, not for a look at free floor: else the robot
        // goes back to where it met it.
        let looks_for = if self.boundary.is_some() { f64::INFINITY } else { self.params.range };
        if situation.free_toward(target) >= here.distance(target).min(looks_for) {
            self.boundary = None;
            self.heuristic = here.distance(target);
            let away = (here.distance(target), 1);
            let why = say("home is {} m away, and the robot sees nothing in between", &[away]);
            return self.go(situation, target, why);
        }
        if let Some(boundary) = self.boundary {
            let heading = situation.belief.here_from_robot.heading;
            return self.follow(situation, target, &rays, (boundary, heading));
        }
        let Some((end, cost)) = self.best_end(here, target, &rays) else {
            return self.begin(situation, target, &rays);
        };
        if cost > self.heuristic + 0.1 {
            return self.begin(situation, target, &rays);
        }
        self.heuristic = self.heuristic.min(cost);
        let why = say(
            "home is {} m away with something in between: the robot goes for the end of it that makes the \
             shortest way, {} m",
            &[(here.distance(target), 1), (cost, 1)],
        );
        self.go(situation, end, why)
    }

    fn look(&self, situation: &Situation) -> Vec<Ray> {
        let here = situation.belief.here_from_robot;
        let apart = trig::TAU / f64::from(self.params.directions.max(1));
        let ray = |k: u32| {
            let turn = normalize_angle(apart * f64::from(k));
            let free = situation.vigilance.free_way(turn, self.params.range);
            let bearing = here.heading + turn;
            let (sin, cos) = trig::sin_cos(bearing);
            Ray { bearing, free, end: here.position + DVec2::new(cos, sin) * free }
        };
        (0..self.params.directions).map(ray).collect()
    }

    /// The end of something in the way that makes the shortest way to the target, and that way's length.
    fn best_end(&self, here: DVec2, target: DVec2, rays: &[Ray]) -> Option<(DVec2, f64)> {
        let mut best: Option<(DVec2, f64)> = None;
        for (ray, next) in rays.iter().zip(rays.iter().cycle().skip(1)) {
            if (ray.free - next.free).abs() < self.params.jump {
                continue;
            }
            let open = if ray.free > next.free { ray } else { next };
            let cost = open.free + open.end.distance(target);
            let nearer = open.end.distance(target) < here.distance(target);
            if nearer && best.is_none_or(|(_, least)| cost < least) {
                best = Some((open.end, cost));
            }
        }
        best
    }

    /// Begins to follow a boundary, on the side that leads less away from the target.
    fn begin(&mut self, situation: &Situation, target: DVec2, rays: &[Ray]) -> Proposal {
        let here = situation.belief.here_from_robot.position;
        let ahead = target - here;
        let toward = trig::atan2(ahead.y, ahead.x);
        let free = |side: f64| {
            let open = |ray: &&Ray| {
                ray.free >= self.params.follow && normalize_angle(ray.bearing - toward) * side > 0.0
            };
            let turns = rays.iter().filter(open).map(|ray| normalize_angle(ray.bearing - toward).abs());
            turns.fold(f64::INFINITY, f64::min)
        };
        let side = if free(1.0) <= free(-1.0) { 1.0 } else { -1.0 };
        let began = situation.atlas.keep(here);
        let boundary = Boundary { side, followed: f64::INFINITY, began, left: false };
        self.follow(situation, target, rays, (boundary, toward))
    }

    /// Goes along a boundary, for a robot that heads so.
    fn follow(
        &mut self,
        situation: &Situation,
        target: DVec2,
        rays: &[Ray],
        (mut boundary, heading): (Boundary, f64),
    ) -> Proposal {
        let here = situation.belief.here_from_robot.position;
        let reach = rays.iter().map(|ray| ray.end.distance(target)).fold(here.distance(target), f64::min);
        if reach < boundary.followed - 0.1 && boundary.followed.is_finite() {
            (self.boundary, self.heuristic) = (None, f64::INFINITY);
            if let Some((end, cost)) = self.best_end(here, target, rays) {
                self.heuristic = cost;
                return self.go(
                    situation,
                    end,
                    say("the robot sees a place that is nearer to home than all that it went along, and goes there", &[]),
                );
            }
        }
        let hit = rays.iter().filter(|ray| ray.free < self.params.range);
        let nearest = hit.map(|ray| ray.end.distance(target)).fold(f64::INFINITY, f64::min);
        boundary.followed = boundary.followed.min(nearest).min(here.distance(target));
        let away = situation.atlas.point(boundary.began).map_or(f64::INFINITY, |began| began.distance(here));
        boundary.left |= away > 2.0 * self.params.round;
        let round = boundary.left && away < self.params.round;
        self.boundary = Some(boundary);
        match self.along(rays, heading, boundary.side) {
            Some(end) if !round => {
                let why = say(
                    "no way on leads nearer to home, so the robot goes along what is in its way until it sees a place \
                     that is less than {} m from home",
                    &[(boundary.followed, 1)],
                );
                self.go(situation, end, why)
            }
            _ => {
                let why = say("the robot has gone round what is in its way without finding a gap", &[]);
                Proposal::new(Wish::GiveUp, Mode::Direction, why)
            }
        }
    }

    /// The first free direction from the nearest thing on the boundary's side of the robot, away from it. Where
    /// nothing stands there, the boundary has turned away, and the robot turns after it.
    fn along(&self, rays: &[Ray], heading: f64, side: f64) -> Option<DVec2> {
        let turned = |from: f64, ray: &Ray| normalize_angle(ray.bearing - from) * side;
        let beside = rays
            .iter()
            .filter(|ray| ray.free < self.params.range && (-BEHIND..=0.0).contains(&turned(heading, ray)));
        let nearest = beside.min_by(|a, b| a.free.total_cmp(&b.free));
        let wall = nearest.map_or(heading - side * trig::FRAC_PI_2, |ray| ray.bearing);
        let turn = |ray: &Ray| {
            let turn = turned(wall, ray);
            if turn < 0.0 { turn + trig::TAU } else { turn }
        };
        let enough =
            nearest.map_or(0.0, |ray| ASLANT * ray.free).clamp(self.params.follow, self.params.range);
        let open = rays.iter().filter(|ray| ray.free >= enough);
        open.min_by(|a, b| turn(a).total_cmp(&turn(b))).map(|ray| ray.end)
    }

    fn go(&mut self, situation: &Situation, point: DVec2, why: Sentence) -> Proposal {
        let free = situation.free_toward(point) >= situation.params.step_min;
        self.idle = if free { 0 } else { self.idle + 1 };
        let wish = if self.idle > self.params.patience { Wish::GiveUp } else { Wish::GoTo(point) };
        Proposal { way: vec![point], ..Proposal::new(wish, Mode::Direction, why) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEGREE: f64 = trig::PI / 180.0;

    /// What a bug at the origin sees of free floor, from how far it can go at each bearing in degrees.
    fn rays(free: impl Fn(f64) -> f64) -> Vec<Ray> {
        let ray = |k: i32| {
            let bearing = normalize_angle(f64::from(4 * k) * DEGREE);
            let (sin, cos) = trig::sin_cos(bearing);
            let free = free(bearing / DEGREE).min(3.0);
            Ray { bearing, free, end: DVec2::new(cos, sin) * free }
        };
        (0..90).map(ray).collect()
    }

    fn bug() -> TangentBug {
        TangentBug::new(&TangentBugParams::default())
    }

    /// Free ways between two walls along x: to the left and to the right so far away, metres.
    fn corridor(left: f64, right: f64) -> Vec<Ray> {
        rays(|bearing| {
            let across = trig::sin(bearing * DEGREE);
            if across > 0.0 { left / across } else { right / (-across).max(1e-9) }
        })
    }

    #[test]
    fn in_a_corridor_the_followed_wall_is_the_one_on_its_side_however_near_the_other() {
        for (left, right) in [(0.1, 1.0), (1.0, 0.1), (0.2, 0.2)] {
            for side in [1.0, -1.0] {
                let end = bug().along(&corridor(left, right), 0.0, side).unwrap();
                assert!(end.x > 0.0, "{left} {right} {side}: {end}");
                assert!(bug().along(&corridor(left, right), trig::PI, side).unwrap().x < 0.0);
            }
        }
    }

    #[test]
    fn where_the_boundary_ends_the_bug_turns_round_its_end() {
        let past_the_end = rays(|bearing| if bearing.abs() > 120.0 { 0.2 } else { 9.0 });
        let end = bug().along(&past_the_end, 0.0, 1.0).unwrap();
        assert!(end.y < -0.5, "after a wall on its right: {end}");
        assert!(bug().along(&past_the_end, 0.0, -1.0).unwrap().y > 0.5);
    }

    #[test]
    fn the_end_that_makes_the_shortest_way_is_taken_and_none_that_leads_away() {
        let wall = rays(|bearing| if (-20.0..=60.0).contains(&bearing) { 1.0 } else { 3.0 });
        let (end, cost) = bug().best_end(DVec2::ZERO, DVec2::new(9.0, 0.0), &wall).unwrap();
        assert!(end.y < 0.0 && (9.0..9.6).contains(&cost), "{end} {cost}");
        let behind = rays(|bearing| if bearing.abs() < 100.0 { 1.0 } else { 3.0 });
        assert_eq!(bug().best_end(DVec2::ZERO, DVec2::new(9.0, 0.0), &behind), None);
    }
}
