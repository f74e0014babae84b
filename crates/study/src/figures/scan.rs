use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::perception::{Extraction, Surface, extract};
use cogmap_scene::{Annotation, Role, Sample};

use super::{
    Drawing, Runs,
    draw::{self, hits, panel, ring, robot, role, word},
    stage::Stage,
};

/// A room with a desk, a cupboard and a swivel chair on a star of five feet.
const ROOM: &str = r#"{"format": "cogmap-world/1", "name": "Room with a chair", "start": {"position": [1, 1]},
    "walls": [[[3.2, 0], [0, 0], [0, 4.4], [4.2, 4.4], [4.2, 5.6], [5.2, 5.6], [5.2, 4.4], [7, 4.4], [7, 0], [4.2, 0]]],
    "boxes": [{"center": [0.3, 2.6], "size": [0.6, 1.2]}, {"center": [1.9, 4.1], "size": [1.2, 0.6]},
        {"center": [6.7, 2.9], "size": [0.6, 1.0], "heading_deg": 0},
        {"center": [5.55, 1.55], "size": [0.34, 0.04], "heading_deg": 17},
        {"center": [5.43, 1.73], "size": [0.34, 0.04], "heading_deg": 89},
        {"center": [5.22, 1.66], "size": [0.34, 0.04], "heading_deg": 161},
        {"center": [5.22, 1.44], "size": [0.34, 0.04], "heading_deg": 233},
        {"center": [5.43, 1.37], "size": [0.34, 0.04], "heading_deg": 305}]}"#;
const PLACE: Pose = Pose { position: DVec2::new(3.2, 1.2), heading: 1.1 };
/// Surfaces below this are debris, metres.
const DEBRIS: f64 = 0.4;
/// Debris belongs together within this, metres.
const TOGETHER: f64 = 0.45;

/// Fig. 3.1.
pub(super) fn surfaces(_: &mut Runs) -> Result<Drawing, String> {
    let stage = Stage::new(ROOM)?;
    let place = PLACE;
    let scan = stage.scan(place)?;
    let view = extract(&scan, &Extraction::default());
    let (debris, long): (Vec<&Surface>, Vec<&Surface>) =
        view.surfaces.iter().partition(|surface| surface.length() < DEBRIS);
    let mut items = vec![
        draw::surfaces(role(Annotation::Added), place, long.iter().copied()),
        draw::surfaces(role(Annotation::Measure), place, debris.iter().copied()),
        hits(&scan, place),
        robot(Role::Robot, place),
        word(place.position - DVec2::new(0.0, 0.5), "R"),
    ];
    items.extend(cluster(&debris).map(|(center, radius)| ring(place * center, radius)));
    let legend = [
        (Sample::Robot(Role::Robot), "R, the robot"),
        (Sample::Sign(Role::LaserHit), "point that the laser hit"),
        (Sample::Line(role(Annotation::Added)), "surface"),
        (Sample::Line(role(Annotation::Measure)), "surface below 0.4 m: debris"),
    ];
    let points = (0..scan.ranges.len()).filter(|&beam| scan.range(beam).is_some()).count();
    Ok(Drawing {
        panels: vec![panel("", items, &legend)],
        columns: 1,
        outcome: format!(
            "Here {points} points give {} surfaces, {} of them debris.",
            view.surfaces.len(),
            debris.len()
        ),
        source: "one scan of a robot without errors in a room made for it".to_owned(),
    })
}

/// Where most debris lies together.
fn cluster(debris: &[&Surface]) -> Option<(DVec2, f64)> {
    let middle = |surface: &&Surface| surface.segment.midpoint();
    let around = |at: DVec2| debris.iter().filter(move |other| middle(other).distance(at) <= TOGETHER);
    let densest = debris.iter().max_by_key(|surface| around(middle(surface)).count())?;
    let members: Vec<DVec2> = around(middle(densest)).flat_map(|s| [s.segment.a, s.segment.b]).collect();
    let center = members.iter().fold(DVec2::ZERO, |sum, &point| sum + point) / members.len() as f64;
    let radius = members.iter().map(|point| point.distance(center)).fold(0.0, f64::max);
    Some((center, radius + 0.3))
}
