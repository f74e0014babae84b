//! Takes the latest step of a mapper apart, from nothing but its own reports.

use cogmap_geometry::trig;
use cogmap_mapping::{
    Event, Mapper, Placement, StepReport,
    memory::{Along, Reference},
    perception::End,
};
use cogmap_navigation::Decision;
use cogmap_scene::{decision_in_force, distrusted, narrowest};
use cogmap_simulation::Session;

use crate::{
    clause::clauses,
    explanation::{
        AlongKind, Candidate, Corrected, Explanation, FittingPair, ReferenceReport, StageReport, Weighed,
    },
    homing::lead,
    memories::placement,
};

/// Why the map of a mapper is as it is after its latest view; nothing before its first.
pub(crate) fn explanation(session: &Session, mapper: usize) -> Option<Explanation> {
    let mind = session.mappers().get(mapper)?;
    let report = session.journal().mappers.get(mapper)?.reports.last()?;
    let mut stages = vec![scan(session, report), surfaces(report)];
    if report.step > 0 && !mind.is_odometry() {
        stages.push(recognised(report));
    }
    stages.extend(placing(report));
    stages.extend(placed(report, mind));
    stages.extend(places(report, mind));
    if let Some(decision) = decision_in_force(session, mapper) {
        stages.extend(deciding(decision));
    }
    let forgotten = (report.forgot.len(), distrusted(session, mapper).len());
    if forgotten != (0, 0) {
        stages.push(StageReport::Forgotten { by_map: forgotten.0, by_navigation: forgotten.1 });
    }
    let name = session.record().mappers.get(mapper)?.name().to_owned();
    Some(Explanation { mapper: name, step: report.step, t: report.t, stages })
}

fn scan(session: &Session, report: &StepReport) -> StageReport {
    let taken = session.journal().odometry.last().is_some_and(|last| last.t == report.t);
    StageReport::Scan { beams: session.last_scan().filter(|_| taken).map(|scan| scan.ranges.len()) }
}

fn surfaces(report: &StepReport) -> StageReport {
    let surfaces = &report.view.surfaces;
    let count =
        |kind: End| surfaces.iter().flat_map(|surface| surface.ends).filter(|end| *end == kind).count();
    StageReport::Surfaces {
        seen: surfaces.len(),
        true_ends: count(End::True),
        occluded: count(End::Occlusion),
        at_limit: count(End::RangeLimit),
    }
}

fn recognised(report: &StepReport) -> StageReport {
    let pair = |pair: &cogmap_mapping::memory::Match| FittingPair {
        seen: pair.seen,
        known: pair.known.0,
        d1: pair.fit.d1,
        d2: pair.fit.d2,
        phi_deg: pair.fit.phi.to_degrees(),
        error: pair.fit.error,
    };
    StageReport::Recognised {
        seen: report.view.surfaces.len(),
        by_map: report.matches.iter().filter(|pair| pair.previous.is_none()).count(),
        pairs: report.matches.iter().map(pair).collect(),
    }
}

/// What said where the robot is.
fn placing(report: &StepReport) -> Vec<StageReport> {
    let mut stages = Vec::new();
    match (report.placement, report.references.first()) {
        (Placement::Reference | Placement::WeakReference, Some(best)) => {
            stages.push(StageReport::Reference(reference(report, best)));
        }
        (Placement::Consensus | Placement::PartlyOdometry, _) => {
            stages.push(StageReport::Together { surfaces: report.matches.len() });
        }
        (Placement::Transform | Placement::Odometry, _) => {
            stages.push(StageReport::Movement { corrected: corrected(report) });
        }
        _ => {}
    }
    if report.placement == Placement::PartlyOdometry {
        let along_deg = report.open.map(|open| trig::atan2(open.y, open.x).to_degrees());
        stages.push(StageReport::Open { along_deg });
    }
    stages.extend(
        report
            .lost
            .map(|lost| StageReport::Lost { matched: lost.matched, contradiction: lost.contradiction }),
    );
    stages.extend(report.recalled.map(|recalled| StageReport::Found { way: recalled.way }));
    stages
}

fn corrected(report: &StepReport) -> Option<Corrected> {
    let correction = report.correction.as_ref()?;
    Some(Corrected {
        turn_deg: correction.turn.to_degrees(),
        travel: correction.travel,
        before: *correction.errors.first()?,
        after: *correction.errors.last()?,
        changes: correction.errors.len() - 1,
    })
}

fn reference(report: &StepReport, best: &Reference) -> ReferenceReport {
    let seen = report.view.surfaces.get(best.seen);
    let (along, crossing) = match best.along {
        Along::FirstEnd | Along::SecondEnd => (AlongKind::End, None),
        Along::Crossing(other) => (AlongKind::Crossing, Some(other.0)),
        Along::GuessedEnd => (AlongKind::Guess, None),
    };
    let candidate =
        |pair: &Reference| Candidate { seen: pair.seen, known: pair.known.0, quality: pair.quality };
    ReferenceReport {
        seen: best.seen,
        known: best.known.0,
        length: seen.map_or(0.0, cogmap_mapping::perception::Surface::length),
        range: seen.map_or(0.0, |surface| surface.range),
        incidence_deg: seen.map_or(0.0, |surface| surface.incidence.to_degrees()),
        along,
        crossing,
        candidates: report.references.iter().map(candidate).collect(),
    }
}

/// What entered the map and what did not.
fn placed(report: &StepReport, mind: &Mapper) -> Vec<StageReport> {
    let index = |id| Some(mind.mfis().get(id)?.index_in_view);
    let placed: Vec<usize> = report.placed.iter().filter_map(|&id| index(id)).collect();
    let is_known = |index: &usize| report.matches.iter().any(|pair| pair.seen == *index);
    let ignored = (0..report.view.surfaces.len()).filter(|index| !placed.contains(index));
    let (known, others): (Vec<usize>, Vec<usize>) = ignored.partition(is_known);
    let mut stages = vec![StageReport::Placed {
        surfaces: report.placed.iter().map(|id| id.0).collect(),
        by: placement(report.placement),
        reference: report.reference_target().map(|best| best.known.0),
    }];
    if !(known.is_empty() && others.is_empty()) {
        stages.push(StageReport::Ignored { known: known.len(), others: others.len() });
    }
    stages
}

/// What it meant for the network of local spaces.
fn places(report: &StepReport, mind: &Mapper) -> Vec<StageReport> {
    let Some(place) = &report.place else { return Vec::new() };
    let mut stages = Vec::new();
    if let (Some(least), Some(here)) = (narrowest(&place.wideness), place.wideness.last()) {
        let samples = place.wideness.len();
        stages.push(StageReport::Wideness { here: here.width, least: least.width, samples });
    }
    let width = |exit| Some(mind.network()?.exit(exit)?.segment.length());
    stages.extend(place.events.iter().filter_map(|event| match event {
        Event::Exit { exit, why } => {
            Some(StageReport::Exit { exit: exit.0, width: width(*exit), why: clauses(why) })
        }
        Event::NewAsr { asr, exit, moved } => {
            Some(StageReport::NewAsr { asr: asr.0, exit: exit.0, moved: *moved })
        }
        Event::LoopClosed { asr, instead_of, overlap, why, .. } => Some(StageReport::LoopClosed {
            asr: asr.0,
            instead_of: instead_of.map(|asr| asr.0),
            overlap: *overlap,
            why: clauses(why),
        }),
        _ => None,
    }));
    stages
}

/// What a robot on its way home decided.
fn deciding(decision: &Decision) -> Vec<StageReport> {
    let weighed = decision.options.iter().enumerate().map(|(index, option)| Weighed {
        detour: option.detour,
        score: option.score,
        barred: option.barred,
        chosen: decision.chosen == Some(index),
    });
    let options: Vec<Weighed> = weighed.collect();
    let weighing = (!options.is_empty()).then_some(StageReport::Options { options });
    let choice = StageReport::Choice {
        step: decision.step,
        lead: lead(decision.mode),
        option: decision.chosen.map(|index| index + 1),
        why: clauses(&decision.why),
    };
    weighing.into_iter().chain([choice]).collect()
}
