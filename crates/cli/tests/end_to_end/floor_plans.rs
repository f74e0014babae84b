use crate::workbench::Workbench;

/// A hall of 12 m by 9 m at 5 cm a pixel, with a wall that leaves a passage at its end, as a PGM.
fn hall() -> Vec<u8> {
    const WIDTH: usize = 240;
    const HEIGHT: usize = 180;
    let free = |column: usize, row: usize| {
        let inside = (4..WIDTH - 4).contains(&column) && (4..HEIGHT - 4).contains(&row);
        inside && (!(100..104).contains(&column) || row > 140)
    };
    let mut picture = format!("P5\n{WIDTH} {HEIGHT}\n255\n").into_bytes();
    picture.extend((0..WIDTH * HEIGHT).map(|k| if free(k % WIDTH, k / WIDTH) { 254 } else { 0 }));
    picture
}

const DESCRIPTION: &str = "image: hall.pgm\nresolution: 0.05\norigin: [-6.0, -4.5, 0.0]\n\
                           negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

fn bench() -> Workbench {
    let bench = Workbench::new();
    bench.put("hall.pgm", hall());
    bench.put("hall.yaml", DESCRIPTION);
    bench
}

#[test]
fn a_floor_plan_is_driven_through_and_its_session_needs_no_picture() {
    let bench = bench();
    bench.cogmap("run hall.yaml --route random --seed 4 --out first").done();
    std::fs::remove_file(bench.path("hall.pgm")).unwrap();
    bench.cogmap("replay first/session.json --out again").done();
    assert_eq!(bench.read("first/map.json"), bench.read("again/map.json"));
}

#[test]
fn a_picture_and_its_scale_are_enough() {
    let bench = bench();
    let outcome = bench.cogmap("run hall.pgm --resolution 0.05 --route random --robot perfect").done();
    assert!(outcome.out.contains("\"hall\""), "{}", outcome.out);
}

#[test]
fn check_says_what_is_in_a_floor_plan() {
    let bench = bench();
    for arguments in ["check hall.yaml", "check hall.pgm --resolution 0.05"] {
        let outcome = bench.cogmap(arguments).done();
        assert!(outcome.out.contains("a floor plan of 12.0 m by 9.0 m"), "{}", outcome.out);
        assert!(outcome.out.contains("within 8 pieces of wall"), "{}", outcome.out);
    }
}

#[test]
fn a_plan_has_no_route_of_its_own() {
    let outcome = bench().cogmap("run hall.yaml");
    assert_eq!(outcome.code, Some(2));
    assert!(outcome.err.contains("--route random"), "{}", outcome.err);
}
