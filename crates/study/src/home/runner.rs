use std::collections::BTreeMap;
use std::sync::Mutex;
use std::time::Duration;

use cogmap_simulation::{Episode, Session, Setting};
use rayon::prelude::*;
use serde::Serialize;

use super::{
    plan::{Plan, Task},
    row::HomeRow,
    trial::{way_home, way_out},
};

/// How long decisions took on this machine, by strategy: not part of what a plan brings to light.
pub type DecisionTimes = BTreeMap<String, Thinking>;

/// How long a strategy thinks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Thinking {
    /// How many decisions.
    pub decisions: u64,
    /// Milliseconds in the mean.
    pub mean_ms: f64,
    /// Milliseconds at worst.
    pub worst_ms: f64,
}

impl Thinking {
    fn take_in(&mut self, time: Duration) {
        let ms = time.as_secs_f64() * 1e3;
        self.decisions += 1;
        self.mean_ms += (ms - self.mean_ms) / self.decisions as f64;
        self.worst_ms = self.worst_ms.max(ms);
    }
}

/// Performs tasks on so many cores (0: all), and hands over the rows of each as soon as it is done.
///
/// # Errors
/// The first task that cannot be performed, and why.
pub fn run(
    plan: &Plan,
    tasks: &[Task],
    jobs: usize,
    done: impl Fn(&[HomeRow]) + Sync,
) -> Result<(Vec<HomeRow>, DecisionTimes), String> {
    let times = Mutex::new(DecisionTimes::new());
    let pool =
        rayon::ThreadPoolBuilder::new().num_threads(jobs).build().map_err(|error| error.to_string())?;
    let rows: Result<Vec<Vec<HomeRow>>, String> = pool.install(|| {
        let performed = |task: &Task| {
            let rows = perform(plan, *task, &times)?;
            done(&rows);
            Ok(rows)
        };
        tasks.par_iter().with_max_len(1).map(performed).collect()
    });
    let times = times.into_inner().unwrap_or_default();
    Ok((rows?.into_iter().flatten().collect(), times))
}

/// One way out in every setting, and home by every strategy.
fn perform(plan: &Plan, task: Task, times: &Mutex<DecisionTimes>) -> Result<Vec<HomeRow>, String> {
    let place = plan.place(task.place);
    let name = |problem| format!("{place}, seed {}: {problem}", task.seed);
    let (world, route) = plan.ground(task).map_err(name)?;
    let robot = &plan.robots[task.robot];
    let with = (robot, &super::mapper());
    let mut furnished: Option<Option<Session>> = None;
    let mut rows = Vec::new();
    for &setting in &plan.settings {
        let Some(episode) = Episode::new(&world, &route, setting, task.seed) else { continue };
        let own;
        let out = if setting.begins_furnished() {
            furnished.get_or_insert_with(|| way_out(&episode, with, task.seed)).as_ref()
        } else {
            own = way_out(&episode, with, task.seed);
            own.as_ref()
        };
        for strategy in &plan.strategies {
            let home = out.and_then(|out| way_home(out, &episode.changes, strategy));
            let trial = home.map(|(trial, taken)| {
                if let Ok(mut times) = times.lock() {
                    let thinking = times.entry(strategy.name().to_owned()).or_default();
                    taken.into_iter().for_each(|time| thinking.take_in(time));
                }
                trial
            });
            let (place, robot, strategy) = (place.clone(), robot.name.clone(), strategy.name().to_owned());
            rows.push(HomeRow { place, setting, robot, seed: task.seed, strategy, trial });
        }
    }
    if rows.is_empty() {
        // So that a file shows that this was tried.
        let (robot, setting) = (robot.name.clone(), plan.settings.first().copied().unwrap_or(Setting::Empty));
        let strategy = String::new();
        rows.push(HomeRow { place, setting, robot, seed: task.seed, strategy, trial: None });
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use cogmap_simulation::{Robot, Strategy};

    use super::*;
    use crate::Seeds;

    #[test]
    fn every_strategy_goes_home_on_its_own_and_the_number_of_cores_does_not_matter() {
        let plan = |strategies: &[&str]| Plan {
            worlds: Vec::new(),
            robots: vec![Robot::named("perfect").unwrap()],
            settings: vec![Setting::Empty],
            strategies: strategies.iter().filter_map(|name| Strategy::named(name)).collect(),
            seeds: Seeds { first: 1, count: 2 },
        };
        let rows = |plan: &Plan, jobs| run(plan, &plan.tasks(), jobs, |_| {}).unwrap().0;
        let both = rows(&plan(&["retrace", "oracle"]), 1);
        assert_eq!(both.len(), 4);
        assert_eq!(both, rows(&plan(&["retrace", "oracle"]), 2));
        let alone = rows(&plan(&["oracle"]), 1);
        assert_eq!(alone, both.iter().filter(|row| row.strategy == "oracle").cloned().collect::<Vec<_>>());
        assert!(
            both.iter().all(|row| row.trial.as_ref().is_some_and(|trial| trial.succeeds(0.5))),
            "{both:?}"
        );
    }
}
