use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{
    Mapper, StepReport,
    memory::StoredSurface,
    places::{Exit, Network},
};
use cogmap_scene::{Annotation, Item, PlaceMark, Role, Sample, Shape};

use super::{
    Drawing, Runs,
    draw::{dashed, lines, panel, robot, role, word},
    maps::{map_of, one},
    outings::SIDE_ROOM,
    runs::Run,
};

const MAPPER: &str = "perceptual";

/// The robot's view of things when it has just gone through an exit.
struct Crossed<'a> {
    run: &'a Run,
    mapper: &'a Mapper,
    network: &'a Network,
    exit: &'a Exit,
}

/// Fig. 3.15.
pub(super) fn across_the_exit(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&SIDE_ROOM)?;
    let (mapper, journal) = run.mind(MAPPER)?;
    let network = mapper.network().ok_or("this mapper knows no local spaces")?;
    let Some(exit) = network.exits().first() else {
        let outcome = "In this run no exit was found.".to_owned();
        return Ok(one(map_of(&run, MAPPER), outcome, format!("the perceptual mapper, {}", run.words())));
    };
    let crossed = Crossed { run: &run, mapper, network, exit };
    let view = |step: usize| journal.reports.get(step).ok_or("the robot took no such view");
    let (before, after) = (view(exit.crossed)?, view(exit.step)?);
    let moved = crossed.known_then(after).filter(|surface| crossed.is_behind(surface));
    let moved = moved.filter(|surface| surface.step <= exit.crossed).count();
    let kept = crossed.beyond_the_line(after).count();
    Ok(Drawing {
        panels: vec![panel("", crossed.items(before, after), &legend(exit))],
        columns: 1,
        outcome: format!(
            "Here {moved} surfaces that were seen through the exit go over to the new space; {kept} that lie \
             beyond the exit’s line, but were not seen through it, stay."
        ),
        source: format!("the perceptual mapper, {}", run.words()),
    })
}

fn legend(exit: &Exit) -> [(Sample, &'static str); 7] {
    let [old, new] = exit.between.map(|asr| Sample::Line(Role::Place(PlaceMark::Surface(asr.0))));
    [
        (Sample::Robot(Role::BelievedRobot), "R1, before the exit"),
        (Sample::Robot(Role::Robot), "R2, behind it"),
        (old, "stays with the old space"),
        (new, "belongs to the new space"),
        (Sample::Exit, "exit"),
        (Sample::Line(role(Annotation::Sight)), "line of sight through the exit"),
        (Sample::Line(Role::Truth), "the world"),
    ]
}

impl Crossed<'_> {
    fn place(&self, report: &StepReport) -> Pose {
        self.run.world_from_map() * report.map_from_robot
    }

    /// In the world.
    fn exit(&self) -> Segment {
        self.run.world_from_map() * (self.mapper.mfis().map_from_frame(self.exit.frame) * self.exit.segment)
    }

    fn line(&self, surface: &StoredSurface) -> Segment {
        self.run.world_from_map() * self.mapper.mfis().in_map(surface)
    }

    /// What was in the map when a view had been taken in.
    fn known_then(&self, report: &StepReport) -> impl Iterator<Item = &StoredSurface> {
        let step = report.step;
        self.mapper.mfis().surfaces().iter().filter(move |surface| surface.step <= step)
    }

    fn is_behind(&self, surface: &StoredSurface) -> bool {
        self.network.asr_of(surface.id) == Some(self.exit.between[1])
    }

    /// What stays although it lies beyond the infinite line through the exit.
    fn beyond_the_line(&self, report: &StepReport) -> impl Iterator<Item = &StoredSurface> {
        let exit = self.exit();
        let beyond = move |surface: &&StoredSurface| {
            exit.offset_of(self.line(surface).midpoint()).is_some_and(|offset| offset > 0.0)
        };
        self.known_then(report).filter(|surface| !self.is_behind(surface)).filter(beyond)
    }

    fn items(&self, before: &StepReport, after: &StepReport) -> Vec<Item> {
        let (r1, r2) = (self.place(before), self.place(after));
        let exit = self.exit();
        let behind: Vec<&StoredSurface> =
            self.known_then(after).filter(|surface| self.is_behind(surface)).collect();
        let seen_before = behind.iter().filter(|surface| surface.step <= self.exit.crossed);
        let sights = seen_before.map(|surface| Segment::new(r1.position, self.line(surface).midpoint()));
        let through = sights.filter(|sight| sight.crossing(exit).is_some());
        let along = exit.direction().unwrap_or(DVec2::Y) * 2.2;
        let infinite = Segment::new(exit.a - along, exit.b + along);
        let [old, new] = self.exit.between.map(|asr| Role::Place(PlaceMark::Surface(asr.0)));
        let stays = self.known_then(after).filter(|surface| !self.is_behind(surface));
        let below = DVec2::new(0.0, 0.45);
        let mark = |mark: PlaceMark, shape: Shape| Item::new(Role::Place(mark), shape);
        vec![
            lines(role(Annotation::Axis), dashed(infinite, 0.15)),
            lines(Role::Truth, self.run.session.solids().iter().flat_map(|solids| solids.segments.clone())),
            lines(old, stays.map(|surface| self.line(surface))),
            lines(new, behind.iter().map(|surface| self.line(surface))),
            mark(PlaceMark::ExitRim, Shape::Segments(vec![exit])),
            lines(role(Annotation::Sight), through),
            mark(PlaceMark::Exit, Shape::Segments(vec![exit])),
            mark(PlaceMark::Exit, Shape::Signs(vec![exit.a, exit.b])),
            robot(Role::BelievedRobot, r1),
            robot(Role::Robot, r2),
            word(r1.position - below, "R1"),
            word(r2.position - below, "R2"),
        ]
    }
}
