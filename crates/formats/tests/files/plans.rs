use std::{fs, path::PathBuf};

use cogmap_formats::plan::{MapServer, Plan};
use cogmap_geometry::{DVec2, Segment};

/// The plans of real buildings, where the folder of shared data stands beside the project.
fn plans() -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/plans");
    let Ok(files) = fs::read_dir(&folder) else {
        println!("skipped: no {}", folder.display());
        return Vec::new();
    };
    let files = files.map(|entry| entry.unwrap().path());
    let mut plans: Vec<PathBuf> =
        files.filter(|path| path.extension().is_some_and(|it| it == "yaml")).collect();
    plans.sort_unstable();
    plans
}

#[test]
fn real_floor_plans_become_worlds_of_few_pieces() {
    for path in plans() {
        let name = path.file_stem().unwrap().to_string_lossy();
        let map = MapServer::read(&fs::read_to_string(&path).unwrap(), &name).unwrap();
        let picture = fs::read(path.with_file_name(&map.image)).unwrap();
        let plan = Plan::trace(&picture, &map, &name, &map.image).unwrap_or_else(|error| panic!("{error}"));
        let walls = plan.world.walls.iter().flat_map(|wall| wall.windows(2));
        let lengths = walls.map(|ends| Segment::new(ends[0].into(), ends[1].into()).length());
        let metres: f64 = lengths.sum();
        let start = DVec2::from(plan.world.start.position);
        println!(
            "{name}: {:.0} m² kept, {:.0} m² left out, {} pieces, {metres:.0} m of wall, start {start:.1}",
            plan.kept, plan.left_out, plan.pieces
        );
        assert!(plan.kept > 10.0 * plan.left_out, "{name}");
        assert!(plan.pieces < 20_000, "{name}");
    }
}
