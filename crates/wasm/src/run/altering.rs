use cogmap_geometry::DVec2;
use cogmap_simulation::Command;

use super::Run;
use crate::alteration::{Alteration, Objection, Pointer, command, objection};

/// What a person changes around the robot, or does to it unseen.
impl Run {
    /// Changes something at this moment, and lets a tick go by in which it happens. The robot goes on with what
    /// it was about; only who is carried off, or goes on from an earlier moment, waits for orders. An objection
    /// says why nothing was changed.
    pub(crate) fn alter(
        &mut self,
        alteration: &Alteration,
        pointer: impl Fn(DVec2) -> Pointer,
    ) -> Option<Objection> {
        let command = match command(&self.session, alteration, pointer) {
            Ok(command) => command,
            Err(objection) => return Some(objection),
        };
        if let Some(reason) = self.session.refusal(&command) {
            return Some(objection(&command, reason));
        }
        self.courses.leave(&self.session, self.course());
        if matches!(command, Command::Kidnap { .. }) || self.session.position() < self.session.end() {
            self.driver = None;
        }
        self.enter(command);
        self.advance();
        if let (Some(driver), Some(world)) = (&mut self.driver, self.session.world()) {
            driver.see(world);
        }
        None
    }
}
