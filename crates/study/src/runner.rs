//! Runs conditions on many seeds and all cores; native only.

use std::ops::Range;

use cogmap_simulation::{Robot, SessionRecord, Source};
use rayon::prelude::*;

use crate::{
    Condition, Drive, Ground, Log, Mapping, Outing, Row, Seeds, Treatment, Variant, drive, home,
    score::{Truth, Values, score, score_log, score_way_home},
};

/// Runs every condition with every seed on so many cores (0: all) and calls `progress` after each
/// drive. The rows come in the same order and with the same values whatever the number of cores.
///
/// # Errors
/// The first drive that cannot be driven, and why.
pub fn run(
    conditions: &[Condition],
    seeds: Seeds,
    jobs: usize,
    progress: impl Fn() + Sync,
) -> Result<Vec<Row>, String> {
    let drives = drives(conditions, seeds);
    let truths: Vec<Option<Truth>> = conditions.iter().map(truth_of).collect();
    let pool =
        rayon::ThreadPoolBuilder::new().num_threads(jobs).build().map_err(|error| error.to_string())?;
    let rows: Result<Vec<Vec<Row>>, String> = pool.install(|| {
        let rows_of = |(group, seed): (Range<usize>, u64)| {
            let rows = perform(conditions, (group, seed), &truths);
            progress();
            rows
        };
        // One by one: in longer stretches a core that has done its own waits for the last one.
        drives.into_par_iter().with_max_len(1).map(rows_of).collect()
    });
    let mut rows: Vec<Row> = rows?.into_iter().flatten().collect();
    rows.sort_by_key(|row| (row.condition, row.seed, row.mapper));
    Ok(rows)
}

/// The drives that [`run`] makes: for each the conditions that see it, and its seed.
#[must_use]
pub fn drives(conditions: &[Condition], seeds: Seeds) -> Vec<(Range<usize>, u64)> {
    let with_seeds = |group: Range<usize>| {
        let count = seeds.count * conditions[group.start].times;
        (seeds.first..seeds.first + count).map(move |seed| (group.clone(), seed))
    };
    sharing(conditions).into_iter().flat_map(with_seeds).collect()
}

/// Neighbouring conditions that see the same drives.
fn sharing(conditions: &[Condition]) -> Vec<Range<usize>> {
    let mut groups: Vec<Range<usize>> = Vec::new();
    for (index, condition) in conditions.iter().enumerate() {
        match groups.last_mut() {
            Some(group) if conditions[group.start].shares_drives_with(condition) => group.end = index + 1,
            _ => groups.push(index..index + 1),
        }
    }
    groups
}

fn truth_of(condition: &Condition) -> Option<Truth> {
    match &condition.ground {
        Ground::Drive { course, robot } => Some(Truth::of(&course.world, robot.body.radius)),
        Ground::Log(_) | Ground::WayHome { .. } => None,
    }
}

/// One drive, or one playing of a log, and what the mappers of all its conditions make of it.
fn perform(
    conditions: &[Condition],
    (group, seed): (Range<usize>, u64),
    truths: &[Option<Truth>],
) -> Result<Vec<Row>, String> {
    let mut rows = Vec::new();
    let first = &conditions[group.start];
    let name = |problem: String| format!("{}, seed {seed}: {problem}", first.title());
    let driven = match &first.ground {
        Ground::Drive { course, robot } => Some(drive(course, robot, seed).map_err(name)?),
        Ground::Log(_) | Ground::WayHome { .. } => None,
    };
    for condition in group {
        let of = &conditions[condition];
        let scores = match (&of.ground, &driven, &truths[condition]) {
            (Ground::Log(log), ..) => of_log(of, log, seed),
            (Ground::WayHome { outing, robot }, ..) => {
                of_way_home(of, (outing, robot), seed).map_err(name)?
            }
            (_, Some(driven), Some(truth)) => of_drive(of, driven, (truth, seed)),
            _ => Vec::new(),
        };
        let row = |(mapper, values)| Row { condition, mapper, seed, values };
        rows.extend(scores.into_iter().enumerate().map(row));
    }
    Ok(rows)
}

fn of_drive(condition: &Condition, driven: &Drive, (truth, seed): (&Truth, u64)) -> Vec<Values> {
    let seen = driven.treated(condition.treatment);
    let mapped = |variant: &Variant| {
        let mapping = Mapping::of(seen.readings(), &variant.setup, seed);
        score(&seen, &mapping, truth)
    };
    condition.mappers.iter().map(mapped).collect()
}

fn of_log(condition: &Condition, log: &Log, seed: u64) -> Vec<Values> {
    let Treatment { odometry: odometry_noise, every } = condition.treatment;
    let source = Source::Log { path: log.name.clone(), sha256: String::new(), every, odometry_noise };
    let recording = log.recording.clone().varied(&SessionRecord::new(source, Vec::new(), seed));
    let mapped = |variant: &Variant| {
        let mapping = Mapping::of(recording.readings.iter(), &variant.setup, seed);
        score_log(&recording, &mapping, &log.relations)
    };
    condition.mappers.iter().map(mapped).collect()
}

fn of_way_home(
    condition: &Condition,
    (outing, robot): (&Outing, &Robot),
    seed: u64,
) -> Result<Vec<Values>, String> {
    let episode = home::episode(outing, seed)?;
    let gone = |variant: &Variant| {
        let strategy = variant.strategy.as_ref();
        let trial =
            strategy.and_then(|strategy| home::trial(&episode, (robot, &variant.setup), strategy, seed));
        score_way_home(trial.as_ref())
    };
    Ok(condition.mappers.iter().map(gone).collect())
}
