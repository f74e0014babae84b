//! Floor plans: a picture whose free parts are floor and everything else solid, as a ROS
//! `map_server` file describes it, or a plain picture and its scale.
//!
//! The outlines of the floor become walls: traced along the pixels' edges, then drawn with as few
//! straight pieces as stay within a pixel of them. Only the floor that a robot can reach from the
//! roomiest place is kept; what lies behind solid walls could never be seen.

mod floor;
mod graymap;
mod map_server;
mod outline;
mod picture;
mod simplify;
mod yaml;

use cogmap_geometry::{DVec2, Pose};
use cogmap_simulation::{BodyParams, Start, World};

use crate::{
    FormatError,
    error::{Place, tame},
    world::WORLD_FORMAT,
};
use floor::Floor;
pub use map_server::MapServer;
use outline::Contour;
pub use picture::Picture;

/// What the middle of the robot has around it at its start besides its own radius, metres.
const START_SPARE: f64 = 0.15;
/// The most straight pieces that a plan may become; a world takes no more.
const PIECES_MAX: usize = 100_000;
/// Coordinates are kept to this part of a metre.
const GRAINS: f64 = 1e6;

/// A world made from a floor plan, and what became of the plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Walls around the floor, and a start; no rooms, no routes.
    pub world: World,
    /// Width and height of the picture, metres.
    pub size: [f64; 2],
    /// Edge of a pixel, metres.
    pub resolution: f64,
    /// Floor that was kept, square metres.
    pub kept: f64,
    /// Floor that was left out because no way leads there, square metres.
    pub left_out: f64,
    /// Straight pieces of wall.
    pub pieces: usize,
}

impl Plan {
    /// Makes a world of a PNG or PGM picture. `name` is the plan's name for people, `file` the
    /// picture's for messages.
    ///
    /// # Errors
    /// [`FormatError`] where the picture cannot be read, or holds no floor for a robot.
    pub fn trace(picture: &[u8], map: &MapServer, name: &str, file: &str) -> Result<Self, FormatError> {
        let picture = Picture::read(picture, file)?;
        let size = [picture.width, picture.height].map(|pixels| pixels as f64 * map.resolution);
        let mut floor = Floor::of(&picture, map);
        let robot = (BodyParams::default().radius + START_SPARE) / map.resolution;
        let start = floor.roomiest(robot).ok_or_else(|| nowhere(&floor, size, file))?;
        let before = floor.free_pixels();
        floor.keep_around(start);
        let contours = outline::contours(&floor).ok_or_else(|| too_intricate(file))?;
        let lines: Option<Vec<Contour>> = simplify::all(&contours, PIECES_MAX);
        let lines = lines.ok_or_else(|| too_intricate(file))?;
        let pieces = lines.iter().map(|line| line.len() - 1).sum();
        let square = map.resolution * map.resolution;
        let area = |pixels: usize| pixels as f64 * square;
        let world = world(&lines, start, map, (name, picture.height));
        if let Some(problem) = world.problems().into_iter().next() {
            let problem = format!("it cannot be simulated: {} {}", problem.place, problem.message);
            return Err(unusable(file, problem, "check the resolution and the origin"));
        }
        let (kept, left_out) = (area(floor.free_pixels()), area(before - floor.free_pixels()));
        Ok(Self { world, size, resolution: map.resolution, kept, left_out, pieces })
    }
}

/// The lines in the map's frame, whose origin is the pose of the picture's lower left corner.
fn world(lines: &[Contour], start: [usize; 2], map: &MapServer, (name, rows): (&str, usize)) -> World {
    let [x, y, heading] = map.origin;
    let map_from_picture = Pose::new(x, y, heading);
    let place = |[column, row]: [f64; 2]| {
        let point = map_from_picture * (DVec2::new(column, rows as f64 - row) * map.resolution);
        ((point * GRAINS).round() / GRAINS).to_array()
    };
    let corner = |&[column, row]: &[u32; 2]| place([f64::from(column), f64::from(row)]);
    World {
        schema: None,
        format: WORLD_FORMAT.to_owned(),
        name: tame(name),
        description: format!("A floor plan, {} m a pixel; what is not free in it is solid.", map.resolution),
        walls: lines.iter().map(|line| line.iter().map(corner).collect()).collect(),
        boxes: Vec::new(),
        posts: Vec::new(),
        doors: Vec::new(),
        people: Vec::new(),
        start: Start { position: place(start.map(|cell| cell as f64 + 0.5)), heading_deg: 0.0 },
        routes: std::collections::BTreeMap::new(),
        rooms: Vec::new(),
    }
}

/// A picture that cannot be a world, and the way out.
pub(crate) fn unusable(file: &str, problem: impl Into<String>, remedy: &'static str) -> FormatError {
    FormatError::Picture { place: Place::file(file), problem: problem.into(), remedy }
}

fn nowhere(floor: &Floor, [width, height]: [f64; 2], file: &str) -> FormatError {
    let share = 100.0 * floor.free_pixels() as f64 / floor.pixels() as f64;
    let problem = format!(
        "nowhere in its {width:.1} m by {height:.1} m is there floor enough for a robot; {share:.0} % of it is free"
    );
    unusable(file, problem, "check the resolution, whether free is white (`negate`), and `free_thresh`")
}

fn too_intricate(file: &str) -> FormatError {
    let problem = format!("its outlines need more than {PIECES_MAX} straight pieces");
    unusable(file, problem, "clean the picture of noise, or make it smaller and the resolution larger")
}

#[cfg(test)]
mod tests;
