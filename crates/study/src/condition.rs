use std::sync::Arc;

use cogmap_geometry::DVec2;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Robot, World};

/// What is the same for all runs of a group: where, with what, how; only the seed differs.
#[derive(Clone)]
pub struct Condition {
    /// The way that is driven.
    pub course: Course,
    /// Who drives it.
    pub robot: Robot,
    /// What is done to the drive before the mappers see it.
    pub treatment: Treatment,
    /// Where on the scale that the study varies; `None` where it varies nothing.
    pub level: Option<f64>,
    /// The mappers, each fed the same readings.
    pub mappers: Vec<Variant>,
}

/// What is done to a drive before the mappers see it, so that the same drive can be seen in several
/// ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Treatment {
    /// The error of each movement becomes so many times what it was.
    pub odometry: f64,
    /// A scan is kept each so many metres or radians; `None` keeps all.
    pub every: Option<f64>,
}

impl Default for Treatment {
    fn default() -> Self {
        Self { odometry: 1.0, every: None }
    }
}

/// A building and a way through it.
#[derive(Clone)]
pub struct Course {
    /// The building.
    pub world: Arc<World>,
    /// The route's name.
    pub route_name: String,
    /// Its points after the start, metres.
    pub route: Vec<DVec2>,
}

/// A mapper under the name that the study reports it by.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// The name.
    pub label: String,
    /// The mapper with every parameter.
    pub setup: MapperSetup,
}

impl Condition {
    /// Drives of the condition are also drives of the other.
    #[must_use]
    pub fn shares_drives_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.course.world, &other.course.world)
            && self.course.route_name == other.course.route_name
            && self.robot == other.robot
    }

    /// In one line, for people.
    #[must_use]
    pub fn title(&self) -> String {
        let Course { world, route_name, .. } = &self.course;
        let level = self.level.map(|level| format!(", {level}")).unwrap_or_default();
        format!("{}, {route_name}, {} robot{level}", world.name, self.robot.name)
    }
}

impl Course {
    /// The way of that name through a building; its first way where it has none of that name.
    ///
    /// # Errors
    /// The building has no way at all.
    pub fn through(world: &Arc<World>, route: &str) -> Result<Self, String> {
        let named = world.routes.get_key_value(route).or_else(|| world.routes.first_key_value());
        let (name, points) = named.ok_or_else(|| format!("\"{}\" has no route", world.name))?;
        let route = points.iter().copied().map(DVec2::from).collect();
        Ok(Self { world: Arc::clone(world), route_name: name.clone(), route })
    }
}

impl Variant {
    /// A mapper under a name.
    #[must_use]
    pub fn new(label: &str, setup: MapperSetup) -> Self {
        Self { label: label.to_owned(), setup }
    }
}
