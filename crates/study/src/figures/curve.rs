use cogmap_geometry::{DVec2, Segment, trig};
use cogmap_scene::{Annotation, Item, Panel, Plate, Role, Sample, Shape};

use super::{
    draw::{lines, panel, role},
    plot::Plot,
};
use crate::{Condition, Ground, Group, Outcome, metrics::Estimate};

/// Fewer points than this make no curve.
const FEW: usize = 3;
/// Of a panel, metres of the picture.
const SIZE: DVec2 = DVec2::new(5.0, 2.9);

/// What a study varied, and what it looked at.
struct Axis {
    title: &'static str,
    name: &'static str,
    of: fn(&Condition) -> Option<f64>,
}

const AXES: [Axis; 2] = [
    Axis {
        title: "How wrong the map is, by the length of a step",
        name: "metres or radians from one view to the next",
        of: |condition| condition.treatment.every,
    },
    Axis {
        title: "How wrong the map is, by the errors of odometry",
        name: "times the robot’s odometry errors",
        of: |condition| Some(condition.treatment.odometry),
    },
];

/// Both kinds of errors that a map's shape is told by: the measure, and its name at the axis.
fn measure(ground: &Ground) -> (&'static str, &'static str) {
    match ground {
        Ground::Drive { .. } => ("shape", "shape error, m"),
        Ground::Log(_) => ("relations", "relations error, m"),
    }
}

/// One mapper's errors with what was varied.
struct Series<'a> {
    mapper: &'a str,
    points: Vec<(f64, Estimate)>,
}

/// How the error of each mapper's map follows what the study varied, with 95 % intervals; a panel for
/// each building or log. `None` where nothing was varied.
#[must_use]
pub fn curve(outcome: &Outcome) -> Option<Plate> {
    let axis = AXES.iter().find(|axis| !grounds(outcome, axis).is_empty())?;
    let grounds = grounds(outcome, axis);
    let panels = grounds.iter().filter_map(|ground| drawn(outcome, axis, ground)).collect();
    let seeds = outcome.groups().map(|group| group.rows().count()).max().unwrap_or(0);
    Some(Plate {
        title: axis.title.to_owned(),
        caption: "Each point is the median over all runs, each upright line its 95 % interval; the scale of errors is \
                  logarithmic. All mappers were fed the same drives."
            .to_owned(),
        source: format!("A new run: {seeds} seeds at each point."),
        panels,
        columns: 2,
        plots: true,
    })
}

/// Where the study varied it often enough for a curve: one condition for each.
fn grounds<'a>(outcome: &'a Outcome, axis: &Axis) -> Vec<&'a Condition> {
    let conditions = &outcome.conditions;
    let varied = |condition: &Condition| {
        let alike = conditions.iter().filter(|other| condition.shares_drives_with(other));
        let mut values: Vec<f64> = alike.filter_map(axis.of).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values.len() >= FEW
    };
    let mut grounds: Vec<&Condition> = Vec::new();
    for condition in conditions.iter().filter(|condition| varied(condition)) {
        if !grounds.iter().any(|ground| ground.shares_drives_with(condition)) {
            grounds.push(condition);
        }
    }
    grounds
}

fn drawn(outcome: &Outcome, axis: &Axis, ground: &Condition) -> Option<Panel> {
    let (measure, name) = measure(&ground.ground);
    let all = series(outcome, axis, ground, measure);
    let points = || all.iter().flat_map(|series| &series.points);
    let x: Vec<f64> = all.first()?.points.iter().map(|(x, _)| *x).collect();
    let lowest = points().map(|(_, error)| error.interval.low).fold(f64::INFINITY, f64::min);
    let highest = points().map(|(_, error)| error.interval.high).fold(0.0, f64::max);
    let y = ticks(lowest.max(1e-4), highest.max(1e-3));
    let margin = 0.04 * (x.last()? - x.first()?);
    let plot = Plot {
        corner: DVec2::ZERO,
        size: SIZE,
        from: DVec2::new(x.first()? - margin, trig::log10(*y.first()?)),
        to: DVec2::new(x.last()? + margin, trig::log10(*y.last()?)),
    };
    let x: Vec<_> = x.iter().map(|value| (*value, value.to_string())).collect();
    let y: Vec<_> = y.iter().map(|value| (trig::log10(*value), value.to_string())).collect();
    let mut items = plot.axes(&x, &y, [axis.name, name]);
    items.extend(all.iter().enumerate().flat_map(|(number, series)| painted(&plot, number, series)));
    let legend: Vec<_> =
        all.iter().enumerate().map(|(number, series)| (Sample::Line(style(number)), series.mapper)).collect();
    let heading = match ground.route() {
        "" => ground.place().to_owned(),
        route => format!("{}, {route}, {} robot", ground.place(), ground.robot()),
    };
    Some(panel(heading, items, &legend))
}

fn series<'a>(outcome: &'a Outcome, axis: &Axis, ground: &Condition, measure: &str) -> Vec<Series<'a>> {
    let mut all: Vec<Series<'a>> = Vec::new();
    for group in outcome.groups().filter(|group| group.of().shares_drives_with(ground)) {
        let Some(point) = point(&group, axis, measure) else { continue };
        match all.iter_mut().find(|series| series.mapper == group.label()) {
            Some(series) => series.points.push(point),
            None => all.push(Series { mapper: group.label(), points: vec![point] }),
        }
    }
    all.iter_mut().for_each(|series| series.points.sort_by(|a, b| a.0.total_cmp(&b.0)));
    all
}

fn point(group: &Group<'_>, axis: &Axis, measure: &str) -> Option<(f64, Estimate)> {
    Some(((axis.of)(group.of())?, group.figure_of(measure)?))
}

/// The curve, its points and their intervals, a little beside those of the others.
fn painted(plot: &Plot, number: usize, series: &Series<'_>) -> [Item; 3] {
    let beside = DVec2::new(0.03 * (number as f64 - 2.0), 0.0);
    let at = |x: f64, error: f64| plot.place(DVec2::new(x, trig::log10(error).max(plot.from.y))) + beside;
    let points: Vec<DVec2> = series.points.iter().map(|(x, error)| at(*x, error.value)).collect();
    let intervals = series
        .points
        .iter()
        .map(|(x, error)| Segment::new(at(*x, error.interval.low), at(*x, error.interval.high)));
    let style = style(number);
    [
        lines(style, intervals),
        Item::new(style, Shape::Polyline(points.clone())),
        Item::new(style, Shape::Signs(points)),
    ]
}

const fn style(number: usize) -> Role {
    role(Annotation::Series(number))
}

/// 1 and 3 of each power of ten around all values from `lowest` to `highest`, metres.
fn ticks(lowest: f64, highest: f64) -> Vec<f64> {
    const ALL: [f64; 13] = [0.0001, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0];
    let first = ALL.iter().rposition(|tick| *tick <= lowest).unwrap_or(0).min(ALL.len() - 2);
    let last = ALL.iter().position(|tick| *tick >= highest).unwrap_or(ALL.len() - 1);
    ALL[first..=last.max(first + 1)].to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Request, Row, Study, score::Values};

    /// An outcome in which each mapper's error is its number times what was varied, in centimetres.
    fn outcome(study: &str) -> Outcome {
        let conditions = (Study::named(study).unwrap().plan)(&Request::default()).unwrap();
        let mut rows = Vec::new();
        for (condition, of) in conditions.iter().enumerate() {
            for (mapper, seed) in
                (0..of.mappers.len()).flat_map(|mapper| [1, 2, 3].map(|seed| (mapper, seed)))
            {
                let varied = of.treatment.every.unwrap_or(of.treatment.odometry);
                let mut values = Values::default();
                values.put("shape", 0.01 * (1.0 + mapper as f64) * varied);
                rows.push(Row { condition, mapper, seed, values });
            }
        }
        Outcome { conditions, rows }
    }

    #[test]
    fn each_mapper_has_a_curve_through_its_medians() {
        for (study, points) in [("odometry-independence", 4), ("cadence", 6)] {
            let outcome = outcome(study);
            let axis = AXES.iter().find(|axis| !grounds(&outcome, axis).is_empty()).unwrap();
            let ground = grounds(&outcome, axis)[0];
            let all = series(&outcome, axis, ground, "shape");
            assert_eq!(all.len(), outcome.conditions[0].mappers.len());
            for (number, series) in all.iter().enumerate() {
                assert_eq!(series.points.len(), points, "{study}");
                let factor = 0.01 * (1.0 + number as f64);
                assert!(series.points.iter().all(|(x, error)| (error.value - factor * x).abs() < 1e-12));
            }
            let plate = curve(&outcome).unwrap();
            assert_eq!(plate.panels.len(), 1);
            assert_eq!(plate.panels[0].scene.legend.len(), all.len());
        }
    }

    #[test]
    fn a_study_that_varies_nothing_has_no_curve() {
        assert!(curve(&outcome("small")).is_none());
    }

    #[test]
    fn the_ticks_enclose_all_values() {
        assert_eq!(ticks(0.05, 7.0), [0.03, 0.1, 0.3, 1.0, 3.0, 10.0]);
        assert_eq!(ticks(0.3, 0.3), [0.3, 1.0]);
        assert_eq!(ticks(200.0, 200.0), [30.0, 100.0]);
    }
}
