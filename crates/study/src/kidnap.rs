use cogmap_geometry::{DVec2, trig};
use cogmap_simulation::{Command, Driver, Robot, Session, Start, World};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::{Course, metrics::room_at};

/// How many places are drawn until one lies in another room.
const TRIES: usize = 50;

/// When a robot is picked up, and where it is set down again: on another point of its route, in
/// another room, looking along the route.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Kidnap {
    /// Steps that it goes before.
    pub(crate) steps: usize,
    /// The point of the route that it is set down on.
    point: usize,
}

impl Kidnap {
    /// What chance decides; `None` where nobody is kidnapped, or no other room is on the route.
    pub(crate) fn drawn(course: &Course, seed: u64) -> Option<Self> {
        let points = course.route.len();
        if !course.kidnap || points < 8 {
            return None;
        }
        let rooms: Vec<Vec<DVec2>> = course
            .world
            .rooms
            .iter()
            .map(|room| room.outline.iter().copied().map(DVec2::from).collect())
            .collect();
        let room = |point: usize| room_at(&rooms, course.route[point]);
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        (0..TRIES).find_map(|_| {
            // In the second or third quarter of the way, and down anywhere but at its very end.
            let steps = points / 4 + below(points / 2, &mut rng);
            let point = below(points - 3, &mut rng);
            let elsewhere = room(point).is_some() && room(point) != room(steps);
            elsewhere.then_some(Self { steps, point })
        })
    }

    /// Moves the robot, and lets the person at the controls go on from there.
    pub(crate) fn perform(
        self,
        session: &mut Session,
        course: &Course,
        robot: &Robot,
    ) -> Result<Driver, String> {
        let [here, next] = [course.route[self.point], course.route[self.point + 1]];
        let ahead = next - here;
        let heading_deg = trig::atan2(ahead.y, ahead.x).to_degrees();
        session.command(Command::Kidnap { position: here.into(), heading_deg });
        session.advance();
        let start = Start { position: here.into(), heading_deg };
        let world = World { start, ..course.world.as_ref().clone() };
        Driver::new(&world, robot, &course.route[self.point + 1..])
    }
}

/// A number from 0 to `most` - 1.
#[allow(clippy::cast_possible_truncation, reason = "the remainder is below `most`")]
fn below(most: usize, rng: &mut Pcg64Mcg) -> usize {
    (rng.next_u64() % most.max(1) as u64) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::world;

    #[test]
    fn a_kidnapped_robot_comes_down_in_another_room_and_its_wheels_do_not_notice() {
        let course = Course::through(&world("environment-b").unwrap(), "loop").unwrap();
        assert_eq!(Kidnap::drawn(&course, 1), None);
        let course = Course { kidnap: true, ..course };
        let robot = Robot::named("perfect").unwrap();
        let drive = crate::drive(&course, &robot, 1).unwrap();
        let first = drive.kidnapped.unwrap();
        let [before, after] = [&drive.looks[first - 1], &drive.looks[first]];
        assert!(before.world_from_robot.position.distance(after.world_from_robot.position) > 1.0);
        let believed = before.reading.odom_from_robot.from_here(after.reading.odom_from_robot);
        assert!(believed.position.length() < 0.5 && drive.arrived);
    }
}
