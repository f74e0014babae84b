use std::path::Path;

use cogmap_formats::plan::{MapServer, Plan};
use cogmap_simulation::{Building, World};

use crate::failure::Failure;
use crate::input::Input;
use cogmap_formats::Kind;

/// How a world is asked for that no file holds: `generated:SEED`.
const GENERATED: &str = "generated:";

/// A building to drive in: a world file, a floor plan that becomes one, or one made from a seed.
pub(crate) fn read(path: &Path, resolution: Option<f64>) -> Result<World, Failure> {
    if let Some(seed) = path.to_str().and_then(|name| name.strip_prefix(GENERATED)) {
        return generated(seed);
    }
    let input = Input::read(path)?;
    let name = &input.name;
    let kind = input.kind();
    if let (Some(_), false) = (resolution, kind == Kind::Picture) {
        return Err(Failure::input(format!("--resolution: {name} is no picture and says its own scale"))
            .help("leave --resolution out"));
    }
    let not_a_world = |what: &str, way_out: String| {
        Err(Failure::input(format!("{name}: this is {what}, not a world")).help(way_out))
    };
    let replay = format!("cogmap replay {name}");
    match kind {
        Kind::World => Ok(cogmap_formats::world::read(input.text()?, name)?),
        Kind::Picture => Ok(of_picture(&input, path, resolution)?.world),
        Kind::MapServer => Ok(of_map_server(&input, path)?.world),
        Kind::Session => not_a_world("a session", replay),
        Kind::Log => not_a_world("a log", replay),
        Kind::Other(what) => not_a_world(
            what,
            "give a NAME.world.json, a ROS map_server YAML, or a PNG or PGM floor plan with --resolution"
                .into(),
        ),
    }
}

fn generated(seed: &str) -> Result<World, Failure> {
    seed.parse().map(Building::generate).map_err(|_| {
        Failure::input(format!("{GENERATED}{seed}: `{seed}` is no seed"))
            .help(format!("give a number from 0 to {}, such as {GENERATED}7", u64::MAX))
    })
}

/// The plan in a picture of which only the scale is known, metres a pixel.
pub(crate) fn of_picture(input: &Input, path: &Path, resolution: Option<f64>) -> Result<Plan, Failure> {
    let resolution = resolution.ok_or_else(|| {
        Failure::input(format!("{}: a picture does not say how large its building is", input.name))
            .help("say how many metres a pixel is with --resolution, such as --resolution 0.05")
    })?;
    let map = MapServer::of_picture(&input.name, resolution);
    Ok(Plan::trace(&input.plain, &map, &stem(path), &input.name)?)
}

/// The plan that a `map_server` file describes; its picture lies where the file says.
pub(crate) fn of_map_server(input: &Input, path: &Path) -> Result<Plan, Failure> {
    let map = MapServer::read(input.text()?, &input.name)?;
    let picture = Input::read(&path.with_file_name(&map.image)).map_err(|failure| {
        failure.help(format!("{} names this picture with its key `image`: correct it there", input.name))
    })?;
    Ok(Plan::trace(&picture.plain, &map, &stem(path), &picture.name)?)
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
}
