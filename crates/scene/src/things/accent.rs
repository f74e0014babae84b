use cogmap_geometry::{DVec2, Segment};
use cogmap_mapping::{
    Mapper,
    memory::StoredSurface,
    places::{Asr, AsrId, Network},
};
use cogmap_simulation::Session;

use super::{Thing, floor, segment_of};
use crate::{Annotation, Item, PlaceMark, Role, Scene, Shape, network_scene::placed};

/// Sets a thing off from the rest of the picture of a mapper's memory, with what belongs to its story: from
/// where a surface was first seen and relative to what it was placed, or what a local space holds. Only the
/// changing part of the scene is added to, and nothing to its legend, so that the picture stands still.
pub fn set_off(scene: &mut Scene, session: &Session, mapper: usize, thing: Thing) {
    let Some(mind) = session.mappers().get(mapper) else { return };
    let Some(segment) = segment_of(mind, thing) else { return };
    let mut accent = Accent { scene, mind };
    match thing {
        Thing::Surface(id) => {
            if let Some(stored) = mind.mfis().get(id) {
                accent.sight(stored, segment);
                accent.reference(session, mapper, stored);
            }
            accent.lines(&[segment]);
        }
        Thing::Exit(_) | Thing::Supposed(_) => {
            accent.lines(&[segment]);
            accent.draw(Annotation::Pointed, Shape::Signs(vec![segment.a, segment.b]));
        }
        Thing::Asr(id) => accent.asr(id, segment.a),
    }
}

struct Accent<'a> {
    scene: &'a mut Scene,
    mind: &'a Mapper,
}

impl Accent<'_> {
    fn draw(&mut self, role: impl Into<Role>, shape: Shape) {
        self.scene.changing.push(Item::new(role.into(), shape));
    }

    fn lines(&mut self, lines: &[Segment]) {
        self.draw(Annotation::PointedRim, Shape::Segments(lines.to_vec()));
        self.draw(Annotation::Pointed, Shape::Segments(lines.to_vec()));
    }

    /// From where a surface was first seen.
    fn sight(&mut self, stored: &StoredSurface, Segment { a, b }: Segment) {
        if let Some(point) = self.mind.path().get(stored.step) {
            let from = self.mind.mfis().place_of(point).position;
            self.draw(Annotation::Sight, Shape::Polyline(vec![a, from, b]));
        }
    }

    /// What a surface was placed relative to.
    fn reference(&mut self, session: &Session, mapper: usize, stored: &StoredSurface) {
        let reports = session.journal().mappers.get(mapper).map(|journal| &journal.reports);
        let known = reports.and_then(|reports| reports.get(stored.step)?.reference_target());
        let known = known.and_then(|best| self.mind.mfis().get(best.known));
        let line = known.map(|known| self.mind.mfis().in_map(known));
        self.scene
            .changing
            .extend(line.map(|line| Item::new(Role::ReferenceKnown, Shape::Segments(vec![line]))));
    }

    fn asr(&mut self, id: AsrId, node: DVec2) {
        let Some(network) = self.mind.network() else { return };
        let Some(asr) = network.asr(id) else { return };
        self.draw(Role::Place(PlaceMark::Floor(asr.id.0)), Shape::Polygon(floor(self.mind, asr)));
        let own = self.own(network, asr);
        self.draw(Annotation::PointedRim, Shape::Segments(own.clone()));
        self.draw(PlaceMark::Surface(asr.id.0), Shape::Segments(own));
        let exits = asr.exits.iter().filter_map(|id| network.exit(*id));
        for exit in exits.map(|exit| placed(exit, self.mind)).collect::<Vec<_>>() {
            self.draw(PlaceMark::ExitRim, Shape::Segments(vec![exit]));
            self.draw(PlaceMark::Exit, Shape::Segments(vec![exit]));
            self.draw(PlaceMark::Exit, Shape::Signs(vec![exit.a, exit.b]));
        }
        self.draw(PlaceMark::Node(asr.id.0), Shape::Signs(vec![node]));
        let label = Shape::Label { at: node, text: asr.id.0.to_string(), room: f64::INFINITY };
        self.draw(PlaceMark::Number, label);
    }

    /// The surfaces of a local space.
    fn own(&self, network: &Network, asr: &Asr) -> Vec<Segment> {
        let mfis = self.mind.mfis();
        let own = network.surfaces_of(asr.id).iter().filter(|id| mfis.remembers(**id));
        own.filter_map(|id| Some(mfis.in_map(mfis.get(*id)?))).collect()
    }
}

impl From<PlaceMark> for Role {
    fn from(mark: PlaceMark) -> Self {
        Self::Place(mark)
    }
}

#[cfg(test)]
mod tests {
    use cogmap_mapping::{memory::SurfaceId, places::ExitId};

    use super::*;
    use crate::{MemoryOptions, memory_scene, network_scene::tests::session};

    fn accented(thing: Thing) -> (Scene, Scene) {
        let session = session("consensus");
        let plain = memory_scene(&session, 0, MemoryOptions::default());
        let mut scene = plain.clone();
        set_off(&mut scene, &session, 0, thing);
        (plain, scene)
    }

    #[test]
    fn the_still_picture_and_its_legend_stay_as_they_are() {
        for thing in [Thing::Surface(SurfaceId(2)), Thing::Exit(ExitId(0)), Thing::Asr(AsrId(0))] {
            let (plain, scene) = accented(thing);
            assert_eq!((&plain.still, &plain.legend), (&scene.still, &scene.legend), "{thing:?}");
            assert!(scene.changing.len() > plain.changing.len(), "{thing:?}");
        }
        let (plain, scene) = accented(Thing::Surface(SurfaceId(9999)));
        assert_eq!(plain, scene);
    }

    #[test]
    fn a_local_space_is_set_off_with_its_floor_and_all_its_surfaces() {
        let session = session("consensus");
        let own = session.mappers()[0].network().unwrap().surfaces_of(AsrId(0)).len();
        let (_, scene) = accented(Thing::Asr(AsrId(0)));
        let lines = scene.changing.iter().find_map(|item| match &item.shape {
            Shape::Segments(lines) if item.role == PlaceMark::Surface(0).into() => Some(lines.len()),
            _ => None,
        });
        assert_eq!(lines, Some(own));
        assert!(scene.changing.iter().any(|item| item.role == PlaceMark::Floor(0).into()));
    }
}
