//! After a wanted change run the tests with `UPDATE_GOLDENS=1` and look at what became of the figures.

use std::{env, fs, path::PathBuf};

use cogmap_scene::{Theme, png};
use cogmap_study::figures::{Figure, Runs};

/// Pixels across.
const WIDTH: f64 = 800.0;
/// Figures that are also looked at on a dark ground.
const DARK: [&str; 4] = ["2.1", "3.12", "3.14", "3.28"];

fn goldens() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("goldens/figures")
}

/// Whether the picture is the one that is kept.
fn is_as_before(name: &str, bytes: &[u8]) -> bool {
    let path = goldens().join(name);
    if env::var_os("UPDATE_GOLDENS").is_some() {
        fs::create_dir_all(goldens()).unwrap();
        fs::write(&path, bytes).unwrap();
    }
    fs::read(&path).is_ok_and(|golden| golden == bytes)
}

#[test]
fn every_figure_looks_as_it_did() {
    let mut runs = Runs::new(1);
    let mut changed = Vec::new();
    for figure in Figure::all() {
        let plate = figure.draw(&mut runs).unwrap();
        let dark = DARK.contains(&figure.id).then_some((Theme::Dark, "-dark"));
        for (theme, suffix) in [(Theme::Light, "")].into_iter().chain(dark) {
            let name = format!("{}{suffix}.png", figure.id);
            let bytes = png::file(&plate.picture(WIDTH, theme), 1.0).unwrap();
            if !is_as_before(&name, &bytes) {
                changed.push(name);
            }
        }
    }
    assert!(changed.is_empty(), "these differ from tests/goldens/figures: {}", changed.join(", "));
}

#[test]
fn the_pictures_kept_are_small() {
    let sizes = fs::read_dir(goldens()).unwrap().map(|entry| entry.unwrap().metadata().unwrap().len());
    assert!(sizes.sum::<u64>() < 3_500_000, "a repository is no place for large pictures");
}
