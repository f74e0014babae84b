use cogmap_geometry::Pose;
use cogmap_mapping::{Event, Mapper, StepReport};
use cogmap_navigation::Decision;

use super::feed::Observation;
use crate::{SOMEBODY, SessionEvent, Strategy, WorldEvent};

/// A pose and when it was held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stamped {
    /// Seconds.
    pub t: f64,
    /// In the frame that the list is about.
    pub pose: Pose,
}

/// What a run has brought to light so far: all output files are written from it. It only grows.
#[derive(Clone, Debug, Default)]
pub struct Journal {
    /// The robot in the world, one a scan; empty for recorded logs.
    pub truth: Vec<Stamped>,
    /// The robot in the odometry's frame, one a scan.
    pub odometry: Vec<Stamped>,
    /// The ways home, one for each time that the robot was told to go home.
    pub homings: Vec<Homeward>,
    /// What a robot on its way home decided each time that it had come to rest.
    pub decisions: Vec<Decision>,
    /// One a mapper, in the order of the record.
    pub mappers: Vec<MapperJournal>,
}

/// Where in the lists a way home begins: at its first decision.
#[derive(Clone, Debug, PartialEq)]
pub struct Homeward {
    /// Who finds it.
    pub strategy: Strategy,
    /// How many scans had been taken.
    pub scans: usize,
    /// How many decisions had been made.
    pub decisions: usize,
}

/// What one mapper made of the run.
#[derive(Clone, Debug, Default)]
pub struct MapperJournal {
    /// The robot in this mapper's map, one a scan (those that it let pass are bridged by odometry).
    pub estimate: Vec<Stamped>,
    /// What it did with each view.
    pub reports: Vec<StepReport>,
    /// What happened: the number of the latest view, and the event. What happened in the world and on the
    /// way home stands here beside what the mapper did.
    pub events: Vec<(usize, SessionEvent)>,
    /// For each stored surface the solid of the world that most of its points lie on; empty for logs.
    pub true_walls: Vec<Option<u32>>,
}

/// How long the lists were at some moment; cutting them to it goes back there.
pub(super) struct Lengths {
    scans: usize,
    homings: usize,
    decisions: usize,
    mappers: Vec<[usize; 3]>,
}

impl Journal {
    pub(super) fn for_mappers(count: usize) -> Self {
        Self { mappers: vec![MapperJournal::default(); count], ..Self::default() }
    }

    /// Writes down a scan and what each mapper made of it.
    pub(super) fn write(
        &mut self,
        observation: &Observation,
        mappers: &[Mapper],
        reports: Vec<Option<StepReport>>,
    ) {
        let (t, odom_from_robot) = (observation.reading.t, observation.reading.odom_from_robot);
        self.truth.extend(observation.world_from_robot.map(|pose| Stamped { t, pose }));
        self.odometry.push(Stamped { t, pose: odom_from_robot });
        for ((journal, mapper), report) in self.mappers.iter_mut().zip(mappers).zip(reports) {
            let pose = mapper.map_from_robot(odom_from_robot);
            journal.estimate.extend(pose.map(|pose| Stamped { t, pose }));
            if let Some(report) = report {
                journal.write(report, mapper, &observation.beam_solids);
            }
        }
    }

    /// Begins to write down a way home.
    pub(super) fn turn_home(&mut self, strategy: Strategy) {
        let (scans, decisions) = (self.odometry.len(), self.decisions.len());
        self.homings.push(Homeward { strategy, scans, decisions });
    }

    /// Writes down what a robot on its way home decided, and what happened to it.
    pub(super) fn decide(&mut self, decision: Decision) {
        for event in &decision.events {
            self.note(&SessionEvent::Homing(event.clone()));
        }
        self.decisions.push(decision);
    }

    /// Writes down what did not happen to the map alone.
    pub(super) fn note(&mut self, event: &SessionEvent) {
        for journal in &mut self.mappers {
            let step = journal.reports.len().saturating_sub(1);
            journal.events.push((step, event.clone()));
        }
    }

    pub(super) fn lengths(&self) -> Lengths {
        let of = |m: &MapperJournal| [m.reports.len(), m.events.len(), m.true_walls.len()];
        Lengths {
            scans: self.odometry.len(),
            homings: self.homings.len(),
            decisions: self.decisions.len(),
            mappers: self.mappers.iter().map(of).collect(),
        }
    }

    pub(super) fn cut(&mut self, to: &Lengths) {
        self.truth.truncate(to.scans);
        self.odometry.truncate(to.scans);
        self.homings.truncate(to.homings);
        self.decisions.truncate(to.decisions);
        for (journal, [reports, events, walls]) in self.mappers.iter_mut().zip(&to.mappers) {
            journal.estimate.truncate(to.scans);
            journal.reports.truncate(*reports);
            journal.events.truncate(*events);
            journal.true_walls.truncate(*walls);
        }
    }
}

impl MapperJournal {
    /// What happened to the map alone, and in which view.
    pub fn map_events(&self) -> impl DoubleEndedIterator<Item = (usize, &Event)> {
        self.events.iter().filter_map(|(step, event)| match event {
            SessionEvent::Map(event) => Some((*step, event)),
            _ => None,
        })
    }

    /// Where the robot drove into something, in the world, metres.
    pub fn collisions(&self) -> impl Iterator<Item = [f64; 2]> {
        self.events.iter().filter_map(|(_, event)| match event {
            SessionEvent::World(WorldEvent::Collision { position }) => Some(*position),
            _ => None,
        })
    }

    fn write(&mut self, report: StepReport, mapper: &Mapper, beam_solids: &[Option<u32>]) {
        self.events.extend(report.events().into_iter().map(|event| (report.step, SessionEvent::Map(event))));
        if !beam_solids.is_empty() {
            let sightings = report.placed.iter().filter_map(|&id| mapper.mfis().get(id));
            let surfaces = sightings.filter_map(|stored| report.view.surfaces.get(stored.index_in_view));
            let walls = surfaces.map(|surface| wall_of(&beam_solids[surface.beams[0]..=surface.beams[1]]));
            self.true_walls.extend(walls);
        }
        self.reports.push(report);
    }
}

/// The solid that most of the beams hit, of equals the one with the smallest number; `None` where that is
/// somebody who walks about.
#[must_use]
pub fn wall_of(beams: &[Option<u32>]) -> Option<u32> {
    let mut hits: Vec<u32> = beams.iter().flatten().copied().collect();
    hits.sort_unstable();
    let mut best: Option<(usize, u32)> = None;
    for run in hits.chunk_by(|a, b| a == b) {
        if best.is_none_or(|(count, _)| run.len() > count) {
            best = Some((run.len(), run[0]));
        }
    }
    best.map(|(_, solid)| solid).filter(|&solid| solid != SOMEBODY)
}
