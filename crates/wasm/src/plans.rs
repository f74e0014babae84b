//! Floor plans that somebody brings: a picture and its scale, or a picture and the `map_server` file that says it.

use cogmap_formats::{
    Kind, gzip,
    plan::{MapServer, Picture, Plan},
};
use cogmap_simulation::{BodyParams, World};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsError, prelude::wasm_bindgen};

use crate::{failure::Failure, opening::text, setup::Opening};

/// A picture that may be a floor plan, to be looked at before its scale is known.
#[wasm_bindgen]
pub struct FloorPlan {
    name: String,
    plain: Vec<u8>,
    picture: Picture,
    shown: Picture,
}

/// What a floor plan becomes at a scale.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct PlanReport {
    /// Width and height of the whole picture, metres.
    pub size: [f64; 2],
    /// Floor that the robot can reach, square metres.
    pub floor: f64,
    /// Floor to which no way leads, square metres.
    pub left_out: f64,
    /// Where the robot begins, as shares of the picture's width and height from its upper left corner.
    pub start: [f64; 2],
    /// The robot's radius, as a share of the picture's width.
    pub robot: f64,
}

#[wasm_bindgen]
impl FloorPlan {
    /// Reads a picture; what is shown of it has at most `side` pixels to a side.
    ///
    /// # Errors
    /// What is no picture that can be read, and the way out.
    #[wasm_bindgen(constructor)]
    pub fn new(name: String, bytes: &[u8], side: usize) -> Result<Self, JsError> {
        Ok(Self::read(name, bytes, side)?)
    }

    /// Pixels.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn width(&self) -> usize {
        self.picture.width
    }

    /// Pixels.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn height(&self) -> usize {
        self.picture.height
    }

    /// Pixels in a row of what is shown.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn columns(&self) -> usize {
        self.shown.width
    }

    /// What is shown: from 0, black, to 255, row by row from the top.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn shades(&self) -> Vec<u8> {
        self.shown.brightness.clone()
    }

    /// What becomes of it where a pixel is so many metres.
    ///
    /// # Errors
    /// Why it cannot be a building at that scale, and the way out.
    pub fn measure(&self, resolution: f64) -> Result<Ts<PlanReport>, JsError> {
        Ok(self.report(resolution)?.into_ts()?)
    }
}

impl FloorPlan {
    fn read(name: String, bytes: &[u8], side: usize) -> Result<Self, Failure> {
        let plain = gzip::unpack(bytes, &name)?.into_owned();
        let picture = Picture::read(&plain, &name)?;
        let shown = picture.at_most(side);
        Ok(Self { name, plain, picture, shown })
    }

    fn report(&self, resolution: f64) -> Result<PlanReport, Failure> {
        let plan = of_picture(&self.plain, &self.name, resolution)?;
        let Plan { world, size: [width, height], kept, left_out, .. } = plan;
        let [x, y] = world.start.position;
        Ok(PlanReport {
            size: [width, height],
            floor: kept,
            left_out,
            start: [x / width, 1.0 - y / height],
            robot: BodyParams::default().radius / width,
        })
    }
}

/// The building that a floor plan shows. `other` is the file beside it: the picture's description or its picture.
pub(crate) fn building(opening: &Opening, plain: &[u8], other: Option<&[u8]>) -> Result<World, Failure> {
    let name = &opening.name;
    let Some(other) = other else {
        return match (Kind::of(plain), opening.resolution) {
            (Kind::Picture, Some(resolution)) => Ok(of_picture(plain, name, resolution)?.world),
            (Kind::Picture, None) => Err(Failure::new(&format!(
                "{name}: a picture does not say how large its building is; bring its map_server YAML as well, or \
                 the picture alone and say how many metres a pixel is"
            ))),
            _ => {
                let image = MapServer::read(text(plain, name)?, name)?.image;
                Err(Failure::new(&format!("{name}: describes the picture {image}; bring both files at once")))
            }
        };
    };
    let beside = opening.beside.as_deref().unwrap_or("the other file");
    let other = gzip::unpack(other, beside)?;
    match (Kind::of(plain), Kind::of(&other)) {
        (Kind::MapServer, Kind::Picture) => described((plain, name), (&other, beside)),
        (Kind::Picture, Kind::MapServer) => described((&other, beside), (plain, name)),
        _ => Err(Failure::new(&format!(
            "{name} and {beside}: a floor plan is one picture, alone or with the map_server YAML that describes it"
        ))),
    }
}

fn of_picture(plain: &[u8], name: &str, resolution: f64) -> Result<Plan, Failure> {
    let [least, most] = MapServer::RESOLUTIONS;
    if !(least..=most).contains(&resolution) {
        return Err(Failure::new(&format!("{name}: a pixel can have from {least} m to {most} m")));
    }
    Ok(Plan::trace(plain, &MapServer::of_picture(name, resolution), stem(name), name)?)
}

fn described((yaml, file): (&[u8], &str), (picture, name): (&[u8], &str)) -> Result<World, Failure> {
    let map = MapServer::read(text(yaml, file)?, file)?;
    let meant = map.image.rsplit(['/', '\\']).next().unwrap_or_default();
    if meant != name {
        return Err(Failure::new(&format!(
            "{file}: describes the picture {meant}, not {name}; bring that picture, or correct `image` in {file}"
        )));
    }
    Ok(Plan::trace(picture, &map, stem(file), name)?.world)
}

/// What a building is called that came from a file.
fn stem(file: &str) -> &str {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A room of 9 m by 5 m at 0.1 m a pixel, walls one pixel thick.
    fn room() -> Vec<u8> {
        let mut picture = b"P5 90 50 255\n".to_vec();
        picture.extend((0..50).flat_map(|row| {
            (0..90).map(move |column| if row % 49 == 0 || column % 89 == 0 { 0 } else { 255_u8 })
        }));
        picture
    }

    fn opening(name: &str, beside: Option<&str>, resolution: Option<f64>) -> Opening {
        let beside = beside.map(str::to_owned);
        Opening { name: name.into(), robot: "bad".into(), mappers: Vec::new(), seed: 1, resolution, beside }
    }

    const YAML: &[u8] = b"image: maps/room.pgm\nresolution: 0.1\norigin: [-1, -2, 0]\n";

    #[test]
    fn a_picture_is_shown_and_measured_before_it_is_opened() {
        let plan = FloorPlan::read("room.pgm".into(), &room(), 45).unwrap();
        assert_eq!((plan.width(), plan.height(), plan.columns()), (90, 50, 45));
        assert_eq!(plan.shades().len(), 45 * 25);
        let report = plan.report(0.1).unwrap();
        assert_eq!(report.size, [9.0, 5.0]);
        assert!((report.floor - 8.8 * 4.8).abs() < 1e-9 && report.left_out == 0.0);
        assert!(report.start.iter().all(|share| (0.2..0.8).contains(share)));
        assert!(plan.report(0.001).unwrap_err().to_string().contains("floor enough"));
        assert!(plan.report(f64::NAN).unwrap_err().to_string().contains("from 0.001 m to 10 m"));
        assert!(FloorPlan::read("a.log".into(), b"FLASER", 45).is_err());
    }

    #[test]
    fn picture_and_description_open_in_either_order() {
        let (one, other) =
            (opening("room.pgm", Some("room.yaml"), None), opening("room.yaml", Some("room.pgm"), None));
        let world = building(&one, &room(), Some(YAML)).unwrap();
        assert_eq!(world.name, "room");
        assert_eq!(building(&other, YAML, Some(&room())).unwrap(), world);
        let corner = world
            .walls
            .iter()
            .flatten()
            .fold([f64::INFINITY; 2], |low, p| [low[0].min(p[0]), low[1].min(p[1])]);
        assert!((corner[0] + 0.9).abs() < 0.11 && (corner[1] + 1.9).abs() < 0.11, "{corner:?}");
    }

    #[test]
    fn what_is_missing_is_named() {
        let told = |opening: Opening, plain: &[u8], other: Option<&[u8]>| {
            building(&opening, plain, other).unwrap_err().to_string()
        };
        assert!(told(opening("room.pgm", None, None), &room(), None).contains("how large"));
        assert!(told(opening("room.yaml", None, None), YAML, None).contains("maps/room.pgm; bring both"));
        assert!(
            told(opening("room.yaml", Some("hall.pgm"), None), YAML, Some(&room())).contains("not hall.pgm")
        );
        assert!(told(opening("a.pgm", Some("b.pgm"), None), &room(), Some(&room())).contains("one picture"));
    }
}
