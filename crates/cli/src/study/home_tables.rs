use cogmap_study::home::{DecisionTimes, HomeFigures, HomeSummary, Plan};
use cogmap_study::metrics::Estimate;

use super::tables::{verdicts, written};
use crate::table::Table;

const HEADS: [&str; 12] = [
    "strategy", "runs", "≤ 1 m", "≤ 0.5", "≤ 1.5", "own stop", "gave up", "SPL", "path ×", "shortcut", "hit",
    "home off",
];
const MORE: [&str; 6] = ["strategy", "way ÷ out", "fail-safe", "re-entries", "rad/m", "zigzag"];

/// What came out, for people.
pub(super) fn of(plan: &Plan, summary: &HomeSummary, times: &DecisionTimes) -> String {
    let last = plan.seeds.first + plan.seeds.count - 1;
    let mut said = format!("home, seeds {} to {last}\n", plan.seeds.first);
    let same =
        |a: &HomeFigures, b: &HomeFigures| (a.place, a.setting, &a.robot) == (b.place, b.setting, &b.robot);
    for group in summary.groups.chunk_by(same) {
        let Some(HomeFigures { place, setting, robot, undriven, .. }) = group.first() else { continue };
        let undriven = match undriven {
            0 => String::new(),
            count => format!(" ({count} ways out could not be driven)"),
        };
        said += &format!("\n{setting}, {robot} robot, {place}{undriven}\n{}", figures(group).render());
        said += &more(group).render();
    }
    said += &pairs(summary);
    if !summary.checks.is_empty() {
        said += &format!(
            "\nWhat the runs say of `recommended` with the bad robot\n{}",
            verdicts(&summary.checks)
        );
    }
    said + LEGEND + &thinking(times)
}

fn figures(group: &[HomeFigures]) -> Table {
    let mut table = Table::new(&HEADS);
    for of in group {
        let [half, one, more] = of.success;
        let offset =
            of.home_offset.map_or("–".to_owned(), |[median, worst]| format!("{median:.2}, {worst:.2}"));
        table.row(vec![
            of.strategy.clone(),
            of.episodes.to_string(),
            share(one),
            short_share(half),
            short_share(more),
            short_share(of.own_stop),
            short_share(of.gave_up),
            number(of.spl),
            short(of.path_ratio),
            short_share(of.shortcuts),
            of.collided.map_or("–".to_owned(), |rate| {
                format!("{:.1} % (≤ {:.1})", rate.value * 100.0, rate.interval.high * 100.0)
            }),
            offset,
        ]);
    }
    table
}

fn more(group: &[HomeFigures]) -> Table {
    let mut table = Table::new(&MORE);
    for of in group {
        let cells = [of.path_over_out, of.failsafe_steps, of.reentries, of.turning, of.zigzag].map(short);
        table.row(std::iter::once(of.strategy.clone()).chain(cells).collect());
    }
    table
}

fn pairs(summary: &HomeSummary) -> String {
    let mut table = Table::of_words(&["setting, robot", "strategy", "more SPL than", "mean"]);
    for pair in &summary.pairs {
        let place = format!("{}, {}", pair.setting, pair.robot);
        table.row(vec![place, pair.strategy.clone(), pair.with.clone(), number(pair.more)]);
    }
    if summary.pairs.is_empty() {
        String::new()
    } else {
        format!("\nOn the same ways home\n{}", table.render())
    }
}

fn thinking(times: &DecisionTimes) -> String {
    let lines = times.iter().map(|(strategy, times)| {
        format!(
            "  {strategy}: a decision took {:.2} ms, {:.1} at worst, by the wall clock and whatever else went on\n",
            times.mean_ms, times.worst_ms
        )
    });
    lines.collect()
}

fn share(figure: Option<Estimate>) -> String {
    figure.map_or("–".to_owned(), |figure| written(figure, true))
}

fn number(figure: Option<Estimate>) -> String {
    figure.map_or("–".to_owned(), |figure| written(figure, false))
}

fn short_share(figure: Option<Estimate>) -> String {
    figure.map_or("–".to_owned(), |figure| format!("{:.1} %", figure.value * 100.0))
}

fn short(figure: Option<Estimate>) -> String {
    figure.map_or("–".to_owned(), |figure| format!("{:.2}", figure.value))
}

const LEGEND: &str = "
  ≤ 1 m: own stop within so far of the true start, and nothing hit. gave up: stopped for help, nothing hit; right in
  no-way. SPL: shortest way for a disc of its size over the way driven and what is missing to home, 0 without success;
  path ×: that way over the shortest, of successes.
  shortcut: taken, where the shortest way is at most 0.7 of the way out. hit: ways home with a collision, and the most
  that the runs leave possible. home off: median and 95th percentile of home as believed from home, metres.
  way ÷ out: way driven over the way out, of successes. fail-safe: decisions led by it. re-entries: dead ends entered
  again. rad/m: turning. zigzag: sharp turns against the one before, for each 10 m. In brackets 95 % intervals.
";
