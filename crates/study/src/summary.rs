use std::collections::BTreeMap;

use cogmap_mapping::MapperSetup;
use cogmap_navigation::StrategySetup;
use cogmap_simulation::Robot;
use serde::Serialize;

use crate::{Check, Condition, Ground, MEASURES, Measure, Outcome, Study, Variant, metrics::Estimate};

/// Which seeds were run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Seeds {
    /// The first.
    pub first: u64,
    /// How many, one after the other.
    pub count: u64,
}

/// `summary.json`: everything that a study found out, and everything that it depends on.
#[derive(Serialize)]
pub struct Summary<'a> {
    format: &'static str,
    study: &'static str,
    about: &'static str,
    program: Program,
    seeds: Seeds,
    checks: &'a [Check],
    groups: Vec<GroupSummary<'a>>,
    measures: &'static [Measure],
    robots: BTreeMap<&'a str, &'a Robot>,
    mappers: BTreeMap<&'a str, &'a MapperSetup>,
    /// Who finds the way home by what the mapper of that name remembers.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    strategies: BTreeMap<&'a str, &'a StrategySetup>,
}

#[derive(Serialize)]
struct Program {
    name: &'static str,
    version: &'static str,
}

/// The figures of one mapper under one condition.
#[derive(Serialize)]
struct GroupSummary<'a> {
    world: &'a str,
    route: &'a str,
    robot: &'a str,
    odometry: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    every: Option<f64>,
    mapper: &'a str,
    figures: BTreeMap<&'static str, Estimate>,
}

impl<'a> Summary<'a> {
    /// Sums up a study.
    #[must_use]
    pub fn of(study: &Study, seeds: Seeds, outcome: &'a Outcome, checks: &'a [Check]) -> Self {
        let conditions = &outcome.conditions;
        let variants = || conditions.iter().flat_map(|condition| &condition.mappers);
        Self {
            format: "cogmap-study/1",
            study: study.name,
            about: study.about,
            program: Program { name: "cogmap", version: env!("CARGO_PKG_VERSION") },
            seeds,
            checks,
            groups: outcome.groups().map(|group| GroupSummary::of(&group)).collect(),
            measures: &MEASURES,
            robots: conditions.iter().filter_map(robot_of).collect(),
            mappers: variants().map(|variant| (variant.label.as_str(), &variant.setup)).collect(),
            strategies: variants().filter_map(strategy_of).collect(),
        }
    }
}

fn robot_of(condition: &Condition) -> Option<(&str, &Robot)> {
    match &condition.ground {
        Ground::Drive { robot, .. } | Ground::WayHome { robot, .. } => Some((&robot.name, robot)),
        Ground::Log(_) => None,
    }
}

fn strategy_of(variant: &Variant) -> Option<(&str, &StrategySetup)> {
    Some((&variant.label, variant.strategy.as_ref()?.setup()?))
}

impl<'a> GroupSummary<'a> {
    fn of(group: &crate::Group<'a>) -> Self {
        let condition = group.of();
        let figure = |measure: &'static Measure| Some((measure.name, group.figure(measure)?));
        Self {
            world: condition.place(),
            route: condition.route(),
            robot: condition.robot(),
            odometry: condition.treatment.odometry,
            every: condition.treatment.every,
            mapper: group.label(),
            figures: MEASURES.iter().filter_map(figure).collect(),
        }
    }
}
