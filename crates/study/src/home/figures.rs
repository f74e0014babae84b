use std::collections::BTreeMap;

use cogmap_mapping::MapperSetup;
use cogmap_navigation::StrategySetup;
use cogmap_simulation::{Robot, Setting, Strategy};
use serde::Serialize;

use super::{
    plan::Plan,
    row::{Ended, HomeRow, Trial},
};
use crate::{
    Bound, Check, Seeds,
    metrics::{Estimate, Rate, estimate, median},
    outcome::share_of,
};

/// Everything that a plan brought to light.
#[derive(Serialize)]
pub struct HomeSummary {
    format: &'static str,
    study: &'static str,
    about: &'static str,
    version: &'static str,
    seeds: Seeds,
    /// By place, setting, robot and strategy.
    pub groups: Vec<HomeFigures>,
    /// Strategies against each other on the same episodes.
    pub pairs: Vec<SplPair>,
    /// What the bar says of `recommended` with the bad robot.
    pub checks: Vec<Check>,
    robots: BTreeMap<String, Robot>,
    mappers: BTreeMap<&'static str, MapperSetup>,
    strategies: BTreeMap<&'static str, StrategySetup>,
}

/// The ways home of one strategy with one robot in one setting. Rates have Wilson's interval, means and
/// medians a bootstrap interval, each of 95 %.
#[derive(Clone, Serialize)]
pub struct HomeFigures {
    /// `generated`, or `worlds` for all others together.
    pub place: &'static str,
    /// What happened to the building.
    pub setting: &'static str,
    /// The robot's name.
    pub robot: String,
    /// The strategy's name.
    pub strategy: String,
    /// Ways home.
    pub episodes: usize,
    /// Ways out that could not be driven, so that no way home was tried.
    pub undriven: usize,
    /// Own stops without a collision within 0.5, 1.0 and 1.5 m of the true start.
    pub success: [Option<Estimate>; 3],
    /// Own stops anywhere.
    pub own_stop: Option<Estimate>,
    /// Ways home on which the robot gave up by itself and hit nothing: right where no way leads home.
    pub gave_up: Option<Estimate>,
    /// Ways home on which the robot drove into something; with none, `high` is what the runs prove.
    pub collided: Option<Estimate>,
    /// Mean of success weighted by path length.
    pub spl: Option<Estimate>,
    /// Mean of the way driven, with what is missing to the start, over the shortest way, of successes.
    pub path_ratio: Option<Estimate>,
    /// Mean of the way driven over the way out, of successes: below 1 is shorter than retracing.
    pub path_over_out: Option<Estimate>,
    /// Mean number of decisions that the fail-safe led.
    pub failsafe_steps: Option<Estimate>,
    /// Mean number of dead ends entered again.
    pub reentries: Option<Estimate>,
    /// Mean of radians turned for each metre.
    pub turning: Option<Estimate>,
    /// Mean number of zigzags for each 10 m.
    pub zigzag: Option<Estimate>,
    /// Median and 95th percentile of the distance between home as believed and home, metres.
    pub home_offset: Option<[f64; 2]>,
    /// Shortcuts taken where the shortest way is at most 0.7 of the way out.
    pub shortcuts: Option<Estimate>,
}

/// How much more SPL one strategy has than another on the same episodes.
#[derive(Clone, Serialize)]
pub struct SplPair {
    /// As in [`HomeFigures`].
    pub place: &'static str,
    /// What happened to the building.
    pub setting: &'static str,
    /// The robot's name.
    pub robot: String,
    /// The strategy that is compared …
    pub strategy: String,
    /// … and the one that it is compared with.
    pub with: String,
    /// Mean of the differences, with its bootstrap 95 % interval.
    pub more: Option<Estimate>,
}

/// Place, setting and robot of rows that are comparable, and within them the strategy's rows.
type Groups<'a> = BTreeMap<(&'static str, Setting, &'a str), BTreeMap<&'a str, Vec<&'a HomeRow>>>;

impl HomeSummary {
    /// Sums up rows.
    #[must_use]
    pub fn of(plan: &Plan, rows: &[HomeRow]) -> Self {
        let groups = groups(rows);
        let figures: Vec<HomeFigures> = groups
            .iter()
            .flat_map(|(key, strategies)| {
                strategies.iter().map(|(strategy, rows)| HomeFigures::of(*key, strategy, rows))
            })
            .collect();
        Self {
            format: "cogmap-home-study/1",
            study: super::NAME,
            about: super::ABOUT,
            version: env!("CARGO_PKG_VERSION"),
            seeds: plan.seeds,
            pairs: groups.iter().flat_map(|(key, strategies)| pairs(*key, strategies)).collect(),
            checks: checks(&groups),
            groups: figures,
            robots: plan.robots.iter().map(|robot| (robot.name.clone(), robot.clone())).collect(),
            mappers: BTreeMap::from([super::mapper()].map(|mapper| (mapper.name(), mapper))),
            strategies: plan.strategies.iter().filter_map(with_name).collect(),
        }
    }
}

fn with_name(strategy: &Strategy) -> Option<(&'static str, StrategySetup)> {
    Some((strategy.name(), strategy.setup()?.clone()))
}

fn groups(rows: &[HomeRow]) -> Groups<'_> {
    let mut groups = Groups::new();
    for row in rows.iter().filter(|row| !row.strategy.is_empty()) {
        let place = if row.place == "generated" { "generated" } else { "worlds" };
        let group = groups.entry((place, row.setting, &row.robot)).or_default();
        group.entry(&row.strategy).or_default().push(row);
    }
    groups
}

impl HomeFigures {
    fn of((place, setting, robot): (&'static str, Setting, &str), strategy: &str, rows: &[&HomeRow]) -> Self {
        let trials: Vec<&Trial> = rows.iter().filter_map(|row| row.trial.as_ref()).collect();
        let rate = |is_so: &dyn Fn(&Trial) -> Option<bool>| {
            let mut rate = Rate::default();
            trials.iter().filter_map(|trial| is_so(trial)).for_each(|hit| rate.count(hit));
            share_of(rate)
        };
        let mean = |value: &dyn Fn(&Trial) -> Option<f64>| {
            mean(&trials.iter().filter_map(|trial| value(trial)).collect::<Vec<f64>>())
        };
        let of_success = |trial: &Trial, value: f64| trial.succeeds(1.0).then_some(value);
        Self {
            place,
            setting: setting.name(),
            robot: robot.to_owned(),
            strategy: strategy.to_owned(),
            episodes: trials.len(),
            undriven: rows.len() - trials.len(),
            success: [0.5, 1.0, 1.5].map(|within| rate(&|trial| Some(trial.succeeds(within)))),
            own_stop: rate(&|trial| Some(trial.ended == Ended::Home)),
            gave_up: rate(&|trial| Some(trial.ended == Ended::Stuck && trial.collisions == 0.0)),
            collided: rate(&|trial| Some(trial.collisions > 0.0)),
            spl: mean(&Trial::spl),
            path_ratio: mean(&|trial| of_success(trial, trial.length() / trial.shortest?.max(0.1))),
            path_over_out: mean(&|trial| of_success(trial, trial.path / trial.out)),
            failsafe_steps: mean(&|trial| Some(trial.failsafe_steps)),
            reentries: mean(&|trial| Some(trial.reentries)),
            turning: mean(&|trial| Some(trial.turning)),
            zigzag: mean(&|trial| Some(trial.zigzag)),
            home_offset: offsets(&trials),
            shortcuts: rate(&|trial: &Trial| trial.takes_shortcut(1.0)),
        }
    }
}

fn offsets(trials: &[&Trial]) -> Option<[f64; 2]> {
    let mut offsets: Vec<f64> = trials.iter().filter_map(|trial| trial.home_offset).collect();
    offsets.sort_by(f64::total_cmp);
    Some([median(&offsets)?, *offsets.get((offsets.len() * 95).div_ceil(100).checked_sub(1)?)?])
}

/// The mean with its bootstrap interval.
fn mean(values: &[f64]) -> Option<Estimate> {
    estimate(values.len(), |drawn| {
        Some(drawn.iter().map(|&index| values[index]).sum::<f64>() / drawn.len() as f64)
    })
}

/// Each strategy against each other that comes before it by name.
fn pairs(
    (place, setting, robot): (&'static str, Setting, &str),
    strategies: &BTreeMap<&str, Vec<&HomeRow>>,
) -> Vec<SplPair> {
    let spl = |row: &HomeRow| row.trial.as_ref().and_then(Trial::spl);
    let key = |row: &&&HomeRow| (row.place.clone(), row.seed);
    let mut pairs = Vec::new();
    for (strategy, rows) in strategies {
        for (with, others) in strategies.range(..*strategy) {
            let others: BTreeMap<_, f64> =
                others.iter().filter_map(|row| Some((key(&row), spl(row)?))).collect();
            let more = |row: &&HomeRow| Some(spl(row)? - others.get(&key(&row))?);
            pairs.push(SplPair {
                place,
                setting: setting.name(),
                robot: robot.to_owned(),
                strategy: (*strategy).to_owned(),
                with: (*with).to_owned(),
                more: mean(&rows.iter().filter_map(more).collect::<Vec<f64>>()),
            });
        }
    }
    pairs
}

/// The least success within 1 m, and the least mean SPL, of `recommended` with the bad robot.
const BAR: [(Setting, f64, f64); 6] = [
    (Setting::Empty, 0.97, 0.90),
    (Setting::Furnished, 0.97, 0.90),
    (Setting::BoxesDropped, 0.95, 0.87),
    (Setting::BoxesMoved, 0.95, 0.87),
    (Setting::Narrow, 0.95, 0.90),
    (Setting::DoorClosed, 0.93, 0.75),
];

fn checks(groups: &Groups<'_>) -> Vec<Check> {
    let mut checks = Vec::new();
    for (setting, success, spl) in BAR {
        let rows = groups.get(&("generated", setting, "bad")).and_then(|group| group.get("recommended"));
        let Some(rows) = rows else { continue };
        let figures = HomeFigures::of(("generated", setting, "bad"), "recommended", rows);
        let name = setting.name();
        checks.push(Check::share(
            format!("{name}: success within 1 m in at least {:.0} %", success * 100.0),
            figures.success[1],
            Bound::AtLeast(success),
        ));
        checks.push(Check::figure(
            format!("{name}: mean SPL at least {spl}"),
            figures.spl,
            Bound::AtLeast(spl),
        ));
        checks.push(Check::share(
            format!("{name}: the robot stops by itself in at least 99 %"),
            figures.own_stop,
            Bound::AtLeast(0.99),
        ));
        if let Some(shortcuts) = figures.shortcuts {
            checks.push(Check::share(
                format!("{name}: takes the shortcut in at least 95 %"),
                Some(shortcuts),
                Bound::AtLeast(0.95),
            ));
        }
    }
    checks
}

#[cfg(test)]
mod tests {
    use super::super::row::tests::row;
    use super::*;

    #[test]
    fn strategies_are_compared_on_the_episodes_that_they_share() {
        let rows: Vec<HomeRow> = (0..10)
            .flat_map(|seed| [row(seed, "recommended", 10.0), row(seed + 1, "retrace", 20.0)])
            .collect();
        let groups = groups(&rows);
        let group = groups.values().next().unwrap();
        let found = pairs(("generated", Setting::Furnished, "bad"), group);
        assert_eq!(
            (found.len(), found[0].strategy.as_str(), found[0].with.as_str()),
            (1, "retrace", "recommended")
        );
        let more = found[0].more.unwrap();
        assert!((more.value + 0.5).abs() < 1e-12 && more.runs == 9);
    }

    #[test]
    fn figures_tell_of_collisions_what_the_runs_prove() {
        let rows: Vec<HomeRow> = (0..300).map(|seed| row(seed, "recommended", 12.5)).collect();
        let rows: Vec<&HomeRow> = rows.iter().collect();
        let figures = HomeFigures::of(("generated", Setting::Furnished, "bad"), "recommended", &rows);
        let collided = figures.collided.unwrap();
        assert!(collided.value == 0.0 && (collided.interval.high - 0.0126).abs() < 1e-3);
        assert_eq!((figures.episodes, figures.undriven, figures.home_offset), (300, 0, None));
        assert!((figures.spl.unwrap().value - 0.8).abs() < 1e-9);
        assert_eq!(figures.shortcuts.unwrap().value, 1.0);
    }
}
