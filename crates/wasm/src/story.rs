//! The story of a thing in a memory: when it came to be and by what, in figures.

use cogmap_mapping::{
    Mapper,
    memory::SurfaceId,
    places::{Asr, AsrId, Crossing, ExitId, Network},
};
use cogmap_scene::{Thing, loops, segment_of};
use cogmap_simulation::{MapperJournal, Session};
use serde::Serialize;
use tsify::Tsify;

use crate::{
    memories::placement,
    remembered::Remembered,
    schematic::{Neighbour, entrance, floor_area, neighbours},
    status::PlacementKind,
};

/// A thing in a memory, where it is in the view, and what is known about it.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct Told {
    /// The thing.
    pub thing: Remembered,
    /// Its middle in the view: pixels from the left …
    pub x: f64,
    /// … and from the top.
    pub y: f64,
    /// What is known about it.
    pub facts: Facts,
}

/// A view of the run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Tsify)]
pub struct Occasion {
    /// Its number, from 0.
    pub step: usize,
    /// When it was taken, seconds since the beginning.
    pub t: f64,
    /// Where the run stands when it has just been taken, ticks or readings.
    pub position: f64,
}

/// What is known about a thing in a memory.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Facts {
    /// About a surface.
    Surface(SurfaceFacts),
    /// About an exit that the robot went through.
    Exit(ExitFacts),
    /// About an exit that it only saw.
    Supposed(SupposedFacts),
    /// About a local space.
    Asr(AsrFacts),
}

/// What is known about a surface.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct SurfaceFacts {
    /// Metres.
    pub length: f64,
    /// The view that saw it first and placed it.
    pub seen: Occasion,
    /// The latest in which it was recognised, or the same.
    pub last: Occasion,
    /// In how many views it was seen.
    pub sightings: usize,
    /// What placed it.
    pub by: PlacementKind,
    /// The surface that it was placed relative to, if it was a single one.
    pub relative_to: Option<u32>,
    /// How many surfaces of that view were recognised.
    pub recognised: usize,
    /// The local space that it belongs to.
    pub asr: Option<u32>,
}

/// What is known about an exit that the robot went through.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct ExitFacts {
    /// From jamb to jamb, metres.
    pub width: f64,
    /// The space that the robot left when it first went through it, and the one that it entered.
    pub between: [u32; 2],
    /// The view in which it was found.
    pub made: Occasion,
    /// How often the robot went through it.
    pub crossings: usize,
    /// The view in which it had last gone through.
    pub last: Occasion,
    /// Whether going through closed a loop.
    pub closed_loop: bool,
}

/// What is known about an exit that the robot only saw.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct SupposedFacts {
    /// From jamb to jamb, metres.
    pub width: f64,
    /// The space from which it was first seen.
    pub within: Option<u32>,
    /// The view that saw it first.
    pub seen: Occasion,
    /// In how many views it was seen.
    pub views: u32,
}

/// What is known about a local space.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct AsrFacts {
    /// The area of its floor as far as it was seen, square metres.
    pub area: f64,
    /// How many surfaces belong to it.
    pub surfaces: usize,
    /// Its exits and where they lead, in the order of finding.
    pub exits: Vec<Neighbour>,
    /// The view in which it was opened.
    pub opened: Occasion,
    /// The exit behind which it was opened; nothing for the one in which the robot began.
    pub behind: Option<u32>,
    /// How often the robot has entered it.
    pub entered: usize,
    /// The view in which it had last entered it; nothing where it only began there.
    pub last: Option<Occasion>,
    /// How many loops were closed into it.
    pub loops: usize,
    /// The numbers of those that turned out to be this one.
    pub merged: Vec<u32>,
    /// Whether the robot believes to be in it.
    pub current: bool,
}

/// Whoever knows what became of each thing in a mapper's mind.
pub(crate) struct Teller<'a> {
    pub(crate) mind: &'a Mapper,
    journal: &'a MapperJournal,
    position_at: &'a dyn Fn(f64) -> u64,
}

impl<'a> Teller<'a> {
    /// The teller of a mapper; nothing where there is no such mapper.
    pub(crate) fn of(
        session: &'a Session,
        mapper: usize,
        position_at: &'a dyn Fn(f64) -> u64,
    ) -> Option<Self> {
        let (mind, journal) = (session.mappers().get(mapper)?, session.journal().mappers.get(mapper)?);
        Some(Self { mind, journal, position_at })
    }

    /// What is known about a thing; nothing where the mapper has no such thing in mind.
    pub(crate) fn facts(&self, thing: Thing) -> Option<Facts> {
        segment_of(self.mind, thing)?;
        match thing {
            Thing::Surface(id) => self.surface(id).map(Facts::Surface),
            Thing::Exit(id) => self.exit(id).map(Facts::Exit),
            Thing::Supposed(number) => self.supposed(number).map(Facts::Supposed),
            Thing::Asr(id) => self.asr(id).map(Facts::Asr),
        }
    }

    /// When a view was taken.
    pub(crate) fn occasion(&self, step: usize) -> Occasion {
        let begun = self.journal.reports.first().map_or(0.0, |report| report.t);
        let t = self.journal.reports.get(step).map_or(begun, |report| report.t);
        Occasion { step, t: t - begun, position: (self.position_at)(t) as f64 }
    }

    fn surface(&self, id: SurfaceId) -> Option<SurfaceFacts> {
        let stored = self.mind.mfis().get(id)?;
        let report = self.journal.reports.get(stored.step)?;
        let later = self.journal.reports.iter().skip(stored.step + 1);
        let again = later.filter(|report| report.matches.iter().any(|pair| pair.known == id));
        let (sightings, last) = again.fold((1, stored.step), |(count, _), report| (count + 1, report.step));
        Some(SurfaceFacts {
            length: stored.segment.length(),
            seen: self.occasion(stored.step),
            last: self.occasion(last),
            sightings,
            by: placement(report.placement),
            relative_to: report.reference_target().map(|best| best.known.0),
            recognised: report.matches.len(),
            asr: self.mind.network().and_then(|network| network.asr_of(id)).map(|asr| asr.0),
        })
    }

    fn exit(&self, id: ExitId) -> Option<ExitFacts> {
        let network = self.mind.network()?;
        let exit = network.exit(id)?;
        let own = |crossing: &&Crossing| network.exit(crossing.exit).is_some_and(|it| it.id == exit.id);
        let crossings: Vec<&Crossing> = network.crossings().iter().filter(own).collect();
        Some(ExitFacts {
            width: exit.segment.length(),
            between: exit.between.map(|asr| network.lasting(asr).0),
            made: self.occasion(exit.step),
            crossings: crossings.len(),
            last: self.occasion(crossings.last().map_or(exit.step, |crossing| crossing.step)),
            closed_loop: loops(self.journal, network).contains(&exit.id),
        })
    }

    fn supposed(&self, number: usize) -> Option<SupposedFacts> {
        let network = self.mind.network()?;
        let supposed = network.hypotheses().get(number)?;
        Some(SupposedFacts {
            width: supposed.segment.length(),
            within: network.asr_at(supposed.step).map(|asr| network.lasting(asr).0),
            seen: self.occasion(supposed.step),
            views: supposed.views,
        })
    }

    fn asr(&self, id: AsrId) -> Option<AsrFacts> {
        let network = self.mind.network()?;
        let asr = network.asr(id)?;
        let into = |crossing: &&Crossing| network.lasting(crossing.into) == asr.id;
        let entered: Vec<&Crossing> = network.crossings().iter().filter(into).collect();
        Some(AsrFacts {
            area: floor_area(asr, network, self.mind),
            surfaces: network.surfaces_of(asr.id).len(),
            exits: neighbours(asr, network),
            opened: self.occasion(asr.step),
            behind: entrance(asr, network),
            entered: entered.len(),
            last: entered.last().map(|crossing| self.occasion(crossing.step)),
            loops: self.loops_into(asr, network),
            merged: asr.merged_from.iter().map(|merged| merged.0).collect(),
            current: network.current() == asr.id,
        })
    }

    fn loops_into(&self, asr: &Asr, network: &Network) -> usize {
        let into = |event: &cogmap_mapping::Event| match event {
            cogmap_mapping::Event::LoopClosed { asr: back, .. } => network.lasting(*back) == asr.id,
            _ => false,
        };
        self.journal.map_events().filter(|(_, event)| into(event)).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::two_rooms::two_rooms;

    #[test]
    fn a_surface_knows_what_it_was_placed_by_and_can_be_gone_back_to() {
        let mut run = two_rooms();
        let Some(Facts::Surface(first)) = run.facts(0, Thing::Surface(SurfaceId(0))) else { panic!() };
        assert_eq!((first.by, first.relative_to, first.asr), (PlacementKind::First, None, Some(0)));
        assert!(first.sightings > 1 && first.last.step > 0, "{first:?}");
        let stored = run.session().mappers()[0].mfis().surfaces();
        let last = stored.last().unwrap().clone();
        let Some(Facts::Surface(told)) = run.facts(0, Thing::Surface(last.id)) else { panic!() };
        assert_eq!((told.seen.step, told.by), (last.step, PlacementKind::Reference));
        let reference = SurfaceId(told.relative_to.unwrap());
        assert!(stored[reference.0 as usize].step < told.seen.step);
        assert!(told.recognised > 0);
        run.jump(told.seen.position as u64);
        assert!(run.facts(0, Thing::Surface(last.id)).is_some());
        run.jump(told.seen.position as u64 - 1);
        assert_eq!(run.facts(0, Thing::Surface(last.id)), None);
    }

    #[test]
    fn an_exit_and_the_spaces_beside_it_tell_the_same_story() {
        let run = two_rooms();
        let Some(Facts::Exit(exit)) = run.facts(0, Thing::Exit(ExitId(0))) else { panic!() };
        assert_eq!((exit.between, exit.crossings, exit.closed_loop), ([0, 1], 1, false));
        assert!((0.7..1.0).contains(&exit.width) && exit.last == exit.made);
        let Some(Facts::Asr(home)) = run.facts(0, Thing::Asr(AsrId(0))) else { panic!() };
        let Some(Facts::Asr(behind)) = run.facts(0, Thing::Asr(AsrId(1))) else { panic!() };
        assert_eq!((home.entered, home.last, home.behind, home.current), (0, None, None, false));
        assert_eq!((behind.entered, behind.last), (1, Some(exit.made)));
        assert_eq!((behind.opened, behind.behind, behind.loops), (exit.made, Some(0), 0));
        let all = run.session().mappers()[0].mfis().surfaces().len();
        assert_eq!(home.surfaces + behind.surfaces, all);
        assert!((15.0..33.0).contains(&home.area));
    }

    #[test]
    fn nothing_is_told_about_what_is_not_in_mind() {
        let run = two_rooms();
        for thing in [Thing::Surface(SurfaceId(9999)), Thing::Exit(ExitId(9)), Thing::Supposed(0)] {
            assert_eq!(run.facts(0, thing), None, "{thing:?}");
        }
        assert_eq!(run.facts(1, Thing::Asr(AsrId(0))), None);
        assert_eq!(run.facts(7, Thing::Surface(SurfaceId(0))), None);
    }
}
