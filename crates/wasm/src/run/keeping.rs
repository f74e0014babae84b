use cogmap_formats::situation::{self, Situation};
use cogmap_simulation::Session;

use super::{Label, Run};
use crate::resumption::Resumption;

/// What is kept of a run, and how it is taken up again.
impl Run {
    /// A run that has to be gone through again, turn by turn with [`Run::resume`], before it can be taken up.
    pub(crate) fn resuming(session: Session, label: Label, resumption: Resumption) -> Self {
        Self { resumption: Some(resumption), ..Self::new(session, label, None) }
    }

    /// One more turn of what is to be gone through again. `false` once the run is where it was left.
    pub(crate) fn resume(&mut self) -> bool {
        let Some(mut resumption) = self.resumption.take() else { return false };
        if resumption.turn(&mut self.session) {
            self.resumption = Some(resumption);
            return true;
        }
        self.go_to(resumption.at);
        let (position, end) = (self.session.position(), self.session.end());
        self.live = resumption.live;
        self.driver = resumption.driver;
        let last = self.session.record().commands().last();
        self.told = position == end && last.is_some_and(|last| last.tick == end);
        false
    }

    /// The run at this moment, as [`Run::resuming`] takes it up again.
    pub(crate) fn situation(&self) -> String {
        let situation = Situation {
            record: self.session.record().clone(),
            at: self.session.position(),
            live: self.live,
            // A drawn way is kept as far as it has been driven: as the steps that the robot was told.
            on_route: self.driver.is_some() && !self.drawn,
        };
        situation::write(&situation, self.label.building.as_deref())
    }
}
