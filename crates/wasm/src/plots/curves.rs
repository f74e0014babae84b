use cogmap_mapping::{
    Event, Mapper, StepReport,
    places::{Crossing, Network},
};
use cogmap_simulation::{MapperJournal, Session, Stamped};
use cogmap_study::metrics::Sample;

use super::{Curve, Narrow, OffCurve, Plots, WidenessCurve};
use crate::{memories::off, views::View};

/// The curves of a run, noted as it goes: the journal forgets what lies ahead when the run goes back.
#[derive(Clone, Debug, Default)]
pub(crate) struct Curves(Plots);

impl Curves {
    /// Notes the views that are new since the last time.
    pub(crate) fn note(&mut self, session: &Session, position_at: impl Fn(f64) -> u64) {
        let minds = session.mappers().iter().zip(&session.journal().mappers);
        let each = View::MEMORIES.into_iter().zip(&session.record().mappers).zip(minds);
        for (index, ((view, setup), (mind, journal))) in each.enumerate() {
            let Some(first) = journal.reports.first() else { continue };
            let truth = &session.journal().truth;
            let curve = match self.0.curves.get_mut(index) {
                Some(curve) => curve,
                None => self.0.curves.push_mut(Curve::new(view, setup.name(), !truth.is_empty(), mind)),
            };
            let mark = |t: f64| (t - first.t, position_at(t) as f64);
            for report in journal.reports.get(curve.times.len()..).unwrap_or_default() {
                curve.add(report, mark(report.t));
                curve.add_off(sample(first, truth), sample(report, truth));
                curve.add_way(report, (mind, journal), mark);
            }
        }
    }

    /// Drops what lies after a position: it belongs to a run that will not be.
    pub(crate) fn forget_after(&mut self, position: u64) {
        for curve in &mut self.0.curves {
            curve.forget_after(position as f64);
        }
    }

    pub(crate) fn all(&self) -> &Plots {
        &self.0
    }
}

impl Curve {
    fn new(view: View, mapper: &str, truth: bool, mind: &Mapper) -> Self {
        Self {
            view,
            mapper: mapper.to_owned(),
            times: Vec::new(),
            positions: Vec::new(),
            surfaces: Vec::new(),
            off: truth.then(OffCurve::default),
            wideness: mind.network().map(|_| WidenessCurve::default()),
        }
    }

    fn add(&mut self, report: &StepReport, (t, position): (f64, f64)) {
        let before = self.surfaces.last().copied().unwrap_or(0.0);
        self.surfaces.push(before + report.placed.len() as f64 - report.forgot.len() as f64);
        self.times.push(t);
        self.positions.push(position);
    }

    fn add_off(&mut self, first: Option<Sample>, here: Option<Sample>) {
        let Some(curve) = &mut self.off else { return };
        let off = first.zip(here).and_then(|(first, here)| off(first, here));
        curve.metres.push(off.map_or(f64::NAN, |off| off.distance));
        curve.degrees.push(off.map_or(f64::NAN, |off| off.heading_deg));
    }

    /// How wide it was on the way to a view, and through which exits it led.
    fn add_way(
        &mut self,
        report: &StepReport,
        (mind, journal): (&Mapper, &MapperJournal),
        mark: impl Fn(f64) -> (f64, f64),
    ) {
        let (Some(curve), Some(place)) = (&mut self.wideness, &report.place) else { return };
        let time_of = |step: usize| journal.reports.get(step).map_or(report.t, |report| report.t);
        let (from, to) = (time_of(report.step.saturating_sub(1)), report.t);
        let count = place.wideness.len() as f64;
        for (number, wideness) in (1_u32..).zip(&place.wideness) {
            curve.times.push(mark(from + (to - from) * f64::from(number) / count).0);
            curve.metres.push(wideness.width);
        }
        let crossings = mind.network().map_or(&[][..], Network::crossings);
        let gone = &crossings[crossings.partition_point(|crossing| crossing.step < report.step)..];
        let exits = place.events.iter().filter_map(|event| match event {
            Event::Exit { exit, .. } => Some(*exit),
            _ => None,
        });
        for (exit, crossing) in exits.zip(gone.iter().filter(|crossing| crossing.step == report.step)) {
            let found = place.events.iter().find_map(|event| match event {
                Event::NewAsr { asr, exit: its, .. } if *its == exit => Some(*asr),
                Event::LoopClosed { asr, exit: its, instead_of: None, .. } if *its == exit => Some(*asr),
                _ => None,
            });
            let Some((t, metres)) = narrowest(journal, crossing) else { continue };
            let (asr, position) = (found.unwrap_or(place.asr).0, mark(report.t).1);
            let (t, exit, found) = (mark(t).0, exit.0, found.is_some());
            curve.exits.push(Narrow { t, metres, exit, asr, found, position });
        }
    }

    fn forget_after(&mut self, position: f64) {
        let kept = self.positions.partition_point(|&at| at <= position);
        let last = kept.checked_sub(1).map_or(f64::NEG_INFINITY, |last| self.times[last]);
        for list in [&mut self.times, &mut self.positions, &mut self.surfaces] {
            list.truncate(kept);
        }
        if let Some(off) = &mut self.off {
            off.metres.truncate(kept);
            off.degrees.truncate(kept);
        }
        if let Some(way) = &mut self.wideness {
            let kept = way.times.partition_point(|&t| t <= last);
            way.times.truncate(kept);
            way.metres.truncate(kept);
            way.exits.retain(|exit| exit.position <= position);
        }
    }
}

/// Where the robot was when a view was taken, and where it believed to be; nothing without the truth.
fn sample(report: &StepReport, truth: &[Stamped]) -> Option<Sample> {
    let there = truth.get(truth.partition_point(|stamped| stamped.t < report.t))?;
    Some(Sample { world_from_robot: there.pose, map_from_robot: report.map_from_robot })
}

/// The sample of wideness that lies nearest to an exit on the way through it: when, and how wide.
fn narrowest(journal: &MapperJournal, crossing: &Crossing) -> Option<(f64, f64)> {
    let [before, after] = [crossing.view, crossing.view + 1].map(|step| journal.reports.get(step));
    let (before, after) = (before?, after?);
    let exit = (before.map_from_robot * crossing.robot_from_exit).midpoint();
    let samples = &after.place.as_ref()?.wideness;
    let off = |at: usize| samples[at].chord.midpoint().distance(exit);
    let nearest = (0..samples.len()).min_by(|&a, &b| off(a).total_cmp(&off(b)))?;
    let share = (nearest + 1) as f64 / samples.len() as f64;
    Some((before.t + (after.t - before.t) * share, samples[nearest].width))
}

#[cfg(test)]
mod tests {
    use cogmap_simulation::Command;

    use crate::two_rooms::{drive, two_rooms};

    #[test]
    fn the_curves_end_in_what_the_status_says() {
        let mut run = two_rooms();
        let plots = run.plots().clone();
        let status = run.status();
        for (curve, memory) in plots.curves.iter().zip(&status.memories) {
            assert_eq!(curve.times.len(), memory.views);
            assert_eq!(*curve.surfaces.last().unwrap() as usize, memory.surfaces);
            let (off, told) = (curve.off.as_ref().unwrap(), memory.off.unwrap());
            assert!((off.metres.last().unwrap() - told.distance).abs() < 1e-9);
            assert!((off.degrees.last().unwrap() - told.heading_deg).abs() < 1e-9);
            assert_eq!((off.metres[0], off.degrees[0]), (0.0, 0.0));
        }
        assert!(plots.curves[1].off.as_ref().unwrap().metres.last().unwrap() > &0.01);
        assert!(plots.curves[1].wideness.is_none());
    }

    #[test]
    fn the_door_is_a_minimum_that_became_an_exit() {
        let mut run = two_rooms();
        let way = run.plots().curves[0].wideness.clone().unwrap();
        let [door] = way.exits[..] else { panic!("{:?}", way.exits) };
        assert!(door.found && door.asr == 1 && (0.7..1.0).contains(&door.metres), "{door:?}");
        let least = way.metres.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(door.metres < least + 0.05);
        assert!(way.times.contains(&door.t) && way.times.is_sorted());
    }

    #[test]
    fn what_lies_ahead_is_kept_until_the_run_goes_on_otherwise() {
        let mut run = two_rooms();
        let all = run.plots().clone();
        let middle = all.curves[0].positions[4];
        run.jump(middle as u64);
        assert_eq!(run.plots(), &all);
        run.jump(u64::MAX);
        assert_eq!(run.plots(), &all);
        run.jump(middle as u64);
        run.enter(Command::Stop);
        let curve = &run.plots().curves[0];
        assert_eq!(curve.positions, all.curves[0].positions[..5]);
        let (way, before) = (curve.wideness.as_ref().unwrap(), all.curves[0].wideness.as_ref().unwrap());
        assert!(way.exits.is_empty() && way.metres.len() < before.metres.len());
        assert_eq!(way.metres, before.metres[..way.metres.len()]);
        drive(&mut run, 2);
        assert_eq!(run.plots().curves[0].times.len(), 7);
    }

    #[test]
    fn noting_now_and_then_gives_the_same_as_noting_at_the_end() {
        let mut run = two_rooms();
        let at_once = run.plots().clone();
        let positions = at_once.curves[0].positions.clone();
        run.jump(0);
        run.forget_after(0);
        for position in positions {
            run.jump(position as u64);
            run.plots();
        }
        run.jump(u64::MAX);
        assert_eq!(run.plots(), &at_once);
    }
}
