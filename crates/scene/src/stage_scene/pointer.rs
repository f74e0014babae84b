use cogmap_geometry::{DVec2, Segment};
use cogmap_mapping::{
    Event, Mapper, Placement, StepReport,
    memory::SurfaceId,
    places::{AsrId, ExitId, outline},
};
use cogmap_navigation::Decision;
use cogmap_simulation::Session;

use super::{Stage, narrowest};
use crate::{Annotation, HomingMark, Item, PlaceMark, Role, Sample, Scene, Shape, world_scene};

/// How far the direction that odometry decided along is drawn to each side, metres.
const REACH: f64 = 2.0;

/// Draws over the picture of a memory what a stage of its latest step is about.
pub(super) struct Pointer<'a> {
    pub(super) scene: &'a mut Scene,
    pub(super) mind: &'a Mapper,
    pub(super) report: &'a StepReport,
}

impl Pointer<'_> {
    fn draw(&mut self, role: Role, shape: Shape) {
        self.scene.changing.push(Item::new(role, shape));
    }

    fn lines(&mut self, role: Role, lines: Vec<Segment>, text: &str) {
        if !lines.is_empty() {
            self.draw(role, Shape::Segments(lines));
            self.scene.explain(Sample::Line(role), text);
        }
    }

    /// Surfaces of the map.
    pub(super) fn stored(&mut self, role: Role, ids: &[SurfaceId], text: &str) {
        let mfis = self.mind.mfis();
        let stored = ids.iter().filter_map(|&id| mfis.get(id));
        let lines = stored.map(|stored| mfis.in_map(stored)).collect();
        self.lines(role, lines, text);
    }

    /// Surfaces of the view, where they lie in the map.
    fn seen(&mut self, role: Role, which: &[usize], text: &str) {
        let seen = which.iter().filter_map(|&index| self.report.view.surfaces.get(index));
        let lines = seen.map(|surface| self.report.map_from_robot * surface.segment).collect();
        self.lines(role, lines, text);
    }

    fn is_recognised(&self, index: usize) -> bool {
        self.report.matches.iter().any(|pair| pair.seen == index)
    }

    /// What the laser swept, as long as nothing else was swept since.
    pub(super) fn scan(&mut self, session: &Session) {
        let taken = session.journal().odometry.last().is_some_and(|last| last.t == self.report.t);
        if let (true, Some(scan)) = (taken, session.last_scan()) {
            self.scene.changing.extend(world_scene::laser(scan, self.report.map_from_robot));
            self.scene.explain(Sample::Area(Role::LaserFan), "what the laser sees");
        } else {
            self.surfaces();
        }
    }

    pub(super) fn surfaces(&mut self) {
        let robot = self.report.map_from_robot.position;
        let lines = self.report.view.surfaces.iter().map(|surface| {
            let Segment { a, b } = self.report.map_from_robot * surface.segment;
            Shape::Polyline(vec![a, robot, b])
        });
        let sights: Vec<Shape> = lines.collect();
        sights.into_iter().for_each(|sight| self.draw(Annotation::Sight.into(), sight));
        let all: Vec<usize> = (0..self.report.view.surfaces.len()).collect();
        self.seen(Annotation::Movement.into(), &all, "surface seen now");
    }

    pub(super) fn recognised(&mut self) {
        let known: Vec<SurfaceId> = self.report.matches.iter().map(|pair| pair.known).collect();
        let all = 0..self.report.view.surfaces.len();
        let (recognised, others): (Vec<usize>, Vec<usize>) =
            all.partition(|&index| self.is_recognised(index));
        self.stored(Role::ReferenceKnown, &known, "known before");
        self.seen(Annotation::Movement.into(), &recognised, "seen and recognised");
        self.seen(Annotation::Flaw.into(), &others, "seen, not recognised");
    }

    /// From where the robot took its last view to where this one was taken.
    pub(super) fn movement(&mut self) {
        let places: Vec<DVec2> = self
            .mind
            .path()
            .iter()
            .rev()
            .take(2)
            .map(|point| self.mind.mfis().place_of(point).position)
            .collect();
        if let [here, before] = places[..] {
            self.draw(Annotation::Movement.into(), Shape::Arrow(vec![before, here]));
            self.scene.explain(Sample::Arrow(Annotation::Movement.into()), "moved since the last view");
        }
    }

    pub(super) fn reference(&mut self) {
        let Some((best, others)) = self.report.references.split_first() else { return };
        let others: Vec<usize> = others.iter().map(|candidate| candidate.seen).collect();
        self.seen(Annotation::Known.into(), &others, "runner-up");
        self.pair(best.seen, best.known);
    }

    fn pair(&mut self, seen: usize, known: SurfaceId) {
        self.stored(Role::ReferenceKnown, &[known], "reference, known");
        self.seen(Role::ReferenceSeen, &[seen], "reference, seen");
    }

    pub(super) fn together(&mut self) {
        let known: Vec<SurfaceId> = self.report.matches.iter().map(|pair| pair.known).collect();
        self.stored(Role::ReferenceKnown, &known, "what the robot holds on to");
    }

    pub(super) fn open(&mut self) {
        if let Some(direction) = self.report.open {
            let robot = self.report.map_from_robot.position;
            let line = Segment::new(robot - direction * REACH, robot + direction * REACH);
            self.lines(Annotation::Measure.into(), vec![line], "left open");
        }
    }

    pub(super) fn placed(&mut self) {
        if let Some(best) = self.report.reference_target() {
            self.pair(best.seen, best.known);
        } else if self.report.placement == Placement::Consensus {
            self.together();
        }
        self.stored(Annotation::Added.into(), &self.report.placed.clone(), "new in the map");
    }

    pub(super) fn ignored(&mut self) {
        let mfis = self.mind.mfis();
        let placed = self.report.placed.iter().filter_map(|&id| Some(mfis.get(id)?.index_in_view));
        let placed: Vec<usize> = placed.collect();
        let ignored = (0..self.report.view.surfaces.len()).filter(|index| !placed.contains(index));
        let (known, others): (Vec<usize>, Vec<usize>) = ignored.partition(|&index| self.is_recognised(index));
        self.seen(Annotation::Known.into(), &known, "known already");
        self.seen(Annotation::Flaw.into(), &others, "left out");
    }

    pub(super) fn wideness(&mut self) {
        let Some(place) = &self.report.place else { return };
        let chords: Vec<Segment> = place.wideness.iter().map(|wideness| wideness.chord).collect();
        self.lines(Annotation::Sight.into(), chords, "how wide it was");
        if let Some(least) = narrowest(&place.wideness) {
            self.lines(Annotation::Measure.into(), vec![least.chord], "the narrowest");
        }
        if let Some(here) = place.wideness.last() {
            self.lines(Annotation::Movement.into(), vec![here.chord], "how wide it is here");
        }
    }

    pub(super) fn place(&mut self, stage: Stage) {
        let events = self.report.place.iter().flat_map(|place| place.events.clone());
        for event in events.collect::<Vec<_>>() {
            match (stage, event) {
                (Stage::Exit, Event::Exit { exit, .. }) => self.exit(exit),
                (Stage::NewAsr, Event::NewAsr { asr, exit, .. })
                | (Stage::LoopClosed, Event::LoopClosed { asr, exit, .. }) => {
                    self.floor(asr);
                    self.exit(exit);
                }
                _ => {}
            }
        }
    }

    fn exit(&mut self, exit: ExitId) {
        let Some(exit) = self.mind.network().and_then(|network| network.exit(exit)) else { return };
        let segment = self.mind.mfis().map_from_frame(exit.frame) * exit.segment;
        self.lines(Annotation::Measure.into(), vec![segment], "the exit");
    }

    fn floor(&mut self, asr: AsrId) {
        let Some(network) = self.mind.network() else { return };
        let Some(asr) = network.asrs().iter().find(|other| other.id == asr) else { return };
        let map_from_asr = self.mind.mfis().map_from_frame(asr.frame);
        let corners = outline(asr, network, self.mind.memory()).into_iter().map(|at| map_from_asr * at);
        self.draw(Role::Place(PlaceMark::Floor(asr.id.0)), Shape::Polygon(corners.collect()));
        self.stored(
            Role::Place(PlaceMark::Surface(asr.id.0)),
            network.surfaces_of(asr.id),
            "the local space",
        );
    }

    /// The movement options by number, or the one that was taken.
    pub(super) fn decision(&mut self, decision: &Decision, stage: Stage) {
        let Some(&robot) = decision.way.first() else { return };
        let begun = self.scene.changing.len();
        if stage == Stage::Choice {
            self.draw(HomingMark::Rim.into(), Shape::Polyline(decision.way.clone()));
            let next = decision.way.iter().take(2).copied().collect();
            self.draw(HomingMark::Chosen.into(), Shape::Arrow(next));
        }
        for (number, option) in (1..).zip(&decision.options).filter(|_| stage == Stage::Options) {
            let mark = if option.barred { HomingMark::Barred } else { HomingMark::Chosen };
            self.draw(mark.into(), Shape::Polyline(vec![robot, option.end]));
            let label = Shape::Label { at: option.end, text: number.to_string(), room: f64::INFINITY };
            self.draw(Annotation::Word.into(), label);
        }
        let map_from_here = self.mind.mfis().map_from_frame(decision.frame);
        self.scene.changing.iter_mut().skip(begun).for_each(|item| item.shape.carry(map_from_here));
    }
}
