use crate::{
    Condition,
    measure::{Kind, MEASURES, Measure},
    metrics::{Estimate, Rate, estimate, growth_exponent, median_estimate, ratio_estimate, share_estimate},
    score::{STRETCHES, Values},
};

/// One run of one mapper.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which of the conditions.
    pub condition: usize,
    /// Which of its mappers.
    pub mapper: usize,
    /// What all chance came from.
    pub seed: u64,
    /// What it was worth.
    pub values: Values,
}

/// Everything that a study found out: a row for each condition, seed and mapper, in this order.
pub struct Outcome {
    /// What was run.
    pub conditions: Vec<Condition>,
    /// What came out.
    pub rows: Vec<Row>,
}

/// The runs of one mapper under one condition.
#[derive(Clone, Copy)]
pub struct Group<'a> {
    outcome: &'a Outcome,
    /// Which of the conditions.
    pub condition: usize,
    /// Which of its mappers.
    pub mapper: usize,
}

impl Outcome {
    /// The groups of runs, in order.
    pub fn groups(&self) -> impl Iterator<Item = Group<'_>> {
        let mappers = self
            .conditions
            .iter()
            .enumerate()
            .flat_map(|(condition, of)| (0..of.mappers.len()).map(move |mapper| (condition, mapper)));
        mappers.map(|(condition, mapper)| Group { outcome: self, condition, mapper })
    }

    /// The groups of a mapper with a robot, in the order of conditions.
    pub fn groups_of<'a>(&'a self, robot: &'a str, mapper: &'a str) -> impl Iterator<Item = Group<'a>> {
        self.groups().filter(move |group| group.robot() == robot && group.label() == mapper)
    }

    /// All runs as comma-separated values, a line each; an empty cell where a measure does not apply.
    #[must_use]
    pub fn csv(&self) -> String {
        let names: Vec<&str> = MEASURES.iter().map(|measure| measure.name).collect();
        let mut text = format!("world,route,robot,odometry,every,seed,mapper,{}\n", names.join(","));
        for row in &self.rows {
            let condition = &self.conditions[row.condition];
            let cells = [
                quoted(condition.place()),
                quoted(condition.route()),
                quoted(condition.robot()),
                condition.treatment.odometry.to_string(),
                condition.treatment.every.map(|every| every.to_string()).unwrap_or_default(),
                row.seed.to_string(),
                quoted(&condition.mappers[row.mapper].label),
            ];
            let value = |measure: &Measure| row.values.get(measure.name).map(|value| value.to_string());
            let values = MEASURES.iter().map(|measure| value(measure).unwrap_or_default());
            text += &cells.into_iter().chain(values).collect::<Vec<_>>().join(",");
            text.push('\n');
        }
        text
    }
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

impl<'a> Group<'a> {
    /// What its runs have in common.
    #[must_use]
    pub fn of(&self) -> &'a Condition {
        &self.outcome.conditions[self.condition]
    }

    /// The robot's name.
    #[must_use]
    pub fn robot(&self) -> &'a str {
        self.of().robot()
    }

    /// The mapper's name in the study.
    #[must_use]
    pub fn label(&self) -> &'a str {
        &self.of().mappers[self.mapper].label
    }

    /// Its runs, by seed.
    pub fn rows(self) -> impl Iterator<Item = &'a Row> {
        self.outcome
            .rows
            .iter()
            .filter(move |row| row.condition == self.condition && row.mapper == self.mapper)
    }

    /// The values of a measure, by seed, where it applies.
    #[must_use]
    pub fn values(&self, measure: &str) -> Vec<f64> {
        self.rows().filter_map(|row| row.values.get(measure)).collect()
    }

    /// The values of a measure on the runs that two groups share: of this one, of the other.
    #[must_use]
    pub fn pairs(&self, other: &Group<'_>, measure: &str) -> Vec<(f64, f64)> {
        let pairs = self.rows().zip(other.rows()).filter(|(row, other)| row.seed == other.seed);
        pairs.filter_map(|(row, other)| row.values.get(measure).zip(other.values.get(measure))).collect()
    }

    /// Of each run the value of a measure and of the one that it is a part of.
    #[must_use]
    pub fn parts(&self, measure: &str, of: &str) -> Vec<(f64, f64)> {
        self.rows().filter_map(|row| row.values.get(measure).zip(row.values.get(of))).collect()
    }

    /// How often something is true of a run.
    #[must_use]
    pub fn rate(&self, is_so: impl Fn(&Values) -> Option<bool>) -> Rate {
        let mut rate = Rate::default();
        self.rows().filter_map(|row| is_so(&row.values)).for_each(|hit| rate.count(hit));
        rate
    }

    /// The exponent with which errors grow with the distance over which they are told, of the root mean
    /// square over runs, with its 95 % interval over runs.
    #[must_use]
    pub fn exponent(&self) -> Option<Estimate> {
        let rows: Vec<&Row> = self.rows().collect();
        estimate(rows.len(), |drawn| {
            let at = |&(length, name): &(f64, &str)| {
                let errors = drawn.iter().map(|&run| rows[run].values.get(name));
                let squares = errors.map(|error| error.map(|error| error * error)).sum::<Option<f64>>()?;
                Some((length, (squares / drawn.len() as f64).sqrt()))
            };
            growth_exponent(&STRETCHES.iter().filter_map(at).collect::<Vec<_>>())
        })
    }

    /// The figure of the measure of that name.
    #[must_use]
    pub fn figure_of(&self, measure: &str) -> Option<Estimate> {
        self.figure(Measure::named(measure)?)
    }

    /// A measure over all runs with its 95 % interval.
    #[must_use]
    pub fn figure(&self, measure: &Measure) -> Option<Estimate> {
        match measure.kind {
            Kind::Median => median_estimate(&self.values(measure.name)),
            Kind::Rate => share_of(self.rate(|values| values.get(measure.name).map(|value| value > 0.0))),
            Kind::Part(of) => share_estimate(&self.parts(measure.name, of)),
            Kind::Ratio(of) => ratio_estimate(&self.parts(measure.name, of)),
        }
    }
}

/// A rate as a share with Wilson's interval.
#[must_use]
#[allow(clippy::cast_possible_truncation, reason = "nobody runs 2^32 seeds")]
pub(crate) fn share_of(rate: Rate) -> Option<Estimate> {
    Some(Estimate { value: rate.share()?, interval: rate.wilson()?, runs: rate.runs as usize })
}
