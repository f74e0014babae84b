//! What the mappers have in mind, in figures and for words.

use cogmap_mapping::{Event, Mapper, MapperSetup, Placement, StepReport};
use cogmap_simulation::{MapperJournal, Session};
use cogmap_study::metrics::{Sample, closing};

use crate::{
    status::{Happened, Happening, LastView, MemoryStatus, Offset, PlacementKind, ReferencePair},
    views::View,
};

/// What each mapper has in mind at this moment.
pub(crate) fn memories(session: &Session) -> Vec<MemoryStatus> {
    let minds = session.mappers().iter().zip(&session.journal().mappers);
    let setups = &session.record().mappers;
    let each = View::MEMORIES.into_iter().zip(setups).zip(minds);
    let memories = each.map(|((view, setup), (mapper, journal))| memory(view, setup, mapper, journal));
    let offsets = (0..).map(|index| offset(session, index));
    memories.zip(offsets).map(|(memory, off)| MemoryStatus { off, ..memory }).collect()
}

fn memory(view: View, setup: &MapperSetup, mapper: &Mapper, journal: &MapperJournal) -> MemoryStatus {
    MemoryStatus {
        view,
        mapper: setup.name().to_owned(),
        surfaces: mapper.mfis().remembered().count(),
        views: journal.reports.len(),
        asrs: mapper.network().map(|network| network.asrs().len()),
        exits: mapper.network().map(|network| network.exits().len()),
        off: None,
        last: journal.reports.last().map(last_view),
        happened: happened(mapper, journal),
    }
}

/// How far the robot is from where it believes it is.
fn offset(session: &Session, mapper: usize) -> Option<Offset> {
    let mapper = session.mappers().get(mapper)?;
    let first = Sample {
        world_from_robot: session.journal().truth.first()?.pose,
        map_from_robot: mapper.mfis().place_of(mapper.path().first()?),
    };
    let here = Sample {
        world_from_robot: session.world_from_robot()?,
        map_from_robot: mapper.map_from_robot(session.odom_from_robot())?,
    };
    off(first, here)
}

/// How far the robot is from where it believes it is, the frames of map and world meeting at the first view:
/// as the studies measure it (`gap` and `heading_gap`).
pub(crate) fn off(first: Sample, here: Sample) -> Option<Offset> {
    let closing = closing(&[first, here])?;
    Some(Offset { distance: closing.gap, heading_deg: closing.heading.to_degrees() })
}

/// The latest event that is worth a word. Of several in one view the last says most: that a loop was
/// closed rather than that an exit was crossed.
fn happened(mapper: &Mapper, journal: &MapperJournal) -> Option<Happened> {
    if mapper.is_odometry() {
        return None; // it recognises nothing, so it is never lost and never found
    }
    let now = journal.reports.last()?.t;
    journal.map_events().rev().find_map(|(step, event)| {
        let report = journal.reports.get(step)?;
        let what = happening(event, report)?;
        Some(Happened { step, ago: now - report.t, what })
    })
}

pub(crate) fn happening(event: &Event, report: &StepReport) -> Option<Happening> {
    Some(match event {
        Event::Exit { exit, .. } => {
            Happening::Exit { exit: exit.0, asr: report.place.as_ref().map_or(0, |place| place.asr.0) }
        }
        Event::NewAsr { asr, exit, .. } => Happening::NewAsr { asr: asr.0, exit: exit.0 },
        Event::LoopClosed { asr, exit, .. } => Happening::LoopClosed { asr: asr.0, exit: exit.0 },
        Event::Recognised(_) => Happening::Recognised,
        Event::Lost { .. } => Happening::Lost,
        Event::Fallback { matches: 0, .. } => Happening::Unseen,
        _ => return None,
    })
}

fn last_view(report: &StepReport) -> LastView {
    let reference = report.references.first();
    LastView {
        step: report.step,
        seen: report.view.surfaces.len(),
        recognised: report.matches.len(),
        placed: report.placed.len(),
        placement: placement(report.placement),
        reference: reference.map(|pair| ReferencePair { seen: pair.seen, known: pair.known.0 }),
    }
}

/// What a view was placed by, for the page.
pub(crate) fn placement(placement: Placement) -> PlacementKind {
    match placement {
        Placement::First => PlacementKind::First,
        Placement::Reference => PlacementKind::Reference,
        Placement::WeakReference => PlacementKind::WeakReference,
        Placement::Consensus => PlacementKind::Consensus,
        Placement::Transform => PlacementKind::Transform,
        Placement::PartlyOdometry => PlacementKind::PartlyOdometry,
        Placement::Odometry => PlacementKind::Odometry,
    }
}
