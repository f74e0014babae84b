use cogmap_geometry::Pose;
use cogmap_mapping::{
    Mapper, MapperSetup, StepReport,
    perception::{Moment, Reading},
};
use cogmap_simulation::wall_of;

use crate::{
    Drive,
    metrics::{Mapped, Sample, Walls},
};

/// What one mapper made of a drive.
#[derive(Clone, Debug)]
pub struct Mapping {
    /// The mapper at the end.
    pub mapper: Mapper,
    /// What it did with each view.
    pub reports: Vec<StepReport>,
    /// For each of them the look that it was taken in.
    pub look_of_report: Vec<usize>,
    /// The robot in the map, one a look.
    pub estimate: Vec<Pose>,
}

impl Mapping {
    /// Feeds readings to a mapper; what is random in it comes from the seed.
    #[must_use]
    pub fn of<'a>(readings: impl Iterator<Item = &'a Reading>, setup: &MapperSetup, seed: u64) -> Self {
        let mapper = Mapper::new(setup, seed);
        let mut mapping =
            Self { mapper, reports: Vec::new(), look_of_report: Vec::new(), estimate: Vec::new() };
        for (index, reading) in readings.enumerate() {
            if let Some(report) = mapping.mapper.observe(reading) {
                mapping.reports.push(report);
                mapping.look_of_report.push(index);
            }
            let pose = mapping.mapper.map_from_robot(reading.odom_from_robot);
            mapping.estimate.push(pose.unwrap_or(Pose::IDENTITY));
        }
        mapping
    }

    /// Where the robot was and where the map has it, at the end of each step.
    #[must_use]
    pub fn samples(&self, drive: &Drive) -> Vec<Sample> {
        let ends = drive.looks.iter().zip(&self.estimate);
        ends.filter(|(look, _)| look.reading.moment == Moment::StepEnd)
            .map(|(look, &map_from_robot)| Sample { world_from_robot: look.world_from_robot, map_from_robot })
            .collect()
    }

    /// The surfaces of the map beside the truth, in the order of storing.
    #[must_use]
    pub fn surfaces(&self, drive: &Drive, walls: &Walls) -> Vec<Mapped> {
        let mfis = self.mapper.mfis();
        let beside_truth = |stored| {
            let &cogmap_mapping::memory::StoredSurface { step, index_in_view, .. } = stored;
            let seen = self.reports.get(step)?.view.surfaces.get(index_in_view)?;
            let look = drive.looks.get(*self.look_of_report.get(step)?)?;
            let solid = look.beam_solids.get(seen.beams[0]..=seen.beams[1]).and_then(wall_of);
            Some(Mapped {
                in_map: mfis.in_map(stored),
                in_world: look.world_from_robot * seen.segment,
                wall: solid.and_then(|solid| walls.of_solid(solid)),
            })
        };
        mfis.surfaces().iter().filter_map(beside_truth).collect()
    }
}
