//! The thesis's experiments, and those that its claims ask for: a file each.

pub(crate) mod ablation;
pub(crate) mod cadence;
pub(crate) mod calibration;
pub(crate) mod claims;
pub(crate) mod identity;
pub(crate) mod independence;
pub(crate) mod kidnap;
pub(crate) mod loop_a;
pub(crate) mod loop_b;
pub(crate) mod placement;
pub(crate) mod propagation;
pub(crate) mod relations;
pub(crate) mod results;
pub(crate) mod small;
pub(crate) mod tour;

use cogmap_mapping::{
    MapperSetup,
    memory::{ConsensusParams, MatchScope, PerceptualParams, ReferenceRule},
    traditional::{OdometryParams, TransformParams},
};
use cogmap_simulation::Robot;

use crate::{Condition, Course, Ground, Request, Treatment, Variant, world};

/// The name of the wheels alone.
pub(crate) const ODOMETRY: &str = "odometry";
/// The name of the traditional mapper.
pub(crate) const TRANSFORM: &str = "transform";
/// The name of the thesis's form.
pub(crate) const PERCEPTUAL: &str = "perceptual";
/// The name of the thesis's form before its remedy against bad references.
pub(crate) const CLOSEST_PAIR: &str = "perceptual-closest-pair";
/// The name of the thesis's form that compares a view with the whole map.
pub(crate) const WHOLE_MAP: &str = "perceptual-whole-map";
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

/// The thesis's form with the rule that it had before the failure of Fig. 3.17.
pub(crate) fn closest_pair() -> Variant {
    let mut params = PerceptualParams::default();
    params.reference.rule = ReferenceRule::ClosestPair;
    Variant::new(CLOSEST_PAIR, MapperSetup::Perceptual(params))
}

/// The thesis's form that also compares a view with what it remembers from earlier.
pub(crate) fn whole_map() -> Variant {
    let params = PerceptualParams { scope: MatchScope::PreviousViewThenMfis, ..PerceptualParams::default() };
    Variant::new(WHOLE_MAP, MapperSetup::Perceptual(params))
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
            ground: Ground::Drive { course: course.clone(), robot: robot.clone() },
            treatment: Treatment::default(),
            mappers: mappers.to_vec(),
            times: 1,
        })
        .collect()
}

/// A condition for each treatment, on the same drives.
pub(crate) fn treated(base: &Condition, treatments: &[Treatment]) -> Vec<Condition> {
    treatments.iter().map(|&treatment| Condition { treatment, ..base.clone() }).collect()
}
