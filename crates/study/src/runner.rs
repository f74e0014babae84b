//! Runs conditions on many seeds and all cores; native only.

use std::ops::Range;

use rayon::prelude::*;

use crate::{
    Condition, Mapping, Row,
    drive::drive,
    score::{Truth, score},
};

/// Runs every condition with every seed on so many cores (0: all) and calls `progress` after each
/// drive. The rows come in the same order and with the same values whatever the number of cores.
///
/// # Errors
/// The first drive that cannot be driven, and why.
pub fn run(
    conditions: &[Condition],
    seeds: Range<u64>,
    jobs: usize,
    progress: impl Fn() + Sync,
) -> Result<Vec<Row>, String> {
    let sharing = sharing(conditions);
    let drives: Vec<(Range<usize>, u64)> =
        sharing.iter().flat_map(|group| seeds.clone().map(|seed| (group.clone(), seed))).collect();
    let truths: Vec<Truth> =
        conditions.iter().map(|c| Truth::of(&c.course.world, c.robot.body.radius)).collect();
    let pool =
        rayon::ThreadPoolBuilder::new().num_threads(jobs).build().map_err(|error| error.to_string())?;
    let rows: Result<Vec<Vec<Row>>, String> = pool.install(|| {
        let rows_of = |(group, seed): (Range<usize>, u64)| {
            let rows = perform(conditions, (group, seed), &truths);
            progress();
            rows
        };
        drives.into_par_iter().map(rows_of).collect()
    });
    let mut rows: Vec<Row> = rows?.into_iter().flatten().collect();
    rows.sort_by_key(|row| (row.condition, row.seed, row.mapper));
    Ok(rows)
}

/// How many drives [`run`] makes of so many seeds.
#[must_use]
pub fn drives(conditions: &[Condition], seeds: &Range<u64>) -> u64 {
    sharing(conditions).len() as u64 * (seeds.end - seeds.start)
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

/// One drive, and what the mappers of all its conditions make of it.
fn perform(
    conditions: &[Condition],
    (group, seed): (Range<usize>, u64),
    truths: &[Truth],
) -> Result<Vec<Row>, String> {
    let first = &conditions[group.start];
    let name = |problem| format!("{}, seed {seed}: {problem}", first.title());
    let driven = drive(&first.course, &first.robot, seed).map_err(name)?;
    let mut rows = Vec::new();
    for condition in group {
        let of = &conditions[condition];
        let seen = driven.treated(of.treatment);
        for (mapper, variant) in of.mappers.iter().enumerate() {
            let mapping = Mapping::of(&seen, &variant.setup, seed);
            let values = score(&seen, &mapping, &truths[condition]);
            rows.push(Row { condition, mapper, seed, values });
        }
    }
    Ok(rows)
}
