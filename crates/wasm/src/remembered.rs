//! The things of a memory by the names that the page has for them, and the way from one to the next.

use cogmap_geometry::{DVec2, Metric};
use cogmap_mapping::{
    Mapper,
    memory::SurfaceId,
    places::{AsrId, ExitId},
};
use cogmap_scene::{Thing, segment_of, things_like};
use cogmap_simulation::Session;
use serde::{Deserialize, Serialize};
use tsify::Tsify;

/// A thing that a memory holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct Remembered {
    /// What it is.
    pub kind: RememberedKind,
    /// Its number in the map.
    pub number: u32,
}

/// What a memory holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum RememberedKind {
    /// A surface.
    Surface,
    /// An exit that the robot went through.
    Exit,
    /// An exit that it only saw.
    Supposed,
    /// A local space.
    Asr,
}

/// Where to go from one thing to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Walk {
    /// To the next newer one of its kind.
    Newer,
    /// To the next older one of its kind.
    Older,
    /// To the newest one of its kind.
    Newest,
    /// To the oldest one of its kind.
    Oldest,
    /// To the nearest one of the next kind.
    NextKind,
    /// To the nearest one of the kind before.
    KindBefore,
}

/// The kinds in the order in which one walks through them.
const KINDS: [RememberedKind; 4] =
    [RememberedKind::Surface, RememberedKind::Exit, RememberedKind::Supposed, RememberedKind::Asr];

impl From<Remembered> for Thing {
    fn from(Remembered { kind, number }: Remembered) -> Self {
        match kind {
            RememberedKind::Surface => Self::Surface(SurfaceId(number)),
            RememberedKind::Exit => Self::Exit(ExitId(number)),
            RememberedKind::Supposed => Self::Supposed(number as usize),
            RememberedKind::Asr => Self::Asr(AsrId(number)),
        }
    }
}

impl From<Thing> for Remembered {
    fn from(thing: Thing) -> Self {
        let (kind, number) = match thing {
            Thing::Surface(id) => (RememberedKind::Surface, id.0),
            Thing::Exit(id) => (RememberedKind::Exit, id.0),
            #[allow(clippy::cast_possible_truncation, reason = "no robot supposes that many exits")]
            Thing::Supposed(number) => (RememberedKind::Supposed, number as u32),
            Thing::Asr(id) => (RememberedKind::Asr, id.0),
        };
        Self { kind, number }
    }
}

/// The thing that a walk leads to; without one to begin at, the surface that is nearest to the robot.
pub(crate) fn walked(
    session: &Session,
    mapper: usize,
    from: Option<Remembered>,
    walk: Walk,
) -> Option<Thing> {
    let mind = session.mappers().get(mapper)?;
    let begin = from.and_then(|from| Some((from, segment_of(mind, from.into())?.midpoint())));
    let Some((from, here)) = begin else {
        let robot = mind.map_from_robot(session.odom_from_robot())?.position;
        return KINDS.into_iter().find_map(|kind| nearest(mind, kind, robot));
    };
    let like = things_like(mind, from.into());
    let at = like.partition_point(|thing| *thing < from.into());
    match walk {
        Walk::Newer => like.get(at + 1).or(like.last()).copied(),
        Walk::Older => like.get(at.saturating_sub(1)).copied(),
        Walk::Newest => like.last().copied(),
        Walk::Oldest => like.first().copied(),
        Walk::NextKind => others(from.kind, 1).find_map(|kind| nearest(mind, kind, here)),
        Walk::KindBefore => others(from.kind, KINDS.len() - 1).find_map(|kind| nearest(mind, kind, here)),
    }
}

/// The other kinds, and at last the same, each so many further on than the one before.
fn others(kind: RememberedKind, by: usize) -> impl Iterator<Item = RememberedKind> {
    let at = KINDS.iter().position(|other| *other == kind).unwrap_or(0);
    (1..=KINDS.len()).map(move |steps| KINDS[(at + steps * by) % KINDS.len()])
}

fn nearest(mind: &Mapper, kind: RememberedKind, to: DVec2) -> Option<Thing> {
    let like = things_like(mind, Remembered { kind, number: 0 }.into()).into_iter();
    let away = like.filter_map(|thing| Some((segment_of(mind, thing)?.midpoint().distance_from(to), thing)));
    away.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, thing)| thing)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::two_rooms::two_rooms;

    fn remembered(kind: RememberedKind, number: u32) -> Remembered {
        Remembered { kind, number }
    }

    #[test]
    fn a_walk_begins_at_the_robot_and_leads_through_all_kinds_and_numbers() {
        let run = two_rooms();
        let walk = |from, walk| walked(run.session(), 0, from, walk).map(Remembered::from);
        let begin = walk(None, Walk::Newer).unwrap();
        assert_eq!(begin.kind, RememberedKind::Surface);
        let older = walk(Some(begin), Walk::Older).unwrap();
        assert_eq!(walk(Some(older), Walk::Newer), Some(begin));
        let first = remembered(RememberedKind::Surface, 0);
        assert_eq!(walk(Some(first), Walk::Older), Some(first));
        assert_eq!(walk(Some(begin), Walk::Oldest), Some(first));
        let last = walk(Some(first), Walk::Newest).unwrap();
        assert_eq!(walk(Some(last), Walk::Newer), Some(last));
        assert!(last.number > first.number);
        let exit = walk(Some(begin), Walk::NextKind).unwrap();
        assert_eq!(exit, remembered(RememberedKind::Exit, 0));
        // The thesis's mapper supposes no exits.
        let asr = walk(Some(exit), Walk::NextKind).unwrap();
        assert_eq!(asr.kind, RememberedKind::Asr);
        assert_eq!(walk(Some(asr), Walk::NextKind).unwrap().kind, RememberedKind::Surface);
        assert_eq!(walk(Some(asr), Walk::KindBefore), Some(exit));
    }

    #[test]
    fn what_has_gone_is_left_for_what_is_near_and_who_knows_nothing_leads_nowhere() {
        let run = two_rooms();
        let gone = Some(remembered(RememberedKind::Exit, 99));
        assert!(matches!(walked(run.session(), 0, gone, Walk::Newer), Some(Thing::Surface(_))));
        assert_eq!(walked(run.session(), 7, None, Walk::Newer), None);
        let surface = walked(run.session(), 1, None, Walk::Newer).map(Remembered::from);
        let next = walked(run.session(), 1, surface, Walk::NextKind);
        assert!(matches!(next, Some(Thing::Surface(_))), "odometry knows nothing else");
    }
}
