use std::sync::Arc;

use cogmap_simulation::World;

/// The buildings that the thesis's experiments are driven in, by name.
const WORLDS: [(&str, &str); 14] = [
    ("around-a-corner", include_str!("../../../worlds/around-a-corner.world.json")),
    ("box-course", include_str!("../../../worlds/box-course.world.json")),
    ("environment-a", include_str!("../../../worlds/environment-a.world.json")),
    ("environment-b", include_str!("../../../worlds/environment-b.world.json")),
    ("long-corridor", include_str!("../../../worlds/long-corridor.world.json")),
    ("long-office", include_str!("../../../worlds/long-office.world.json")),
    ("narrow-passage", include_str!("../../../worlds/narrow-passage.world.json")),
    ("no-passage", include_str!("../../../worlds/no-passage.world.json")),
    ("office", include_str!("../../../worlds/office.world.json")),
    ("shortcut", include_str!("../../../worlds/shortcut.world.json")),
    ("small-office", include_str!("../../../worlds/small-office.world.json")),
    ("tour", include_str!("../../../worlds/tour.world.json")),
    ("two-shortcuts", include_str!("../../../worlds/two-shortcuts.world.json")),
    ("u-trap", include_str!("../../../worlds/u-trap.world.json")),
];

/// A building by name; it is built into the program.
///
/// # Errors
/// There is none of that name.
pub fn world(name: &str) -> Result<Arc<World>, String> {
    let known = WORLDS.iter().find(|(known, _)| *known == name);
    let (_, text) = known.ok_or_else(|| format!("there is no world `{name}`"))?;
    let world = cogmap_formats::world::read(text, name).map_err(|error| error.to_string())?;
    Ok(Arc::new(world))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_world_can_be_read_and_has_a_route() {
        for (name, _) in WORLDS {
            assert!(!world(name).unwrap().routes.is_empty(), "{name}");
        }
        assert!(world("castle").is_err());
    }
}
