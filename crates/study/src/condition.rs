use std::sync::Arc;

use cogmap_formats::relations::Relation;
use cogmap_geometry::DVec2;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Recording, Robot, Strategy, World};

/// What is the same for all runs of a group: where, with what, how; only the seed differs.
#[derive(Clone)]
pub struct Condition {
    /// Where the readings come from.
    pub ground: Ground,
    /// What is done to them before the mappers see them.
    pub treatment: Treatment,
    /// The mappers, each fed the same readings.
    pub mappers: Vec<Variant>,
    /// It is run with so many times the study's seeds: rates near 1 need more runs.
    pub times: u64,
}

/// Where readings come from.
#[derive(Clone)]
#[allow(clippy::large_enum_variant, reason = "a study has a few")]
pub enum Ground {
    /// A robot is driven through a building.
    Drive {
        /// The way that is driven.
        course: Course,
        /// Who drives it.
        robot: Robot,
    },
    /// A real robot was driven, and the truth is only known from relations.
    Log(Arc<Log>),
    /// A robot is driven out with each mapper and told to go home by what that remembers.
    WayHome {
        /// The way out.
        outing: Outing,
        /// Who goes.
        robot: Robot,
    },
}

/// A way out that ends with the command to go home.
#[derive(Clone)]
pub enum Outing {
    /// Through a building, always the same.
    Course(Course),
    /// Through a furnished office floor made from each seed.
    Floors,
}

/// A recorded log and what people know of the truth.
#[derive(Clone, Debug)]
pub struct Log {
    /// Its name for people.
    pub name: String,
    /// What reached the robot's program.
    pub recording: Recording,
    /// Where the robot was at one moment seen from another, matched by hand.
    pub relations: Vec<Relation>,
}

/// What is done to a drive before the mappers see it, so that the same drive can be seen in several
/// ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Treatment {
    /// The error of each movement of a drive becomes so many times what it was; to a log, whose error
    /// nobody knows, noise of this factor is added.
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
    /// Whether the robot is moved unseen to another room on the way, and goes on from there.
    pub kidnap: bool,
}

/// A mapper under the name that the study reports it by.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// The name.
    pub label: String,
    /// The mapper with every parameter.
    pub setup: MapperSetup,
    /// Who finds the way home by it, where one is asked for.
    pub strategy: Option<Strategy>,
}

impl Condition {
    /// Drives of the condition are also drives of the other.
    #[must_use]
    pub fn shares_drives_with(&self, other: &Self) -> bool {
        let same_ground = match (&self.ground, &other.ground) {
            (Ground::Drive { course, robot }, Ground::Drive { course: other, robot: others }) => {
                Arc::ptr_eq(&course.world, &other.world)
                    && course.route_name == other.route_name
                    && course.kidnap == other.kidnap
                    && robot == others
            }
            (Ground::Log(log), Ground::Log(other)) => Arc::ptr_eq(log, other),
            _ => false,
        };
        same_ground && self.times == other.times
    }

    /// The building or the log.
    #[must_use]
    pub fn place(&self) -> &str {
        match &self.ground {
            Ground::Drive { course, .. } => &course.world.name,
            Ground::Log(log) => &log.name,
            Ground::WayHome { outing: Outing::Course(course), .. } => &course.world.name,
            Ground::WayHome { outing: Outing::Floors, .. } => "generated floors",
        }
    }

    /// Whether it is about going home, not about the map.
    #[must_use]
    pub fn goes_home(&self) -> bool {
        matches!(self.ground, Ground::WayHome { .. })
    }

    /// The route's name; none for a log or a generated floor.
    #[must_use]
    pub fn route(&self) -> &str {
        match &self.ground {
            Ground::Drive { course, .. } | Ground::WayHome { outing: Outing::Course(course), .. } => {
                &course.route_name
            }
            Ground::WayHome { outing: Outing::Floors, .. } | Ground::Log(_) => "",
        }
    }

    /// The robot's name; a log's is `real`.
    #[must_use]
    pub fn robot(&self) -> &str {
        match &self.ground {
            Ground::Drive { robot, .. } | Ground::WayHome { robot, .. } => &robot.name,
            Ground::Log(_) => "real",
        }
    }

    /// In one line, for people.
    #[must_use]
    pub fn title(&self) -> String {
        let mut title = match &self.ground {
            Ground::Drive { course, robot } => {
                format!("{}, {}, {} robot", course.world.name, course.route_name, robot.name)
            }
            Ground::Log(log) => log.name.clone(),
            Ground::WayHome { robot, .. } => format!("{}, and home, {} robot", self.place(), robot.name),
        };
        match (&self.ground, self.treatment.odometry) {
            (Ground::Log(_), noise) if noise > 0.0 => title += &format!(", odometry noise {noise}"),
            (Ground::Drive { .. }, factor) if factor != 1.0 => {
                title += &format!(", {factor} times its odometry errors");
            }
            _ => {}
        }
        if let Some(every) = self.treatment.every {
            title += &format!(", a view each {every} m or rad");
        }
        title
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
        Ok(Self { world: Arc::clone(world), route_name: name.clone(), route, kidnap: false })
    }
}

impl Variant {
    /// A mapper under a name.
    #[must_use]
    pub fn new(label: &str, setup: MapperSetup) -> Self {
        Self { label: label.to_owned(), setup, strategy: None }
    }

    /// The same, and who finds the way home by it.
    #[must_use]
    pub fn homing(self, strategy: Strategy) -> Self {
        Self { strategy: Some(strategy), ..self }
    }
}
