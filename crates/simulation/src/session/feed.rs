use std::sync::Arc;

use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::perception::{Reading, Scan};

use super::{SessionRecord, Stamped, drive::Drive};
use crate::Problem;

/// A recorded log: what reached the robot's program, and nothing of the truth.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recording {
    /// The scans, in order of time.
    pub readings: Vec<Reading>,
    /// Every odometry record, also those between scans, in order of time.
    pub odometry: Vec<Stamped>,
}

/// A reading, and what only the simulation knows of it.
pub(super) struct Observation {
    pub(super) reading: Reading,
    /// Where the robot truly was; `None` for logs.
    pub(super) world_from_robot: Option<Pose>,
    /// What each beam truly hit; empty for logs.
    pub(super) beam_solids: Vec<Option<u32>>,
}

/// What one turn of the world brought.
#[derive(Default)]
pub(super) struct Turn {
    pub(super) observation: Option<Observation>,
    /// Where the robot drove into something.
    pub(super) collision: Option<DVec2>,
}

/// Where the readings come from; cloning it is a checkpoint.
#[derive(Clone)]
#[allow(clippy::large_enum_variant, reason = "there is one a session")]
pub(super) enum Feed {
    Drive(Drive),
    Log { recording: Arc<Recording>, next: usize },
}

impl Feed {
    pub(super) fn drive(record: &SessionRecord) -> Result<Self, Vec<Problem>> {
        Drive::new(record).map(Self::Drive)
    }

    /// The same readings before the first.
    pub(super) fn rewound(&self, record: &SessionRecord) -> Result<Self, Vec<Problem>> {
        match self {
            Self::Drive(_) => Self::drive(record),
            Self::Log { recording, .. } => Ok(Self::Log { recording: Arc::clone(recording), next: 0 }),
        }
    }

    pub(super) fn advance(&mut self) -> Option<Turn> {
        match self {
            Self::Drive(drive) => Some(drive.advance()),
            Self::Log { recording, next } => {
                let reading = recording.readings.get(*next)?.clone();
                *next += 1;
                let observation = Observation { reading, world_from_robot: None, beam_solids: Vec::new() };
                Some(Turn { observation: Some(observation), collision: None })
            }
        }
    }

    pub(super) fn position(&self) -> u64 {
        match self {
            Self::Drive(drive) => drive.tick(),
            Self::Log { next, .. } => *next as u64,
        }
    }

    #[allow(clippy::cast_precision_loss, reason = "no run lasts 2^53 ticks")]
    pub(super) fn time(&self) -> f64 {
        match self {
            Self::Drive(drive) => drive.time(),
            Self::Log { recording, next } => {
                let since = |reading: &Reading| reading.t - recording.readings[0].t;
                next.checked_sub(1).and_then(|last| recording.readings.get(last)).map_or(0.0, since)
            }
        }
    }

    pub(super) fn last_scan(&self) -> Option<&Scan> {
        match self {
            Self::Drive(drive) => drive.last_scan(),
            Self::Log { recording, next } => {
                recording.readings.get(next.checked_sub(1)?).map(|reading| &reading.scan)
            }
        }
    }

    /// Turns between two checkpoints, to begin with.
    pub(super) fn interval(&self) -> u64 {
        match self {
            Self::Drive(_) => 250,
            Self::Log { .. } => 50,
        }
    }
}
