use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::{
    PathPoint,
    memory::{Frame, Link, LinkKind, Memory, StoredSurface, SurfaceId},
    places::{Asr, Exit, Network, outline},
};
use cogmap_simulation::Session;
use serde::Serialize;

use crate::json;

/// `map.json`: the network of frames, surfaces, exits, ASRs and the path, `cogmap-map/1`.
#[derive(Serialize)]
struct MapFile<'a> {
    format: &'static str,
    mapper: &'a str,
    frames: Vec<FrameRow>,
    links: Vec<LinkRow>,
    surfaces: Vec<SurfaceRow>,
    exits: Vec<ExitRow>,
    asrs: Vec<AsrRow>,
    path: Vec<PathRow>,
}

#[derive(Serialize)]
struct FrameRow {
    id: u32,
    map_from_frame: [f64; 3],
}

#[derive(Serialize)]
struct LinkRow {
    from: u32,
    to: u32,
    from_from_to: [f64; 3],
    step: usize,
    kind: LinkKind,
}

#[derive(Serialize)]
struct SurfaceRow {
    id: u32,
    frame: u32,
    a: [f64; 2],
    b: [f64; 2],
    step: usize,
    asr: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    true_wall: Option<u32>,
}

#[derive(Serialize)]
struct ExitRow {
    id: u32,
    frame: u32,
    a: [f64; 2],
    b: [f64; 2],
    between: [u32; 2],
    step: usize,
}

#[derive(Serialize)]
struct AsrRow {
    id: u32,
    frame: u32,
    /// Its own origin: the middle of the exit that it was first entered by, x into the space.
    entrance: [f64; 3],
    outline: Vec<[f64; 2]>,
    exits: Vec<u32>,
    merged_from: Vec<u32>,
}

#[derive(Serialize)]
struct PathRow {
    step: usize,
    t: f64,
    frame: u32,
    x: f64,
    y: f64,
    heading: f64,
    asr: Option<u32>,
}

/// The map of the mapper at `index` as a file: what it remembers, not what it forgot. Empty where there
/// is no such mapper.
#[must_use]
pub fn map(session: &Session, index: usize) -> String {
    let (Some(setup), Some(mapper)) = (session.record().mappers.get(index), session.mappers().get(index))
    else {
        return String::new();
    };
    let true_walls = session.journal().mappers.get(index).map_or(&[][..], |journal| &journal.true_walls);
    let (mfis, network) = (mapper.mfis(), mapper.network());
    let true_wall = |id: SurfaceId| true_walls.get(id.0 as usize).copied().flatten();
    let asr_of = |id| Some(network?.asr_of(id)?.0);
    let asr_at = |step| Some(network?.asr_at(step)?.0);
    let surfaces = mfis.remembered();
    let file = MapFile {
        format: "cogmap-map/1",
        mapper: setup.name(),
        frames: mfis.frames().iter().map(frame_row).collect(),
        links: mfis.links().iter().map(link_row).collect(),
        surfaces: surfaces.map(|it| surface_row(it, asr_of(it.id), true_wall(it.id))).collect(),
        exits: network.map_or(&[][..], Network::exits).iter().map(exit_row).collect(),
        asrs: network.map_or(Vec::new(), |network| asr_rows(network, mapper.memory())),
        path: mapper.path().iter().map(|point| path_row(point, asr_at(point.step))).collect(),
    };
    json::write_file(&file, 2)
}

fn triple(pose: Pose) -> [f64; 3] {
    [pose.position.x, pose.position.y, pose.heading]
}

fn pair(point: DVec2) -> [f64; 2] {
    [point.x, point.y]
}

fn frame_row(frame: &Frame) -> FrameRow {
    FrameRow { id: frame.id.0, map_from_frame: triple(frame.map_from_frame) }
}

fn link_row(link: &Link) -> LinkRow {
    let Link { from, to, from_from_to, step, kind } = *link;
    LinkRow { from: from.0, to: to.0, from_from_to: triple(from_from_to), step, kind }
}

fn asr_rows(network: &Network, memory: &Memory) -> Vec<AsrRow> {
    let row = |asr: &Asr| AsrRow {
        id: asr.id.0,
        frame: asr.frame.0,
        entrance: triple(asr.frame_from_entrance),
        outline: outline(asr, network, memory).into_iter().map(pair).collect(),
        exits: asr.exits.iter().map(|exit| exit.0).collect(),
        merged_from: asr.merged_from.iter().map(|asr| asr.0).collect(),
    };
    network.asrs().iter().map(row).collect()
}

fn exit_row(exit: &Exit) -> ExitRow {
    ExitRow {
        id: exit.id.0,
        frame: exit.frame.0,
        a: pair(exit.segment.a),
        b: pair(exit.segment.b),
        between: exit.between.map(|asr| asr.0),
        step: exit.step,
    }
}

fn surface_row(surface: &StoredSurface, asr: Option<u32>, true_wall: Option<u32>) -> SurfaceRow {
    SurfaceRow {
        id: surface.id.0,
        frame: surface.frame.0,
        a: pair(surface.segment.a),
        b: pair(surface.segment.b),
        step: surface.step,
        asr,
        true_wall,
    }
}

fn path_row(point: &PathPoint, asr: Option<u32>) -> PathRow {
    let pose = point.frame_from_robot;
    PathRow {
        step: point.step,
        t: point.t,
        frame: point.frame.0,
        x: pose.position.x,
        y: pose.position.y,
        heading: pose.heading,
        asr,
    }
}
