use cogmap_geometry::{DVec2, Segment};
use cogmap_mapping::{
    Mapper,
    places::{Exit, Wideness},
};
use cogmap_scene::{Annotation, Bounds, Colouring, Item, LegendEntry, MemoryOptions, Sample};

use super::{
    Drawing, Runs,
    draw::{dashed, lines, role},
    maps::{panel_of, seen_in_the_world},
    outings::{NARROW, NOT_NARROW},
    plot::Plot,
    runs::Run,
};

const MAPPER: &str = "perceptual";

/// How many exits and spaces, in words.
fn found(mapper: &Mapper) -> (usize, usize) {
    mapper.network().map_or((0, 1), |network| (network.exits().len(), network.asrs().len()))
}

/// The map in the colours of its spaces.
fn by_space(run: &Run) -> cogmap_scene::Scene {
    let options = MemoryOptions {
        truth: true,
        view: false,
        network: true,
        colouring: Colouring::Asr,
        ..MemoryOptions::default()
    };
    seen_in_the_world(run, MAPPER, options)
}

/// Fig. 3.13.
pub(super) fn narrow_or_not(runs: &mut Runs) -> Result<Drawing, String> {
    let (narrow, not) = (runs.of(&NARROW)?, runs.of(&NOT_NARROW)?);
    let ((exits, spaces), (no_exits, one_space)) =
        (found(narrow.mind(MAPPER)?.0), found(not.mind(MAPPER)?.0));
    Ok(Drawing {
        panels: vec![
            panel_of("With a narrow passage", by_space(&narrow)),
            panel_of("Without", by_space(&not)),
        ],
        columns: 2,
        outcome: format!("Exits found: {exits} and {no_exits}; local spaces: {spaces} and {one_space}."),
        source: format!(
            "the perceptual mapper in two worlds made for it, bad robot, seed {}",
            narrow.session.record().seed
        ),
    })
}

/// Fig. 3.14.
pub(super) fn wideness(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&NARROW)?;
    let (mapper, journal) = run.mind(MAPPER)?;
    let places = journal.reports.iter().filter_map(|report| report.place.as_ref());
    let measured: Vec<Wideness> = places.flat_map(|place| place.wideness.iter().copied()).collect();
    let exit = mapper.network().and_then(|network| network.exits().first());
    let map = by_space(&run);
    let start = run.world_from_map().position;
    let below = map.bounds().map_or(0.0, |bounds| bounds.min.y);
    let chart = Chart::of(&measured, DVec2::new(start.x, below - 3.6));
    let mut panel = panel_of("", map);
    panel.room = Some(chart.room(below));
    panel.scene.changing.extend(chart.items());
    let minimum = exit.and_then(|exit| nearest(&measured, in_map(mapper, exit)));
    let outcome = match minimum {
        Some(minimum) => {
            let chord = run.world_from_map() * minimum.chord;
            let at = DVec2::new(minimum.way, minimum.width);
            let down = Segment::new(chord.midpoint(), chart.plot.place(at));
            panel.scene.changing.push(lines(role(Annotation::Measure), dashed(down, 0.12)));
            panel.scene.changing.push(chart.plot.marks([at]));
            format!(
                "It is {:.2} m wide at its narrowest, {:.1} m from the start.",
                minimum.width, minimum.way
            )
        }
        None => "In this run no exit was found.".to_owned(),
    };
    panel
        .scene
        .legend
        .push(LegendEntry::new(Sample::Line(role(Annotation::Curve)), "wideness along the way"));
    panel.scene.legend.push(LegendEntry::new(Sample::Sign(role(Annotation::Mark)), "its minimum"));
    let source = format!("the perceptual mapper, {}", run.words());
    Ok(Drawing { panels: vec![panel], columns: 1, outcome, source })
}

fn in_map(mapper: &Mapper, exit: &Exit) -> Segment {
    mapper.mfis().map_from_frame(exit.frame) * exit.segment
}

/// Where the way is narrowest beside an exit.
fn nearest(measured: &[Wideness], exit: Segment) -> Option<Wideness> {
    let distance = |sample: &Wideness| sample.chord.midpoint().distance(exit.midpoint());
    let near = measured.iter().filter(|sample| distance(sample) < 0.5);
    near.copied().min_by(|a, b| a.width.total_cmp(&b.width))
}

/// The curve of wideness below the map, along the same way.
struct Chart {
    plot: Plot,
    curve: Vec<DVec2>,
}

impl Chart {
    /// Nothing in the picture is wider than this, metres.
    const WIDEST: f64 = 6.0;
    /// How high a metre of wideness is drawn, metres.
    const SCALE: f64 = 0.45;

    fn of(measured: &[Wideness], corner: DVec2) -> Self {
        let way = measured.last().map_or(1.0, |last| last.way);
        let curve = measured.iter().map(|sample| DVec2::new(sample.way, sample.width.min(Self::WIDEST)));
        let to = DVec2::new(way, Self::WIDEST);
        let size = DVec2::new(way, Self::WIDEST * Self::SCALE);
        Self { plot: Plot { corner, size, from: DVec2::ZERO, to }, curve: curve.collect() }
    }

    fn items(&self) -> Vec<Item> {
        let metres = |to: f64, every: f64| {
            let mut ticks = Vec::new();
            while every * ticks.len() as f64 <= to {
                let value = every * ticks.len() as f64;
                ticks.push((value, format!("{value:.0}")));
            }
            ticks
        };
        let (x, mut y) = (metres(self.plot.to.x, 1.0), metres(self.plot.to.y, 2.0));
        if let Some((_, text)) = y.last_mut() {
            text.insert(0, '≥');
        }
        let mut items = self.plot.axes(&x, &y, ["way, m", "wideness, m"]);
        items.push(self.plot.curve(self.curve.iter().copied()));
        items
    }

    /// The chart and the numbers around it.
    fn room(&self, top: f64) -> Bounds {
        let (min, max) = (self.plot.corner, self.plot.corner + self.plot.size);
        Bounds { min: min - DVec2::new(0.8, 1.0), max: DVec2::new(max.x, top) }
    }
}
