use cogmap_formats::carmen;
use cogmap_mapping::{
    Mapper, MapperSetup,
    perception::{Extraction, Reading, extract},
};

use crate::gallery::Gallery;

/// Steps that are timed with a map of some size: enough for the robot to change its local frame and to go through
/// a door often.
const STEPS: usize = 400;

/// Readings, and the mapper that takes them in.
pub(crate) struct Run {
    readings: Vec<Reading>,
    /// `None` where only surfaces are extracted.
    start: Option<Mapper>,
    mapper: Option<Mapper>,
}

impl Run {
    /// A log through the mapper of that name; `None` where there is no such log or mapper.
    pub(crate) fn on_log(log: &[u8], mapper: Option<&str>) -> Option<Self> {
        let readings = carmen::read(log, "log", false).ok()?.recording.readings;
        let start = match mapper {
            Some(name) => Some(Mapper::new(&MapperSetup::named(name)?, 1)),
            None => None,
        };
        Some(Self { readings, start, mapper: None })
    }

    pub(crate) fn steps(&self) -> usize {
        self.readings.len()
    }

    pub(crate) fn rewind(&mut self) {
        self.mapper.clone_from(&self.start);
    }

    /// Takes every reading once; where that led, to compare platforms bit for bit.
    pub(crate) fn run(&mut self) -> f64 {
        let Some(mapper) = &mut self.mapper else {
            let views = self.readings.iter().map(|reading| extract(&reading.scan, &Extraction::default()));
            return views.map(|view| view.surfaces.iter().map(|s| s.length()).sum::<f64>()).sum();
        };
        for reading in &self.readings {
            mapper.observe(reading);
        }
        mapper.mfis().surfaces().iter().rev().take(1000).map(|s| s.segment.a.x + s.segment.b.y).sum()
    }
}

/// A robot that has walked so far along the gallery.
#[derive(Default)]
pub(crate) struct Walker {
    gallery: Gallery,
    mapper: Option<Mapper>,
}

impl Walker {
    /// Walks on until the map holds so many surfaces; the steps after that.
    pub(crate) fn walk(&mut self, surfaces: usize) -> Run {
        let Self { gallery, mapper } = self;
        if mapper.is_none() {
            *mapper = MapperSetup::named("consensus").map(|setup| Mapper::new(&setup, 1));
        }
        while let Some(mapper) = mapper.as_mut().filter(|mapper| mapper.mfis().surfaces().len() < surfaces) {
            mapper.observe(&gallery.step());
        }
        let mut ahead = gallery.clone();
        Run { readings: (0..STEPS).map(|_| ahead.step()).collect(), start: mapper.clone(), mapper: None }
    }
}
