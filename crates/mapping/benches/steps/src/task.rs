use cogmap_formats::carmen;
use cogmap_mapping::{
    Mapper, MapperSetup,
    perception::{Extraction, Reading, extract},
};

use crate::gallery::Gallery;

/// What is timed, by number: first on the log, then with maps of [`SIZES`].
pub const TASKS: [&str; 9] = [
    "extraction",
    "perceptual",
    "consensus",
    "transform",
    "odometry",
    "consensus, 100 surfaces",
    "consensus, 1,000",
    "consensus, 10,000",
    "consensus, 100,000",
];
/// How many surfaces the maps hold, for the last tasks.
pub const SIZES: [usize; 4] = [100, 1_000, 10_000, 100_000];
/// The first of them.
const GROWTH: usize = TASKS.len() - SIZES.len();
/// Steps that are timed with a map of some size: enough for the robot to change its local frame often.
const STEPS: usize = 200;

/// Everything that a task needs, so that a run does nothing else.
pub struct Prepared {
    readings: Vec<Reading>,
    /// `None` where only surfaces are extracted.
    mapper: Option<Mapper>,
}

impl Prepared {
    /// The task of that number; `None` where there is no such task, or no log for it.
    #[must_use]
    pub fn new(task: usize, log: &[u8]) -> Option<Self> {
        match task.checked_sub(GROWTH) {
            Some(size) => Some(Self::grown(*SIZES.get(size)?)),
            None => {
                let readings = carmen::read(log, "log", false).ok()?.recording.readings;
                let mapper = MapperSetup::named(TASKS[task]).map(|setup| Mapper::new(&setup, 1));
                Some(Self { readings, mapper })
            }
        }
    }

    /// A robot that has walked until its map holds so many surfaces.
    fn grown(surfaces: usize) -> Self {
        let mut gallery = Gallery::new();
        let mut mapper = MapperSetup::named("consensus").map(|setup| Mapper::new(&setup, 1));
        while let Some(mapper) = mapper.as_mut().filter(|mapper| mapper.mfis().surfaces().len() < surfaces) {
            mapper.observe(&gallery.step());
        }
        Self { readings: (0..STEPS).map(|_| gallery.step()).collect(), mapper }
    }

    /// How many steps a run takes.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.readings.len()
    }

    /// What a run begins with; copying it is not timed.
    #[must_use]
    pub fn start(&self) -> Option<Mapper> {
        self.mapper.clone()
    }

    /// Takes every step once, from a copy of the start; where that led, to compare platforms bit for bit.
    #[must_use]
    pub fn run(&self, start: Option<Mapper>) -> f64 {
        let Some(mut mapper) = start else {
            let views = self.readings.iter().map(|reading| extract(&reading.scan, &Extraction::default()));
            return views.map(|view| view.surfaces.iter().map(|s| s.length()).sum::<f64>()).sum();
        };
        for reading in &self.readings {
            mapper.observe(reading);
        }
        mapper.mfis().surfaces().iter().rev().take(1000).map(|s| s.segment.a.x + s.segment.b.y).sum()
    }
}
