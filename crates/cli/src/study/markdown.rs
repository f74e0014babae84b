use cogmap_study::{Group, Measure, Outcome, Seeds};

use super::tables::cell;

/// The columns, by the measures' names.
const COLUMNS: [&str; 9] = [
    "shape",
    "gap",
    "heading_gap",
    "pieces",
    "displaced",
    "blocked",
    "exits_found",
    "exits_true",
    "home_known",
];

/// What must be said beside the figures.
const HONESTLY: &str = "\
`perceptual` is the thesis's program to the letter, flaws included; `consensus` is ours and not Yeap's model: it
keeps two of its commitments (nothing stored is moved, new surfaces are placed from recognised ones) and borrows
from SLAM a pose that all references determine together, small local frames, and a jump when a place is recognised.
That jump closes the gap, so what is said of a map's shape is said of `consensus-no-recognition`. The buildings are
made after the thesis's descriptions and the runs are new: the figures show what the thesis's figures show, not its
own data. All measures are ours; the thesis judges by eye.
";

/// The README's table: a row for each building, robot and mapper.
pub(super) fn of(seeds: Seeds, outcome: &Outcome) -> String {
    let measures: Vec<&Measure> = COLUMNS.iter().filter_map(|name| Measure::named(name)).collect();
    let unit = |measure: &&Measure| match measure.unit {
        "" => measure.head.to_owned(),
        unit => format!("{} ({unit})", measure.head),
    };
    let heads: Vec<String> = measures.iter().map(unit).collect();
    let mut text = format!(
        "| where, robot | mapper | {} |\n|---|---|{}\n",
        heads.join(" | "),
        "--:|".repeat(heads.len())
    );
    for group in outcome.groups() {
        text += &row(&group, &measures);
    }
    text += "\n";
    for measure in measures {
        text += &format!("- {}: {}\n", measure.head, measure.meaning);
    }
    let last = seeds.first + seeds.count - 1;
    text += &format!(
        "\nMedians, rates and ratios over the seeds {} to {last}, their 95 % intervals in brackets.\n\n",
        seeds.first
    );
    text + HONESTLY
}

fn row(group: &Group<'_>, measures: &[&Measure]) -> String {
    let where_and_who = if group.mapper == 0 { group.of().title() } else { String::new() };
    let cells: Vec<String> = measures.iter().map(|measure| cell(group, measure)).collect();
    format!("| {where_and_who} | {} | {} |\n", group.label(), cells.join(" | "))
}
