//! The thesis's experiments, and those that its claims ask for: a file each.

pub(crate) mod cadence;
pub(crate) mod independence;
pub(crate) mod loop_a;
pub(crate) mod loop_b;
pub(crate) mod placement;
pub(crate) mod small;

use cogmap_mapping::{
    MapperSetup,
    memory::{ConsensusParams, PerceptualParams},
    traditional::{OdometryParams, TransformParams},
};
use cogmap_simulation::Robot;

use crate::{Condition, Course, Request, Variant, condition::Treatment, worlds::world};

/// The name of the wheels alone.
pub(crate) const ODOMETRY: &str = "odometry";
/// The name of the traditional mapper.
pub(crate) const TRANSFORM: &str = "transform";
/// The name of the thesis's form.
pub(crate) const PERCEPTUAL: &str = "perceptual";
/// The name of our form.
pub(crate) const CONSENSUS: &str = "consensus";
/// The name of our form when it does not recognise places: what is said of a map's shape is said
/// of it, because a recognised place closes the gap by a jump.
pub(crate) const NO_RECOGNITION: &str = "consensus-no-recognition";

/// The wheels alone.
pub(crate) fn odometry() -> Variant {
    Variant::new(ODOMETRY, MapperSetup::Odometry(OdometryParams::default()))
}

/// The traditional mapper.
pub(crate) fn transform() -> Variant {
    Variant::new(TRANSFORM, MapperSetup::Transform(TransformParams::default()))
}

/// The thesis's form.
pub(crate) fn perceptual() -> Variant {
    Variant::new(PERCEPTUAL, MapperSetup::Perceptual(PerceptualParams::default()))
}

/// Our form.
pub(crate) fn consensus() -> Variant {
    Variant::new(CONSENSUS, MapperSetup::Consensus(Box::default()))
}

/// Our form without the recognition of places.
pub(crate) fn no_recognition() -> Variant {
    let mut params = ConsensusParams::default();
    params.recognition.on = false;
    Variant::new(NO_RECOGNITION, MapperSetup::Consensus(Box::new(params)))
}

/// Both robots of the thesis, or others by name.
pub(crate) fn robots(names: &[&str]) -> Vec<Robot> {
    names.iter().filter_map(|name| Robot::named(name)).collect()
}

/// The courses: the user's worlds, or the study's own.
pub(crate) fn courses(request: &Request, own: &str, route: &str) -> Result<Vec<Course>, String> {
    if request.worlds.is_empty() {
        return Ok(vec![Course::through(&world(own)?, route)?]);
    }
    request.worlds.iter().map(|world| Course::through(world, route)).collect()
}

/// A condition for each course and each robot.
pub(crate) fn grid(courses: &[Course], robots: &[Robot], mappers: &[Variant]) -> Vec<Condition> {
    let pairs = courses.iter().flat_map(|course| robots.iter().map(move |robot| (course, robot)));
    pairs
        .map(|(course, robot)| Condition {
            course: course.clone(),
            robot: robot.clone(),
            treatment: Treatment::default(),
            level: None,
            mappers: mappers.to_vec(),
        })
        .collect()
}

/// A condition for each level, on the same drives.
pub(crate) fn levels(
    base: &Condition,
    levels: &[f64],
    treatment: impl Fn(f64) -> Treatment,
) -> Vec<Condition> {
    let at = |&level: &f64| Condition { level: Some(level), treatment: treatment(level), ..base.clone() };
    levels.iter().map(at).collect()
}
