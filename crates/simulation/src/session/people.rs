use cogmap_geometry::{DVec2, Pose, Segment};

use crate::{Disc, Obstacles, Person, TICK};

/// How near somebody comes to the robot's edge, metres.
const POLITE: f64 = 0.15;
/// Nobody steps to where the robot will be within so many seconds …
const FORESIGHT: f64 = 1.0;
/// … and so many metres farther ahead, even while it stands: it may start at any moment, and looks again
/// only when it has gone some way.
const RESPECT: f64 = 0.3;
/// Somebody who has stood before the robot for so many ticks, three seconds, turns round.
const PATIENCE: u32 = 150;

/// What people see of the robot: the floor on which it stands, and that ahead of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sweep {
    way: Segment,
    radius: f64,
}

impl Sweep {
    /// Of a robot of that radius which drives forward so fast, metres per second.
    pub(super) fn new(world_from_robot: Pose, speed: f64, radius: f64) -> Self {
        let here = world_from_robot.position;
        let reach = speed * FORESIGHT + if speed < 0.0 { -RESPECT } else { RESPECT };
        Self { way: Segment::new(here, here + world_from_robot.forward() * reach), radius }
    }

    /// Metres between somebody's middle and the robot's.
    fn distance(&self, somebody: Disc) -> f64 {
        self.way.a.distance(somebody.center)
    }

    /// Metres between somebody's edge and the sweep's.
    fn gap(&self, somebody: Disc) -> f64 {
        self.way.distance_to(somebody.center) - self.radius - somebody.radius
    }
}

/// Somebody on the way to and fro along a path.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Walker {
    path: Vec<DVec2>,
    /// Metres a tick.
    stride: f64,
    disc: Disc,
    /// The point of the path that is walked to.
    toward: usize,
    /// Whether the path is walked from its beginning to its end.
    onward: bool,
    /// For how many ticks the robot has been in the way.
    waited: u32,
}

impl Walker {
    pub(super) fn new(person: &Person) -> Self {
        let path: Vec<DVec2> = person.path.iter().map(|&point| point.into()).collect();
        let disc = Disc { center: path.first().copied().unwrap_or(DVec2::NAN), radius: person.radius };
        Self { path, stride: person.speed * TICK, disc, toward: 0, onward: true, waited: 0 }
    }

    pub(super) fn disc(&self) -> Disc {
        self.disc
    }

    /// Walks on for a tick. Stops where the robot would come too near, turns round when it stays there,
    /// and turns round before a solid that stands in the way.
    pub(super) fn walk(&mut self, robot: Sweep, obstacles: &Obstacles) {
        let (toward, onward, center) = self.next();
        let next = Disc { center, ..self.disc };
        // Whoever is in the robot's way may walk out of it, but not past its nose.
        let comes_nearer = robot.distance(next) < robot.distance(self.disc);
        if robot.gap(next) < POLITE && (comes_nearer || robot.gap(next) <= robot.gap(self.disc)) {
            self.wait();
            return;
        }
        self.waited = 0;
        let room =
            |at: DVec2| obstacles.nearest(at, self.disc.radius).map_or(self.disc.radius, |n| n.distance);
        if room(center) < room(self.disc.center) - 1e-9 {
            (self.toward, self.onward) = self.turned();
            return;
        }
        (self.toward, self.onward, self.disc.center) = (toward, onward, center);
    }

    /// Lets the robot pass, but not for ever: it may be waiting as well.
    fn wait(&mut self) {
        self.waited += 1;
        if self.waited >= PATIENCE {
            (self.toward, self.onward) = self.turned();
            self.waited = 0;
        }
    }

    /// Where the next tick's stride leads, along as many pieces of the path as it is long.
    fn next(&self) -> (usize, bool, DVec2) {
        let (mut toward, mut onward, mut center) = (self.toward, self.onward, self.disc.center);
        let mut left = self.stride;
        for _ in 0..=2 * self.path.len() {
            let Some(&goal) = self.path.get(toward) else { break };
            let way = center.distance(goal);
            if way > left {
                return (toward, onward, center + (goal - center) * (left / way));
            }
            (left, center) = (left - way, goal);
            if onward && toward + 1 >= self.path.len() || !onward && toward == 0 {
                onward = !onward;
            }
            toward = if onward { (toward + 1).min(self.path.len() - 1) } else { toward.saturating_sub(1) };
        }
        (toward, onward, center)
    }

    /// The same spot, walking the other way.
    fn turned(&self) -> (usize, bool) {
        let last = self.path.len().saturating_sub(1);
        let toward = if self.onward { self.toward.saturating_sub(1) } else { (self.toward + 1).min(last) };
        (toward, !self.onward)
    }
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::trig::FRAC_PI_2;

    use super::*;
    use crate::Solids;

    fn walker() -> Walker {
        Walker::new(&Person { path: vec![[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]], speed: 1.0, radius: 0.2 })
    }

    fn robot(x: f64, y: f64, heading: f64, speed: f64) -> Sweep {
        Sweep::new(Pose::new(x, y, heading), speed, 0.25)
    }

    fn far_robot() -> Sweep {
        robot(50.0, 50.0, 0.0, 0.0)
    }

    fn walls(segments: Vec<Segment>) -> Obstacles {
        Obstacles::new(&Solids { segments, ..Solids::default() })
    }

    fn after(walker: &mut Walker, ticks: u32, robot: Sweep, obstacles: &Obstacles) -> DVec2 {
        (0..ticks).for_each(|_| walker.walk(robot, obstacles));
        walker.disc().center
    }

    #[test]
    fn somebody_walks_to_the_end_of_the_path_and_back_again() {
        let (mut walker, free) = (walker(), walls(Vec::new()));
        for (ticks, x, y) in [(50, 1.0, 0.0), (75, 2.0, 0.5), (50, 2.0, 0.5), (75, 1.0, 0.0), (100, 1.0, 0.0)]
        {
            let at = after(&mut walker, ticks, far_robot(), &free);
            assert!(at.distance(DVec2::new(x, y)) < 1e-9, "{at}");
        }
    }

    #[test]
    fn somebody_stops_before_the_robot_and_goes_on_when_it_has_gone() {
        let (mut walker, free) = (walker(), walls(Vec::new()));
        let at = after(&mut walker, 150, robot(1.5, 0.0, 0.0, 0.0), &free);
        let gap = 1.5 - at.x - 0.45;
        assert!((POLITE..POLITE + 0.02 + 1e-9).contains(&gap), "{gap}");
        assert!(after(&mut walker, 50, far_robot(), &free).x > at.x + 0.9);
    }

    #[test]
    fn somebody_does_not_step_before_a_robot_that_drives_past() {
        let (mut walker, free) = (walker(), walls(Vec::new()));
        let drives_past = robot(1.5, -1.0, FRAC_PI_2, 0.8);
        let at = after(&mut walker, 150, drives_past, &free);
        assert!((0.88..=0.9 + 1e-9).contains(&at.x), "{at}");
        let (mut walker, has_passed) = (self::walker(), robot(1.5, 1.0, FRAC_PI_2, 0.8));
        assert!(after(&mut walker, 90, has_passed, &free).x > 1.7, "behind it the way is free");
    }

    #[test]
    fn somebody_in_the_way_of_a_robot_walks_on_out_of_it() {
        let (mut walker, free) = (walker(), walls(Vec::new()));
        after(&mut walker, 50, far_robot(), &free);
        let at = after(&mut walker, 40, robot(0.8, -1.0, FRAC_PI_2, 0.8), &free);
        assert!(at.x > 1.7, "{at}");
    }

    #[test]
    fn somebody_who_has_waited_long_enough_turns_round() {
        let (mut walker, free) = (walker(), walls(Vec::new()));
        let stands = robot(1.5, 0.0, 0.0, 0.0);
        let waits = after(&mut walker, 60, stands, &free);
        assert_eq!(after(&mut walker, 100, stands, &free), waits);
        assert!(after(&mut walker, 80, stands, &free).x < waits.x - 0.5);
    }

    #[test]
    fn somebody_turns_round_before_a_closed_door() {
        let mut walker = walker();
        let door = walls(vec![Segment::new(DVec2::new(1.0, -1.0), DVec2::new(1.0, 1.0))]);
        let mut farthest = 0.0_f64;
        for _ in 0..500 {
            farthest = farthest.max(after(&mut walker, 1, far_robot(), &door).x);
        }
        assert!((0.75..=0.8 + 1e-9).contains(&farthest), "{farthest}");
        assert!(after(&mut walker, 1, far_robot(), &door).x < 0.8);
    }

    #[test]
    fn somebody_on_a_path_without_length_stands() {
        let person = Person { path: vec![[1.0, 1.0], [1.0, 1.0]], speed: 2.0, radius: 0.2 };
        let mut walker = Walker::new(&person);
        assert_eq!(after(&mut walker, 100, far_robot(), &walls(Vec::new())), DVec2::ONE);
    }
}
