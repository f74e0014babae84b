//! Where in an old place could the robot be, when it does not know at all?

use cogmap_geometry::{DVec2, Metric, Pose, normalize_angle, trig};
use serde::{Deserialize, Serialize};

use super::{known::Known, line::Line, search};

/// How a lost robot looks for any place that it knows: two walls of the view that meet at an angle are
/// laid onto two remembered ones that meet at the same.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Relocation {
    /// Old frames looked into per view.
    pub frames: u32,
    /// Shorter walls are not laid onto each other, metres.
    pub wall: f64,
    /// Pairs of walls of the view that are tried, the longest first.
    pub corners: usize,
    /// Pairs meet at the same angle within this, radians.
    pub angle: f64,
    /// The robot is looked for within this of the frame's origin, metres.
    pub radius: f64,
    /// So many of the most promising places are followed up.
    pub followed: usize,
    /// A hypothesis begins when this share of a view fits …
    pub begin_fraction: f64,
    /// … and so many metres of it do.
    pub begin_length: f64,
    /// It is believed when this share of the views fitted in the mean …
    pub believe_fraction: f64,
    /// … over so many views …
    pub believe_views: u32,
    /// … and so many metres of the way …
    pub believe_way: f64,
    /// … of which no more than this share of the beams contradicts what was seen free there …
    pub contradiction: f64,
    /// … and no other place fits almost as well, less than this share worse …
    pub lead: f64,
    /// … when at least so many of the old frames have been looked into.
    pub examined: u32,
    /// So many places are followed at a time.
    pub rivals: usize,
}

impl Default for Relocation {
    fn default() -> Self {
        Self {
            frames: 3,
            wall: 0.6,
            corners: 4,
            angle: 6.0 * trig::PI / 180.0,
            radius: 5.0,
            followed: 5,
            begin_fraction: 0.6,
            begin_length: 3.5,
            believe_fraction: 0.7,
            believe_views: 8,
            believe_way: 4.0,
            contradiction: 0.1,
            lead: 0.1,
            examined: 60,
            rivals: 6,
        }
    }
}

/// Two walls and the point where their lines meet.
struct Corner<'a> {
    walls: [&'a Line; 2],
    at: DVec2,
    /// From the first to the second, radians.
    turn: f64,
}

impl<'a> Corner<'a> {
    fn of(first: &'a Line, second: &'a Line) -> Option<Self> {
        let cross = first.along.perp_dot(second.along);
        if cross.abs() < 0.5 {
            return None;
        }
        let at = first.point((second.a - first.a).perp_dot(second.along) / cross);
        Some(Self { walls: [first, second], at, turn: normalize_angle(second.heading - first.heading) })
    }

    /// Where the robot is if its corner is this one.
    fn frame_from_robot(&self, seen: &Self) -> Pose {
        let [first, second] =
            [0, 1].map(|wall| normalize_angle(self.walls[wall].heading - seen.walls[wall].heading));
        let turn = Pose::new(0.0, 0.0, first + normalize_angle(second - first) / 2.0);
        let position = self.at - turn.rotate(seen.at);
        Pose::new(position.x, position.y, turn.heading)
    }

    /// Whether both walls, placed so, lie beside these for a good part.
    fn holds(&self, seen: &Self, pose: Pose, params: &Relocation) -> bool {
        self.walls.iter().zip(seen.walls).all(|(known, seen)| {
            let placed = seen.seen_from(pose);
            let beside = placed.beside(known).map_or(0.0, |(from, to)| to - from);
            beside >= 0.5 * placed.length.min(known.length) && beside >= 0.5 * params.wall
        })
    }
}

/// The places where most of the view would lie on remembered lines, best first.
pub(super) fn guesses(view: &[Line], known: &Known, params: &Relocation) -> Vec<Pose> {
    let walls: Vec<&Line> = known.all().filter(|line| line.length >= params.wall).collect();
    let mut guesses: Vec<(f64, Pose)> = Vec::new();
    for seen in corners_of(view, params) {
        for first in &walls {
            let corners = known.facing(first.heading + seen.turn, params.angle);
            for corner in corners
                .filter(|second| second.length >= params.wall)
                .filter_map(|second| Corner::of(first, second))
            {
                if normalize_angle(corner.turn - seen.turn).abs() > params.angle {
                    continue;
                }
                let pose = corner.frame_from_robot(&seen);
                if pose.position.norm() <= params.radius && corner.holds(&seen, pose, params) {
                    guesses.push((search::beside(view, known, pose, (0.2, params.angle)), pose));
                }
            }
        }
    }
    guesses.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut apart: Vec<Pose> = Vec::new();
    for (_, pose) in guesses {
        if apart.len() < params.followed && !apart.iter().any(|other| same_place(*other, pose)) {
            apart.push(pose);
        }
    }
    apart
}

/// Whether two poses are one place, but for errors.
pub(super) fn same_place(first: Pose, second: Pose) -> bool {
    let apart = first.from_here(second);
    apart.position.norm() < 0.5 && apart.heading.abs() < 0.2
}

fn corners_of<'a>(view: &'a [Line], params: &Relocation) -> Vec<Corner<'a>> {
    let walls = view.iter().enumerate().filter(|(_, line)| line.length >= params.wall);
    let walls: Vec<(usize, &Line)> = walls.collect();
    let pairs = walls.iter().flat_map(|(index, first)| {
        walls
            .iter()
            .filter(move |(other, _)| other > index)
            .filter_map(|(_, second)| Corner::of(first, second))
    });
    let mut corners: Vec<Corner<'a>> = pairs.collect();
    let size = |corner: &Corner<'_>| corner.walls[0].length.min(corner.walls[1].length);
    corners.sort_by(|a, b| size(b).total_cmp(&size(a)));
    corners.truncate(params.corners);
    corners
}
