use std::sync::Arc;

use cogmap_geometry::DVec2;
use cogmap_simulation::{Building, Robot, Setting, Strategy, World, random_route};

use crate::Seeds;

/// What is tried.
#[derive(Clone)]
pub struct Plan {
    /// Other worlds than generated buildings; none: a building from each seed.
    pub worlds: Vec<Arc<World>>,
    /// The robots.
    pub robots: Vec<Robot>,
    /// What happens to the buildings.
    pub settings: Vec<Setting>,
    /// Who finds the way.
    pub strategies: Vec<Strategy>,
    /// A way out for each, through each world.
    pub seeds: Seeds,
}

/// Where a way out leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Through the building of the seed.
    Generated,
    /// Through one of the plan's worlds.
    World(usize),
}

/// One way out in all settings, by one robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Task {
    /// Where.
    pub place: Place,
    /// Which of the plan's robots.
    pub robot: usize,
    /// What all chance comes from.
    pub seed: u64,
}

impl Plan {
    /// Every task, robot after robot within a seed.
    #[must_use]
    pub fn tasks(&self) -> Vec<Task> {
        let places: Vec<Place> = match self.worlds.len() {
            0 => vec![Place::Generated],
            count => (0..count).map(Place::World).collect(),
        };
        let seeds = self.seeds.first..self.seeds.first + self.seeds.count;
        let tasks = seeds.flat_map(|seed| places.iter().map(move |&place| (seed, place)));
        let robots = 0..self.robots.len();
        tasks.flat_map(|(seed, place)| robots.clone().map(move |robot| Task { place, robot, seed })).collect()
    }

    /// How a place is called in the rows.
    #[must_use]
    pub fn place(&self, place: Place) -> String {
        match place {
            Place::Generated => "generated".to_owned(),
            Place::World(index) => self.worlds[index].name.replace([',', '"', '\n'], " "),
        }
    }

    /// The building of a task and a way out through it.
    pub(super) fn ground(&self, task: Task) -> Result<(World, Vec<DVec2>), String> {
        match task.place {
            Place::Generated => floor(task.seed),
            Place::World(index) => {
                let world = World::clone(&self.worlds[index]);
                let route = random_route(&world, &self.robots[task.robot], task.seed)?;
                Ok((world, route))
            }
        }
    }

    /// Everything that the rows of a plan depend on, besides the seeds: rows of another plan do not
    /// belong with them.
    #[must_use]
    pub fn signature(&self) -> String {
        let list = |names: Vec<String>| names.join(" ");
        format!(
            "cogmap {} / {} / {} / {} / {}",
            env!("CARGO_PKG_VERSION"),
            list(self.worlds.iter().map(|world| world.name.clone()).collect()),
            list(self.robots.iter().map(|robot| robot.name.clone()).collect()),
            list(self.settings.iter().map(|setting| setting.name().to_owned()).collect()),
            list(self.strategies.iter().map(|strategy| strategy.name().to_owned()).collect()),
        )
    }
}

/// The office floor of a seed and a way out through it.
pub(super) fn floor(seed: u64) -> Result<(World, Vec<DVec2>), String> {
    let world = Building::generate(seed);
    let route = world.routes.values().next().ok_or("nothing leads 10 m away from the start")?;
    let route = route.iter().map(|&point| point.into()).collect();
    Ok((world, route))
}

#[cfg(test)]
mod tests {
    use super::super::HomeSummary;
    use super::*;

    #[test]
    fn the_summary_tells_every_parameter_of_whom_a_plan_tries() {
        let named = |name| Strategy::named(name).unwrap();
        let plan = Plan {
            worlds: Vec::new(),
            robots: vec![Robot::named("bad").unwrap()],
            settings: vec![Setting::Furnished],
            strategies: vec![named("recommended"), named("oracle")],
            seeds: Seeds { first: 1, count: 1 },
        };
        let summary = serde_json::to_value(HomeSummary::of(&plan, &[])).unwrap();
        for (of, number) in [
            ("robots", "/bad/laser/mixed_pixels"),
            ("mappers", "/consensus/search/enough"),
            ("strategies", "/recommended/rescue/patience"),
        ] {
            assert!(summary[of].pointer(number).is_some_and(serde_json::Value::is_number), "{}", summary[of]);
        }
        assert_eq!(summary["strategies"].as_object().unwrap().len(), 1, "the oracle has no parameters");
    }
}
