//! What a run was worth: every measure of one mapper.

mod kidnap;
mod log;
mod odometry;
mod places;
mod surfaces;
mod way;
#[cfg(not(target_arch = "wasm32"))]
mod way_home;

use std::collections::BTreeMap;

use cogmap_geometry::DVec2;
use cogmap_simulation::{Room, Solids, World};

pub use log::score_log;
pub(crate) use way::STRETCHES;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use way_home::score_way_home;

use crate::{
    Drive, Mapping, Measure,
    metrics::{LONG, Walls},
};

/// The measures of one mapper in one run, by name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values(BTreeMap<&'static str, f64>);

/// What is known of a building and the robot never sees.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Its straight walls.
    pub walls: Walls,
    /// The outlines of its rooms, metres.
    pub rooms: Vec<Vec<DVec2>>,
    /// Radius of the robot's footprint, metres.
    pub radius: f64,
}

impl Values {
    /// The value of that name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.get(name).copied()
    }

    /// Writes a value down; a name that is no [`Measure`]'s is left out.
    pub(crate) fn put(&mut self, name: &str, value: impl Into<Option<f64>>) {
        debug_assert!(Measure::named(name).is_some(), "{name} is no measure");
        if let (Some(measure), Some(value)) = (Measure::named(name), value.into()) {
            self.0.insert(measure.name, value);
        }
    }
}

impl Truth {
    /// The truth about a building.
    #[must_use]
    pub fn of(world: &World, radius: f64) -> Self {
        let Solids { segments, discs, .. } = Solids::of(world);
        let posts: Vec<_> = discs.iter().map(|disc| disc.center).collect();
        let outline = |room: &Room| room.outline.iter().copied().map(DVec2::from).collect();
        let rooms = world.rooms.iter().map(outline).collect();
        Self { walls: Walls::of(&segments, &posts), rooms, radius }
    }
}

/// Every measure of what a mapper made of a drive.
#[must_use]
pub fn score(drive: &Drive, mapping: &Mapping, truth: &Truth) -> Values {
    let mut values = Values::default();
    let samples = mapping.samples(drive);
    values.put("arrived", f64::from(u8::from(drive.arrived)));
    way::score(&samples, &mut values);
    let surfaces = mapping.surfaces(drive, &truth.walls);
    surfaces::score(&surfaces, (truth, &samples), &mut values);
    surfaces::score_room(&surfaces, (truth, &samples), &mut values);
    surfaces::score_way(drive, mapping, truth, &mut values);
    odometry::score(mapping, &mut values);
    odometry::score_way(drive, mapping, &mut values);
    kidnap::score(drive, mapping, &mut values);
    places::score((drive, mapping), truth, &mut values);
    values
}

/// A count as a measure.
#[allow(clippy::cast_precision_loss, reason = "nobody counts to 2^53")]
fn count(number: usize) -> f64 {
    number as f64
}
