//! One step taken apart (§3.2.1): for each of its stages what the picture of the memory points out.

mod pointer;

use cogmap_mapping::{memory::SurfaceId, places::Wideness};
use cogmap_simulation::{Pilot, Session};

use crate::{Annotation, Role, Scene, homing_scene};
use pointer::Pointer;

/// A stage of what a mapper does with a view, in the order of §3.2.1, and of the decision that follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The laser looked around.
    Scan,
    /// What it saw became surfaces.
    Surfaces,
    /// Some of them were recognised.
    Recognised,
    /// How the robot moved, by its wheels or corrected.
    Movement,
    /// The reference target was chosen.
    Reference,
    /// All recognised surfaces placed the view.
    Together,
    /// A direction was left open, where odometry decided.
    Open,
    /// What was new entered the map.
    Placed,
    /// What was known, or not wanted, did not.
    Ignored,
    /// How wide it was on the way.
    Wideness,
    /// An exit was gone through.
    Exit,
    /// A local space was opened.
    NewAsr,
    /// A loop was closed.
    LoopClosed,
    /// The ways on were weighed.
    Options,
    /// One was taken.
    Choice,
    /// Something is not gone by any longer.
    Forgotten,
}

/// The surfaces that a robot on its way home does not go by; the map of this mapper keeps them (Fig. 3.29).
#[must_use]
pub fn distrusted(session: &Session, mapper: usize) -> Vec<SurfaceId> {
    let Some(mind) = session.mappers().get(mapper) else { return Vec::new() };
    if session.homing().and_then(Pilot::homing).is_none() {
        return Vec::new();
    }
    let remembered = mind.mfis().remembered();
    let distrusted = remembered.filter(|stored| !homing_scene::is_trusted(session, mapper, stored));
    distrusted.map(|stored| stored.id).collect()
}

/// Points out in the picture of a mapper's memory what a stage of its latest step is about.
pub fn point_out(scene: &mut Scene, session: &Session, mapper: usize, stage: Stage) {
    let (Some(journal), Some(mind)) = (session.journal().mappers.get(mapper), session.mappers().get(mapper))
    else {
        return;
    };
    let Some(report) = journal.reports.last() else { return };
    let mut pointer = Pointer { scene, mind, report };
    match stage {
        Stage::Scan => pointer.scan(session),
        Stage::Surfaces => pointer.surfaces(),
        Stage::Recognised => pointer.recognised(),
        Stage::Movement => pointer.movement(),
        Stage::Reference => pointer.reference(),
        Stage::Together => pointer.together(),
        Stage::Open => pointer.open(),
        Stage::Placed => pointer.placed(),
        Stage::Ignored => pointer.ignored(),
        Stage::Wideness => pointer.wideness(),
        Stage::Exit | Stage::NewAsr | Stage::LoopClosed => pointer.place(stage),
        Stage::Options | Stage::Choice => {
            if let Some(decision) = homing_scene::decision_in_force(session, mapper) {
                pointer.decision(decision, stage);
            }
        }
        Stage::Forgotten => {
            let forgotten = [report.forgot.clone(), distrusted(session, mapper)].concat();
            pointer.stored(Annotation::Flaw.into(), &forgotten, "not gone by any longer");
        }
    }
}

/// The narrowest of some places on the way.
#[must_use]
pub fn narrowest(wideness: &[Wideness]) -> Option<&Wideness> {
    wideness.iter().min_by(|a, b| a.width.total_cmp(&b.width))
}

impl From<Annotation> for Role {
    fn from(annotation: Annotation) -> Self {
        Self::Annotation(annotation)
    }
}

#[cfg(test)]
mod tests;
