use cogmap_geometry::Pose;
use cogmap_mapping::{
    Mapper, MapperSetup, StepReport,
    perception::{Extraction, Moment, Reading, Scan, View, extract},
};
use cogmap_simulation::{Robot, SessionRecord, Source, Start, World};

use super::runs::{self, Building};

/// A small world made for a figure, in which a robot without errors is put where it is wanted.
pub(super) struct Stage {
    pub(super) world: World,
}

impl Stage {
    /// A world from the content of a world file.
    pub(super) fn new(text: &'static str) -> Result<Self, String> {
        Ok(Self { world: Building::Made(text).world()? })
    }

    /// What the laser sees from there.
    pub(super) fn scan(&self, world_from_robot: Pose) -> Result<Scan, String> {
        let position = world_from_robot.position.into();
        let start = Start { position, heading_deg: world_from_robot.heading.to_degrees() };
        let robot = Robot::named("perfect").ok_or("there is no perfect robot")?;
        let source = Source::world(World { start, ..self.world.clone() }, robot);
        let session = runs::begin(SessionRecord::new(source, Vec::new(), 1))?;
        session.last_scan().cloned().ok_or_else(|| "the robot did not look".to_owned())
    }

    /// The surfaces that the robot sees from there, in its own frame.
    pub(super) fn view(&self, world_from_robot: Pose) -> Result<View, String> {
        Ok(extract(&self.scan(world_from_robot)?, &Extraction::default()))
    }

    /// What a mapper makes of views from those places when its wheels tell it the others.
    pub(super) fn map(
        &self,
        setup: &MapperSetup,
        places: &[Pose],
        told: &[Pose],
    ) -> Result<(Mapper, Vec<StepReport>), String> {
        let mut mapper = Mapper::new(setup, 1);
        let mut reports = Vec::new();
        for (place, &odom_from_robot) in places.iter().zip(told) {
            let (t, moment) = (reports.len() as f64, Moment::StepEnd);
            let reading = Reading { t, odom_from_robot, moment, scan: self.scan(*place)? };
            reports.extend(mapper.observe(&reading));
        }
        Ok((mapper, reports))
    }
}
