//! The network of local spaces as a schematic: who is next to whom, not where.

mod layout;

use std::collections::BTreeMap;

use cogmap_mapping::{
    Mapper,
    places::{Asr, Exit, Network, outline},
};
use cogmap_scene::loops;
use cogmap_simulation::Session;
use serde::Serialize;
use tsify::Tsify;

use self::layout::{Cell, Edge};

/// The network in a mapper's mind at this moment, laid out on a grid (§2.2.1, Fig. 2.1).
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct Schematic {
    /// The mapper.
    pub mapper: String,
    /// The local spaces, oldest first.
    pub places: Vec<SchematicPlace>,
    /// The exits between them, in the order of finding.
    pub exits: Vec<SchematicExit>,
    /// How many columns it takes.
    pub columns: usize,
    /// How many rows it takes.
    pub rows: usize,
}

/// A local space in a schematic.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct SchematicPlace {
    /// Its number.
    pub asr: u32,
    /// Its column, from 0: through so many exits it is reached from where the robot began.
    pub column: usize,
    /// Its row, from 0; it may lie halfway between two.
    pub row: f64,
    /// Whether the robot believes to be in it.
    pub current: bool,
    /// The area of its floor as far as it was seen, square metres.
    pub area: f64,
    /// How many surfaces belong to it.
    pub surfaces: usize,
    /// The exit behind which it was opened; nothing for the one in which the robot began.
    pub behind: Option<u32>,
    /// Its exits and the spaces behind them, in the order of finding.
    pub exits: Vec<Neighbour>,
    /// The numbers of those that turned out to be this one.
    pub merged: Vec<u32>,
    /// The number of the view in which it was opened.
    pub step: usize,
    /// When that was, seconds since the beginning.
    pub t: f64,
    /// Where the run stood then, ticks or readings.
    pub position: f64,
}

/// An exit of a local space and where it leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
pub struct Neighbour {
    /// The exit.
    pub exit: u32,
    /// The space behind it.
    pub asr: u32,
}

/// An exit in a schematic.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct SchematicExit {
    /// Its number.
    pub exit: u32,
    /// The space that the robot left when it first went through it.
    pub from: u32,
    /// The space that it entered.
    pub to: u32,
    /// From jamb to jamb, metres.
    pub width: f64,
    /// Whether going through it closed a loop.
    pub closed_loop: bool,
    /// Whether it is on the shortest way from where the robot began by which the grid is laid out.
    pub on_tree: bool,
}

/// The network of a mapper; nothing where there is no such mapper, or it does not know what a space is.
pub(crate) fn schematic(
    session: &Session,
    mapper: usize,
    position_at: impl Fn(f64) -> u64,
) -> Option<Schematic> {
    let (mind, journal) = (session.mappers().get(mapper)?, session.journal().mappers.get(mapper)?);
    let network = mind.network()?;
    let loops = loops(journal, network);
    let grid = grid(network);
    let place = |asr: &Asr| {
        let Cell { column, row, .. } = grid.get(&asr.id.0).copied().unwrap_or_default();
        let begun = journal.reports.first().map_or(0.0, |report| report.t);
        let opened = journal.reports.get(asr.step).map_or(begun, |report| report.t);
        SchematicPlace {
            asr: asr.id.0,
            column,
            row,
            current: network.current() == asr.id,
            area: floor_area(asr, network, mind),
            surfaces: network.surfaces_of(asr.id).len(),
            behind: entrance(asr, network),
            exits: neighbours(asr, network),
            merged: asr.merged_from.iter().map(|merged| merged.0).collect(),
            step: asr.step,
            t: opened - begun,
            position: position_at(opened) as f64,
        }
    };
    let way = |exit: &Exit| SchematicExit {
        exit: exit.id.0,
        from: exit.between[0].0,
        to: exit.between[1].0,
        width: exit.segment.length(),
        closed_loop: loops.contains(&exit.id),
        on_tree: grid.values().any(|cell| cell.through == Some(exit.id.0)),
    };
    Some(Schematic {
        mapper: session.record().mappers.get(mapper)?.name().to_owned(),
        places: network.asrs().iter().map(place).collect(),
        exits: network.exits().iter().map(way).collect(),
        columns: grid.values().map(|cell| cell.column + 1).max().unwrap_or(0),
        rows: rows(&grid),
    })
}

fn grid(network: &Network) -> BTreeMap<u32, Cell> {
    let names: Vec<u32> = network.asrs().iter().map(|asr| asr.id.0).collect();
    let edge = |exit: &Exit| Edge { exit: exit.id.0, between: exit.between.map(|asr| asr.0) };
    let edges: Vec<Edge> = network.exits().iter().map(edge).collect();
    layout::lay_out(&names, &edges)
}

fn rows(grid: &BTreeMap<u32, Cell>) -> usize {
    grid.values().map(|cell| cell.row.ceil() as usize + 1).max().unwrap_or(0)
}

/// The exit that was found in the very view in which the space was opened.
pub(crate) fn entrance(asr: &Asr, network: &Network) -> Option<u32> {
    let exits = asr.exits.iter().filter_map(|id| network.exit(*id));
    exits.into_iter().find(|exit| asr.id.0 > 0 && exit.step == asr.step).map(|exit| exit.id.0)
}

pub(crate) fn neighbours(asr: &Asr, network: &Network) -> Vec<Neighbour> {
    let exits = asr.exits.iter().filter_map(|id| network.exit(*id));
    exits.filter_map(|exit| Some(Neighbour { exit: exit.id.0, asr: exit.leads_from(asr.id)?.0 })).collect()
}

/// The area of a space's floor as far as it was seen, square metres.
pub(crate) fn floor_area(asr: &Asr, network: &Network, mind: &Mapper) -> f64 {
    let corners = outline(asr, network, mind.memory());
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| 0.5 * a.perp_dot(*b)).sum::<f64>().abs()
}

#[cfg(test)]
mod tests {
    use cogmap_scene::Theme;

    use super::*;
    use crate::two_rooms::two_rooms;

    #[test]
    fn two_rooms_are_two_places_with_the_door_between_them() {
        let mut run = two_rooms();
        let Schematic { places, exits, columns, rows, .. } = run.schematic(0).unwrap();
        let [home, behind] = &places[..] else { panic!("{places:?}") };
        let [door] = exits[..] else { panic!("{exits:?}") };
        assert_eq!((columns, rows), (2, 1));
        assert_eq!((door.from, door.to, door.on_tree, door.closed_loop), (0, 1, true, false));
        assert!((0.7..1.0).contains(&door.width));
        assert_eq!((home.behind, behind.behind), (None, Some(door.exit)));
        assert_eq!(home.exits, [Neighbour { exit: door.exit, asr: 1 }]);
        assert!(!home.current && behind.current);
        // The first room has 30 square metres.
        assert!((15.0..33.0).contains(&home.area), "{}", home.area);
        run.jump(behind.position as u64 - 1);
        assert_eq!(run.schematic(0).unwrap().places.len(), 1);
        run.jump(behind.position as u64);
        assert_eq!(run.schematic(0).unwrap().places.len(), 2);
    }

    #[test]
    fn who_knows_no_spaces_has_no_schematic() {
        let run = two_rooms();
        assert_eq!((run.schematic(1), run.schematic(7)), (None, None));
    }

    #[test]
    fn the_page_colours_places_and_curves_as_the_pictures_do() {
        let tokens = include_str!("../../../web/src/styles/tokens.css");
        for number in 0..8 {
            let [light, dark] = [Theme::Light, Theme::Dark].map(|theme| theme.of_asr(number).hex());
            let token = format!("--series-{number}: light-dark({light}, {dark});");
            assert!(tokens.contains(&token), "{token}");
        }
    }
}
