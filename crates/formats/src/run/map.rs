use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::{
    PathPoint,
    memory::{Frame, Link, LinkKind, StoredSurface},
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
    exits: [(); 0],
    asrs: [(); 0],
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
struct PathRow {
    step: usize,
    t: f64,
    frame: u32,
    x: f64,
    y: f64,
    heading: f64,
    asr: Option<u32>,
}

/// The map of the mapper at `index` as a file; empty where there is no such mapper.
#[must_use]
pub fn map(session: &Session, index: usize) -> String {
    let (Some(setup), Some(mapper)) = (session.record().mappers.get(index), session.mappers().get(index))
    else {
        return String::new();
    };
    let true_walls = session.journal().mappers.get(index).map_or(&[][..], |journal| &journal.true_walls);
    let surfaces = mapper.mfis().surfaces().iter();
    let file = MapFile {
        format: "cogmap-map/1",
        mapper: setup.name(),
        frames: mapper.mfis().frames().iter().map(frame_row).collect(),
        links: mapper.mfis().links().iter().map(link_row).collect(),
        surfaces: surfaces
            .map(|surface| surface_row(surface, true_walls.get(surface.id.0 as usize).copied().flatten()))
            .collect(),
        exits: [],
        asrs: [],
        path: mapper.path().iter().map(path_row).collect(),
    };
    json::write_file(&file, 2)
}

fn triple(pose: Pose) -> [f64; 3] {
    [pose.position.x, pose.position.y, pose.heading]
}

fn frame_row(frame: &Frame) -> FrameRow {
    FrameRow { id: frame.id.0, map_from_frame: triple(frame.map_from_frame) }
}

fn link_row(link: &Link) -> LinkRow {
    let Link { from, to, from_from_to, step, kind } = *link;
    LinkRow { from: from.0, to: to.0, from_from_to: triple(from_from_to), step, kind }
}

fn surface_row(surface: &StoredSurface, true_wall: Option<u32>) -> SurfaceRow {
    let point = |point: DVec2| [point.x, point.y];
    SurfaceRow {
        id: surface.id.0,
        frame: surface.frame.0,
        a: point(surface.segment.a),
        b: point(surface.segment.b),
        step: surface.step,
        asr: None,
        true_wall,
    }
}

fn path_row(point: &PathPoint) -> PathRow {
    let pose = point.frame_from_robot;
    PathRow {
        step: point.step,
        t: point.t,
        frame: point.frame.0,
        x: pose.position.x,
        y: pose.position.y,
        heading: pose.heading,
        asr: None,
    }
}
