use cogmap_mapping::{Event, Mapper, places::Network};
use cogmap_scene::{Colouring, Item, MemoryOptions, Panel, PlaceMark, Role, Sample, Scene};
use cogmap_simulation::MapperJournal;

use super::{
    Drawing, Runs,
    maps::{panel_of, plan_of, seen_in_the_world},
    outings::{LARGE_BAD, TOUR},
    runs::Run,
};

const OURS: &str = "consensus";

/// What a mapper knows of the local spaces of a drive.
pub(super) fn network_of<'a>(run: &'a Run, mapper: &str) -> Result<(&'a Mapper, &'a Network), String> {
    let (mind, _) = run.mind(mapper)?;
    Ok((mind, mind.network().ok_or("this mapper knows no local spaces")?))
}

/// The map in the colours of its spaces, with their numbers and exits.
fn spaces_of(run: &Run, mapper: &str) -> Scene {
    let options =
        MemoryOptions { view: false, network: true, colouring: Colouring::Asr, ..MemoryOptions::default() };
    seen_in_the_world(run, mapper, options)
}

/// Nothing but the spaces and the ways between them.
pub(super) fn network_alone(run: &Run, mapper: &str) -> Scene {
    let mut scene = spaces_of(run, mapper);
    let of_network = |item: &Item| match item.role {
        Role::Place(mark) => !matches!(mark, PlaceMark::Surface(_) | PlaceMark::Debris(_)),
        _ => false,
    };
    scene.still.retain(of_network);
    scene.changing.clear();
    let of_map = |sample: Sample| {
        matches!(
            sample,
            Sample::Robot(_) | Sample::Sign(Role::PathStep | Role::WeakPlacement | Role::FallbackPlacement)
        )
    };
    scene.legend.retain(|entry| !of_map(entry.sample));
    scene
}

fn counted(network: &Network) -> String {
    format!("{} local spaces and {} exits", network.asrs().len(), network.exits().len())
}

/// The first loop that was closed, in words.
fn closing(journal: &MapperJournal) -> Option<String> {
    journal.map_events().find_map(|(step, event)| match event {
        Event::LoopClosed { asr, instead_of, .. } => {
            let space = instead_of.map_or("the space ahead".to_owned(), |newer| format!("space {}", newer.0));
            Some(format!("In view {} it finds that {space} is space {}.", step + 1, asr.0))
        }
        _ => None,
    })
}

fn source(run: &Run) -> String {
    format!("the consensus mapper, {}", run.words())
}

/// Fig. 2.1.
pub(super) fn spaces_and_exits(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&TOUR)?;
    let (_, network) = network_of(&run, OURS)?;
    Ok(Drawing {
        panels: vec![
            panel_of("The building", plan_of(&run)),
            panel_of("The network that the robot makes of it", network_alone(&run, OURS)),
        ],
        columns: 2,
        outcome: format!("Here it knows {}.", counted(network)),
        source: source(&run),
    })
}

/// Fig. 2.7.
pub(super) fn after_a_round_trip(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&TOUR)?;
    let (_, network) = network_of(&run, OURS)?;
    let closed = closing(run.mind(OURS)?.1);
    let closed = closed.unwrap_or_else(|| "In this run it does not notice that it is back.".to_owned());
    Ok(Drawing {
        panels: vec![panel_of("", network_alone(&run, OURS))],
        columns: 1,
        outcome: format!("{closed} The network has {}.", counted(network)),
        source: source(&run),
    })
}

/// Fig. 2.8.
pub(super) fn memory_of_a_round_trip(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&TOUR)?;
    let off = super::maps::off_in_words(&run, OURS)?;
    Ok(Drawing {
        panels: vec![panel_of("", spaces_of(&run, OURS))],
        columns: 1,
        outcome: format!("In the end the robot believes itself {off} from where it is."),
        source: source(&run),
    })
}

/// Fig. 3.24.
pub(super) fn separated(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&LARGE_BAD)?;
    let mut panels: Vec<Panel> = Vec::new();
    let mut outcome = String::new();
    for (mapper, heading) in [("perceptual", "As the thesis programs it"), (OURS, "Our own form")] {
        let (_, network) = network_of(&run, mapper)?;
        panels.push(panel_of(format!("{heading}: {}", counted(network)), spaces_of(&run, mapper)));
        let closed = closing(run.mind(mapper)?.1).unwrap_or_else(|| "It finds no loop.".to_owned());
        outcome += &format!(
            "{heading}: {} ",
            closed.replacen("In view", "in view", 1).replacen("It finds", "it finds", 1)
        );
    }
    outcome += "The thesis’s robot made 8 spaces of its building and found the loop.";
    Ok(Drawing { panels, columns: 2, outcome, source: format!("perceptual and consensus, {}", run.words()) })
}
