use std::{fs, path::PathBuf};

use cogmap_formats::world;

#[test]
fn every_world_of_the_project_can_be_read_and_survives_its_file() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../worlds");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let worlds: Vec<PathBuf> = files.filter(|path| path.to_string_lossy().ends_with(".world.json")).collect();
    assert!(worlds.len() >= 3);
    for path in worlds {
        let text = fs::read_to_string(&path).unwrap();
        let read = world::read(&text, &path.to_string_lossy()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(world::read(&world::write(&read), "written").unwrap(), read);
    }
}
