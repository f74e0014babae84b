use cogmap_geometry::DVec2;

use crate::{Disc, Obstacles, Person, TICK};

/// How near somebody comes to the robot's edge, metres.
const POLITE: f64 = 0.15;

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
}

impl Walker {
    pub(super) fn new(person: &Person) -> Self {
        let path: Vec<DVec2> = person.path.iter().map(|&point| point.into()).collect();
        let disc = Disc { center: path.first().copied().unwrap_or(DVec2::NAN), radius: person.radius };
        Self { path, stride: person.speed * TICK, disc, toward: 0, onward: true }
    }

    pub(super) fn disc(&self) -> Disc {
        self.disc
    }

    /// Walks on for a tick. Stops where the robot would come too near, and turns round before a solid
    /// that stands in the way.
    pub(super) fn walk(&mut self, robot: Disc, obstacles: &Obstacles) {
        let (toward, onward, center) = self.next();
        let nearer_to_robot = center.distance(robot.center) < self.disc.center.distance(robot.center);
        let gap = center.distance(robot.center) - robot.radius - self.disc.radius;
        if nearer_to_robot && gap < POLITE {
            return;
        }
        let room =
            |at: DVec2| obstacles.nearest(at, self.disc.radius).map_or(self.disc.radius, |n| n.distance);
        if room(center) < room(self.disc.center) - 1e-9 {
            (self.toward, self.onward) = self.turned();
            return;
        }
        (self.toward, self.onward, self.disc.center) = (toward, onward, center);
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
    use cogmap_geometry::Segment;

    use super::*;
    use crate::Solids;

    fn walker() -> Walker {
        Walker::new(&Person { path: vec![[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]], speed: 1.0, radius: 0.2 })
    }

    fn far_robot() -> Disc {
        Disc { center: DVec2::new(50.0, 50.0), radius: 0.25 }
    }

    fn walls(segments: Vec<Segment>) -> Obstacles {
        Obstacles::new(&Solids { segments, ..Solids::default() })
    }

    fn after(walker: &mut Walker, ticks: u32, robot: Disc, obstacles: &Obstacles) -> DVec2 {
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
        let robot = Disc { center: DVec2::new(1.5, 0.0), radius: 0.25 };
        let at = after(&mut walker, 200, robot, &free);
        let gap = robot.center.x - at.x - 0.45;
        assert!((POLITE..POLITE + 0.02 + 1e-9).contains(&gap), "{gap}");
        assert!(after(&mut walker, 50, far_robot(), &free).x > at.x + 0.9);
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
