use cogmap_study::metrics::Estimate;
use cogmap_study::{Check, Claim, Group, Kind, Measure, Outcome, Seeds, Study, Verdict};

use crate::table::Table;

/// How many measures stand side by side.
const ACROSS: usize = 5;

/// What came out of a study, for people.
pub(crate) fn of(study: &Study, seeds: Seeds, outcome: &Outcome, checks: &[Check]) -> String {
    let last = seeds.first + seeds.count - 1;
    let shown: Vec<&Measure> = study.shown.iter().filter_map(|name| Measure::named(name)).collect();
    let mut said = format!("{}, seeds {} to {last}\n", study.name, seeds.first);
    for condition in 0..outcome.conditions.len() {
        let title = outcome.conditions[condition].title();
        said += &format!("\n{title}\n{}", groups(outcome, condition, &shown));
    }
    said += &legend(&shown);
    if !checks.is_empty() {
        said += &format!("\nWhat the runs say\n{}", verdicts(checks));
    }
    said
}

/// The figures of a condition, a row a mapper; more measures than fit on a line go below, and those that say
/// nothing of any of its mappers are left out.
fn groups(outcome: &Outcome, condition: usize, shown: &[&Measure]) -> String {
    let mut said = String::new();
    let groups: Vec<Group<'_>> = outcome.groups().filter(|group| group.condition == condition).collect();
    let applies = |measure: &&Measure| groups.iter().any(|group| group.figure(measure).is_some());
    let shown: Vec<&Measure> = shown.iter().copied().filter(applies).collect();
    for shown in shown.chunks(ACROSS) {
        let heads: Vec<&str> =
            std::iter::once("mapper").chain(shown.iter().map(|measure| measure.head)).collect();
        let mut table = Table::new(&heads);
        for group in &groups {
            let cells = shown.iter().map(|measure| cell(group, measure));
            table.row(std::iter::once(group.label().to_owned()).chain(cells).collect());
        }
        said += &table.render();
    }
    said
}

pub(super) fn cell(group: &Group<'_>, measure: &Measure) -> String {
    let Some(figure) = group.figure(measure) else { return "–".to_owned() };
    written(figure, is_share(measure))
}

/// Rates and parts of a count are written per cent.
fn is_share(measure: &Measure) -> bool {
    match measure.kind {
        Kind::Median | Kind::Ratio(_) => false,
        Kind::Rate | Kind::Part(_) => true,
    }
}

/// A figure and its interval.
pub(super) fn written(figure: Estimate, share: bool) -> String {
    let Estimate { value, interval, .. } = figure;
    if share {
        let [value, low, high] = [value, interval.low, interval.high].map(|value| rounded(value * 100.0));
        format!("{value} % ({low}–{high})")
    } else {
        let [value, low, high] = [value, interval.low, interval.high].map(rounded);
        format!("{value} ({low}–{high})")
    }
}

/// Three digits that mean something, or none after the point from 100 on.
fn rounded(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if size < 1.0 => format!("{value:.3}"),
        size if size < 10.0 => format!("{value:.2}"),
        size if size < 100.0 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}

fn legend(shown: &[&Measure]) -> String {
    let mut table = Table::of_words(&["", ""]);
    for measure in shown {
        let unit = if measure.unit.is_empty() { String::new() } else { format!(" ({})", measure.unit) };
        table.row(vec![measure.head.to_owned(), format!("{}{unit}", measure.meaning)]);
    }
    format!(
        "{}  Medians, rates and ratios over all runs, in brackets their 95 % intervals.\n",
        table.render()
    )
}

/// Claim by claim: the verdict for each form and robot, and what it rests on.
fn claims(checks: &[Check]) -> String {
    let mut said = String::new();
    let of = |check: &Check| check.claim.clone();
    for of_statement in checks.chunk_by(|a, b| of(a).map(|c| c.id) == of(b).map(|c| c.id)) {
        let Some(Claim { id, statement, .. }) = of_statement.first().and_then(of) else { continue };
        said += &format!("\n{id}: {statement}\n");
        for of_claim in of_statement.chunk_by(|a, b| a.claim == b.claim) {
            let Some(Claim { form, robot, .. }) = of_claim.first().and_then(of) else { continue };
            let whose = if form == "perceptual" { "the thesis's" } else { "ours, not Yeap's" };
            said += &format!("  {}: {form} ({whose}), {robot} robot\n", Verdict::of_all(of_claim).word());
            for line in criteria(of_claim).render().lines().skip(1) {
                said += &format!("    {line}\n");
            }
        }
    }
    said + RULE
}

const RULE: &str = "  met: the figure itself lies where its criterion wants it. Supported: the whole 95 % interval does; \
                    refuted: it lies on the other side;\n  undecided: it reaches to both sides, or nothing was run. A \
                    claim is supported if every criterion is, and refuted if any is.\n";

pub(super) fn verdicts(checks: &[Check]) -> String {
    if checks.iter().any(|check| check.claim.is_some()) {
        claims(checks)
    } else {
        criteria(checks).render() + RULE
    }
}

fn criteria(checks: &[Check]) -> Table {
    let mut table = Table::of_words(&["verdict", "met", "figure", "criterion"]);
    for check in checks {
        let met = if check.met { "yes" } else { "no" };
        let figure = check.figure.map_or("no runs".to_owned(), |figure| written(figure, check.share));
        table.row(vec![check.verdict.word().into(), met.into(), figure, check.criterion.clone()]);
    }
    table
}

#[cfg(test)]
mod tests {
    use cogmap_study::metrics::Interval;

    use super::*;

    #[test]
    fn figures_are_written_with_their_intervals() {
        let figure = Estimate { value: 0.9515, interval: Interval { low: 0.9, high: 1.0 }, runs: 200 };
        assert_eq!(written(figure, true), "95.2 % (90.0–100)");
        assert_eq!(written(figure, false), "0.952 (0.900–1.00)");
    }
}
