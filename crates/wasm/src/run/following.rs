use cogmap_geometry::DVec2;
use cogmap_simulation::Command;

use super::Run;
use crate::ways::{self, Followed};

/// How a run follows a way that a person drew.
impl Run {
    /// Sends the robot along a line in the world. It comes to rest first, unless it is, and then is told step after step.
    pub(crate) fn follow(&mut self, line: &[DVec2]) -> Followed {
        let (driver, followed) = match ways::driver(&self.session, line) {
            Ok(found) => found,
            Err(objection) => return objection,
        };
        self.courses.leave(&self.session, self.course());
        if self.session.position() < self.session.end() || !self.session.at_rest() {
            self.enter(Command::Stop);
        }
        (self.driver, self.drawn, self.live) = (Some(driver), true, true);
        followed
    }

    /// Where the robot is and what it still has to pass of a drawn way; nothing where it follows none.
    pub(crate) fn way_ahead(&self) -> Vec<DVec2> {
        let driver = self.driver.as_ref().filter(|_| self.drawn);
        let robot = self.session.world_from_robot().map(|pose| pose.position);
        let ahead = driver.zip(robot).map(|(driver, robot)| std::iter::once(robot).chain(driver.ahead()));
        ahead.map(Iterator::collect).unwrap_or_default()
    }

    /// Metres that are left of a drawn way, while the robot follows one.
    pub(super) fn way_left(&self) -> Option<f64> {
        let ahead = self.way_ahead();
        let (robot, points) = ahead.split_first()?;
        Some(ways::length(*robot, points.iter().copied()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::two_rooms::two_rooms;
    use cogmap_simulation::TimedCommand;

    fn told(run: &Run) -> Vec<TimedCommand> {
        run.session().record().commands().to_vec()
    }

    fn finish(run: &mut Run) {
        while run.advance() {}
    }

    /// Back through the door that the robot has come through.
    const THROUGH: [[f64; 2]; 3] = [[9.0, 2.5], [6.0, 2.5], [3.0, 2.5]];

    #[test]
    fn a_drawn_way_is_driven_in_steps_that_are_written_down_and_undone_at_once() {
        let mut run = two_rooms();
        let before = told(&run);
        let followed = run.follow(&THROUGH.map(DVec2::from));
        let Followed::Going { metres, around } = followed else { panic!("{followed:?}") };
        assert!((5.5..7.5).contains(&metres) && !around, "{metres}");
        assert!(run.status().way_left.is_some() && !run.status().on_route);
        assert!(!run.situation().contains("\"on_route\":true"));
        finish(&mut run);
        assert!(run.status().way_left.is_none());
        let [x, y, _] = run.status().pose.unwrap();
        assert!(DVec2::new(x, y).distance(DVec2::new(3.0, 2.5)) < 0.3, "[{x}, {y}]");
        assert!(told(&run).len() > before.len() + 1);
        assert!(run.undo());
        assert_eq!(told(&run), before);
        assert!(run.status().way_left.is_none());
        assert!(run.redo());
        assert!(told(&run).len() > before.len() + 1);
    }

    #[test]
    fn going_back_into_the_midst_of_it_finds_the_rest_of_the_way() {
        let mut run = two_rooms();
        run.follow(&THROUGH.map(DVec2::from));
        for _ in 0..30 {
            run.advance();
        }
        run.follow(&[DVec2::new(10.0, 1.0)]);
        assert!(run.undo());
        assert!(run.status().way_left.is_some_and(|left| left > 2.0));
        finish(&mut run);
        assert!(run.status().pose.is_some_and(|[x, _, _]| x < 3.3));
    }

    #[test]
    fn what_cannot_be_followed_changes_nothing() {
        let mut run = two_rooms();
        let before = told(&run);
        let [x, y, _] = run.status().pose.unwrap();
        assert_eq!(run.follow(&[]), Followed::NoLine);
        assert_eq!(run.follow(&[DVec2::new(x + 0.1, y), DVec2::NAN]), Followed::NoLine);
        assert_eq!(run.follow(&[DVec2::new(0.0, 0.0)]), Followed::NoRoom);
        assert_eq!(run.follow(&[DVec2::new(-0.6, -0.6)]), Followed::Unreachable);
        assert_eq!(told(&run), before);
        assert_eq!(run.status().undoable, 0);
    }

    #[test]
    fn an_order_ends_it() {
        let mut run = two_rooms();
        run.follow(&THROUGH.map(DVec2::from));
        run.advance();
        run.order(crate::Order::Stop).unwrap();
        assert!(run.status().way_left.is_none());
        finish(&mut run);
        assert!(run.status().pose.is_some_and(|[x, _, _]| x > 8.0));
    }
}
