use cogmap_geometry::Pose;
use cogmap_mapping::{Event, StepReport};

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
    /// What happened in the world: step, event.
    pub events: Vec<(usize, Event)>,
    /// One a mapper, in the order of the record.
    pub mappers: Vec<MapperJournal>,
}

/// What one mapper made of the run.
#[derive(Clone, Debug, Default)]
pub struct MapperJournal {
    /// The robot in this mapper's map, one a scan (those that it let pass are bridged by odometry).
    pub estimate: Vec<Stamped>,
    /// What it did with each view.
    pub reports: Vec<StepReport>,
    /// For each stored surface the solid of the world that most of its points lie on; empty for logs.
    pub true_walls: Vec<Option<u32>>,
}
