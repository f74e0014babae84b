use cogmap_scene::Sample;

use super::{
    Drawing, Runs,
    draw::ring,
    maps::{displaced, map_of, off_in_the_end, off_in_words, one, panel_of, plan_of},
    outings::{ENVIRONMENT_A, LARGE_BAD, LONG_OFFICE, SMALL_BAD},
    runs::{Outing, Run, UNAIDED},
};

/// The mapper of the thesis and ours, and how figures call them.
const MAPPERS: [(&str, &str); 2] = [("perceptual", "As the thesis programs it"), (UNAIDED, "Our own mapper")];
/// A surface that lies farther than this from its wall is displaced, metres.
const DISPLACED: f64 = 0.5;

/// Fig. 2.4.
pub(super) fn memory(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&SMALL_BAD)?;
    let (mapper, journal) = run.mind("perceptual")?;
    let (surfaces, views) = (mapper.mfis().surfaces().len(), journal.reports.len());
    Ok(Drawing {
        panels: vec![
            panel_of("The building", plan_of(&run)),
            panel_of("The MFIS", map_of(&run, "perceptual")),
        ],
        columns: 2,
        outcome: format!("Here it keeps {surfaces} surfaces from {views} views."),
        source: format!("the perceptual mapper, {}", run.words()),
    })
}

/// Fig. 3.16.
pub(super) fn placement(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&LONG_OFFICE)?;
    let mut drawing = both_maps(&run, 1)?;
    let mut counts = Vec::new();
    for ((mapper, _), panel) in MAPPERS.iter().zip(&mut drawing.panels) {
        let off = displaced(&run, mapper)?;
        let far = off.iter().take_while(|(_, distance)| *distance > DISPLACED);
        counts.push(far.count());
        let worst = off.first().filter(|(_, distance)| *distance > DISPLACED);
        let rings = worst.map(|(line, _)| ring(line.midpoint(), 0.5 * line.length() + 0.2));
        panel.scene.changing.extend(rings);
    }
    drawing.outcome = format!(
        "Long surfaces more than {DISPLACED} m off their wall: {} by the thesis’s program, {} by ours{}.",
        counts[0],
        counts[1],
        if counts.iter().any(|&count| count > 0) { "; the farthest is encircled" } else { "" }
    );
    Ok(drawing)
}

/// The maps of both mappers on one drive.
fn both_maps(run: &Run, columns: usize) -> Result<Drawing, String> {
    let mut panels = Vec::new();
    for (mapper, heading) in MAPPERS {
        let off = off_in_words(run, mapper)?;
        panels.push(panel_of(format!("{heading}: {off} off in the end"), map_of(run, mapper)));
    }
    for entry in panels.iter_mut().flat_map(|panel| &mut panel.scene.legend) {
        if entry.sample == Sample::Run {
            entry.text = "first seen early … late".to_owned();
        }
    }
    let source = format!("perceptual, and consensus without recognition of places, {}", run.words());
    Ok(Drawing { panels, columns, outcome: String::new(), source })
}

fn plan(runs: &mut Runs, outing: &Outing) -> Result<Drawing, String> {
    let run = runs.of(outing)?;
    let steps = run.mind("perceptual")?.1.reports.len().saturating_sub(1);
    Ok(one(plan_of(&run), format!("{:.0} m in {steps} steps.", run.length()), run.words()))
}

/// Fig. 3.19.
pub(super) fn map_a(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&ENVIRONMENT_A)?;
    let by_odometry = run.mind("perceptual")?.1.reports.iter().skip(1);
    let by_odometry = by_odometry.filter(|report| report.placement == cogmap_mapping::Placement::Odometry);
    let outcome = format!(
        "On the way {} views of the thesis’s mapper had to be placed by odometry. {}",
        by_odometry.count(),
        verdict(&run)?
    );
    Ok(Drawing { outcome, ..both_maps(&run, 2)? })
}

/// Fig. 3.20.
pub(super) fn plan_a(runs: &mut Runs) -> Result<Drawing, String> {
    plan(runs, &ENVIRONMENT_A)
}

/// Fig. 3.22.
pub(super) fn map_b(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&LARGE_BAD)?;
    let traditional = off_in_words(&run, "transform")?;
    let better = off_in_the_end(&run, "perceptual")?.0 <= off_in_the_end(&run, "transform")?.0;
    let than = if better {
        "as in the thesis the worse of the two"
    } else {
        "in the thesis the worse of the two, in this run the better"
    };
    let outcome =
        format!("On the same drive the traditional mapper is {traditional} off, {than}. {}", verdict(&run)?);
    Ok(Drawing { outcome, ..both_maps(&run, 2)? })
}

/// A gap below this is nearly closed, metres.
const NEARLY_CLOSED: f64 = 1.5;

/// Says so where the literal mapper did not do what the thesis saw.
fn verdict(run: &Run) -> Result<&'static str, String> {
    let (gap, _) = off_in_the_end(run, "perceptual")?;
    Ok(if gap <= NEARLY_CLOSED {
        "As in the thesis, the ends of the literal mapper’s map almost meet."
    } else {
        "The thesis saw the ends almost meet; those of the literal mapper’s map do not in this run."
    })
}

/// Fig. 3.23.
pub(super) fn plan_b(runs: &mut Runs) -> Result<Drawing, String> {
    plan(runs, &LARGE_BAD)
}
