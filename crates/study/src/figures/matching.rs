use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{
    StepReport,
    memory::{Matching, PairError, Tracked, pair_error},
    perception::{End, Surface},
};
use cogmap_scene::{Annotation, Item, Panel, Role, Sample, Shape};

use super::{
    Drawing, Runs,
    draw::{arc, degrees, lines, panel, robot, role, surfaces, word},
    outings::{LARGE_BAD, SMALL_BAD},
    plot::Plot,
};

const KNOWN: Role = role(Annotation::Known);
const SEEN: Role = role(Annotation::Added);
const MEASURE: Role = role(Annotation::Measure);

/// A sighting without errors of fit, ending truly at both ends.
fn sighting(a: [f64; 2], b: [f64; 2]) -> Surface {
    let segment = Segment::new(a.into(), b.into());
    Surface {
        segment,
        ends: [End::True; 2],
        beams: [0, 99],
        points: 100,
        residual: 0.0,
        range: 3.0,
        incidence: 0.2,
        label: None,
    }
}

/// Fig. 3.4, and the search that uses the error.
pub(super) fn pair(runs: &mut Runs) -> Result<Drawing, String> {
    let (first, second) = (sighting([0.0, 0.0], [3.6, 0.35]), sighting([0.3, 0.62], [3.75, 1.45]));
    let error = pair_error(&second, &Tracked::seen(&first, None), &Matching::default());
    let run = runs.of(&SMALL_BAD)?;
    let (_, journal) = run.mind("transform")?;
    let corrections =
        journal.reports.iter().filter_map(|report| Some((report.step, report.correction.as_ref()?)));
    let best = corrections.max_by(|a, b| gain(&a.1.errors).total_cmp(&gain(&b.1.errors)));
    let (step, errors) = best.map_or((0, &[][..]), |(step, found)| (step, found.errors.as_slice()));
    let legend = [
        (Sample::Line(KNOWN), "S1, a known surface"),
        (Sample::Line(SEEN), "S2, a surface seen now"),
        (Sample::Line(MEASURE), "what is measured"),
        (Sample::Line(role(Annotation::Curve)), "mean error of all pairs"),
    ];
    let PairError { d1, d2, phi, .. } = error;
    let gates = Matching::default();
    Ok(Drawing {
        panels: vec![
            panel("A pair", measured(&first, &second), &legend[..3]),
            panel("The search", trace(errors), &legend[3..]),
        ],
        columns: 2,
        outcome: format!(
            "Left d1 = {d1:.2} m, d2 = {d2:.2} m and φ = {}, larger than is taken for one surface: that goes up to \
             {:.1} m and {:.0}°.",
            degrees(phi),
            gates.distance,
            gates.angle.to_degrees()
        ),
        source: format!("the program’s own pair error; right, step {step} in {}", run.words()),
    })
}

/// By which share a search lowered the error; searches of few steps say little.
fn gain(errors: &[f64]) -> f64 {
    const FEW: usize = 6;
    match errors {
        [first, .., last] if errors.len() > FEW => 1.0 - last / first,
        _ => 0.0,
    }
}

/// Both surfaces, the distances of their ends and the angle between them.
fn measured(first: &Surface, second: &Surface) -> Vec<Item> {
    let (s1, s2) = (first.segment, second.segment);
    let carried = Segment::new(s1.a, s1.a + (s2.b - s2.a) * 0.9);
    let ties = [Segment::new(s1.a, s2.a), Segment::new(s1.b, s2.b)];
    let beside = |tie: Segment, to: f64| tie.midpoint() + DVec2::new(to, 0.0);
    vec![
        lines(MEASURE, super::draw::dashed(carried, 0.1)),
        Item::new(MEASURE, arc(s1.a, 1.5, s1.heading(), s2.heading())),
        lines(MEASURE, ties),
        lines(KNOWN, [s1]),
        lines(SEEN, [s2]),
        Item::new(KNOWN, Shape::Signs(vec![s1.a, s1.b])),
        Item::new(SEEN, Shape::Signs(vec![s2.a, s2.b])),
        word(beside(ties[0], -0.22), "d1"),
        word(beside(ties[1], 0.24), "d2"),
        word(s1.a + DVec2::new(1.72, 0.3), "φ"),
        word(s1.midpoint() - DVec2::new(0.0, 0.22), "S1"),
        word(s2.midpoint() + DVec2::new(0.0, 0.22), "S2"),
    ]
}

/// The mean error after each change that was kept.
fn trace(errors: &[f64]) -> Vec<Item> {
    let highest = errors.first().copied().unwrap_or(1.0).max(1e-9);
    let kept = errors.len().saturating_sub(1).max(1) as f64;
    let to = DVec2::new(kept, highest * 1.05);
    let plot = Plot { corner: DVec2::ZERO, size: DVec2::new(4.0, 2.4), from: DVec2::ZERO, to };
    let every = (kept / 5.0).ceil().max(1.0);
    let mut x = Vec::new();
    while every * (x.len() as f64) <= kept {
        let value = every * x.len() as f64;
        x.push((value, format!("{value:.0}")));
    }
    let y = [0.0, 0.5, 1.0].map(|share| (highest * share, format!("{:.3}", highest * share)));
    let mut items = plot.axes(&x, &y, ["changes kept", "mean error, m² rad"]);
    let values = || errors.iter().enumerate().map(|(change, error)| DVec2::new(change as f64, *error));
    items.push(plot.curve(values()));
    items.extend(values().next_back().map(|last| plot.marks([last])));
    items
}

/// Fig. 3.10.
pub(super) fn views(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&LARGE_BAD)?;
    let (_, journal) = run.mind("perceptual")?;
    let steps = journal.reports.windows(2).filter_map(|pair| Some((pair.first()?, pair.last()?)));
    let (before, now) =
        steps.max_by(|a, b| gap(a.1).total_cmp(&gap(b.1))).ok_or("the robot took no two views")?;
    let moved = run.odometry_of(before).from_here(run.odometry_of(now));
    let legend = [
        (Sample::Robot(Role::Robot), "robot"),
        (Sample::Line(KNOWN), "previous view, moved by a rough guess"),
        (Sample::Line(SEEN), "current view, recognised"),
        (Sample::Line(Role::SeenNow), "current view, new"),
        (Sample::Line(MEASURE), "distances of the ends"),
    ];
    Ok(Drawing {
        panels: vec![
            panel("Two views, one over the other", overlay(before, now, moved), &legend),
            close_up(before, now, moved),
        ],
        columns: 2,
        outcome: format!(
            "Here {} of {} surfaces are recognised.",
            now.matches.len(),
            now.view.surfaces.len()
        ),
        source: format!("step {} of {}", now.step, run.words()),
    })
}

/// How far apart the recognised surfaces of a view are at least, where many are recognised.
fn gap(report: &StepReport) -> f64 {
    let long = report.matches.iter().filter(|m| is_long(report, m.seen));
    let apart: Vec<f64> = long.map(|m| m.fit.d1.min(m.fit.d2)).collect();
    if apart.len() < 3 { 0.0 } else { apart.iter().sum::<f64>() / apart.len() as f64 }
}

fn is_long(report: &StepReport, seen: usize) -> bool {
    report.view.surfaces.get(seen).is_some_and(|surface| surface.length() > 1.0)
}

fn overlay(before: &StepReport, now: &StepReport, moved: Pose) -> Vec<Item> {
    let up = Pose::new(0.0, 0.0, cogmap_geometry::trig::FRAC_PI_2);
    let (seen, new): (Vec<_>, Vec<_>) =
        (0..now.view.surfaces.len()).partition(|&seen| now.matches.iter().any(|m| m.seen == seen));
    let of = |indices: Vec<usize>| indices.into_iter().filter_map(|index| now.view.surfaces.get(index));
    vec![
        surfaces(Role::SeenNow, up, of(new)),
        surfaces(KNOWN, up * moved.inverse(), &before.view.surfaces),
        surfaces(SEEN, up, of(seen)),
        lines(MEASURE, ties(before, now, moved).into_iter().map(|tie| up * tie)),
        robot(Role::Robot, up),
    ]
}

/// From the ends of a sighting to those of the other, where both saw a true end.
fn ties_of(known: &Surface, seen: &Surface) -> Vec<Segment> {
    let ends = [(known.segment.a, seen.segment.a), (known.segment.b, seen.segment.b)];
    let kinds = known.ends.into_iter().zip(seen.ends);
    let ties = ends.into_iter().zip(kinds).filter(|(_, kinds)| *kinds == (End::True, End::True));
    ties.map(|((from, to), _)| Segment::new(from, to)).collect()
}

/// The same for every recognised surface of a view.
fn ties(before: &StepReport, now: &StepReport, moved: Pose) -> Vec<Segment> {
    let pairs = now.matches.iter().filter_map(|m| {
        let known = before.view.surfaces.get(m.previous?)?.seen_from(moved.inverse());
        Some((known, now.view.surfaces.get(m.seen)?))
    });
    pairs.flat_map(|(known, seen)| ties_of(&known, seen)).collect()
}

/// The recognised pair that is farthest apart among the long ones, larger.
fn close_up(before: &StepReport, now: &StepReport, moved: Pose) -> Panel {
    let pairs = now.matches.iter().filter(|m| is_long(now, m.seen)).filter_map(|m| {
        let known = before.view.surfaces.get(m.previous?)?.seen_from(moved.inverse());
        Some((known, now.view.surfaces.get(m.seen)?, m.fit))
    });
    let whole = pairs.filter(|(known, seen, _)| ties_of(known, seen).len() == 2);
    let Some((known, seen, fit)) = whole.max_by(|a, b| a.2.error.total_cmp(&b.2.error)) else {
        return Panel::default();
    };
    let scale = CLOSE_UP / known.length().max(0.1);
    let level = Pose::new(0.0, 0.0, -known.segment.heading());
    let origin = level * known.segment.a;
    let large = |line: Segment| {
        let line = level * line;
        Segment::new((line.a - origin) * scale, (line.b - origin) * scale)
    };
    let (s1, s2) = (large(known.segment), large(seen.segment));
    let text = format!("d1 {:.2} m, d2 {:.2} m, φ {}", fit.d1, fit.d2, degrees(fit.phi));
    let items = vec![
        lines(MEASURE, ties_of(&known, seen).into_iter().map(large)),
        lines(KNOWN, [s1]),
        lines(SEEN, [s2]),
        Item::new(KNOWN, Shape::Signs(vec![s1.a, s1.b])),
        Item::new(SEEN, Shape::Signs(vec![s2.a, s2.b])),
        word(s1.midpoint().midpoint(s2.midpoint()) + DVec2::new(0.0, 1.0), text),
    ];
    panel(format!("One of the pairs, {scale:.1} times as large"), items, &[])
}

/// How long a close-up is, metres of the picture.
const CLOSE_UP: f64 = 5.0;
