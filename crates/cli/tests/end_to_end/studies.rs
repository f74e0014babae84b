use crate::workbench::Workbench;

#[test]
fn the_studies_are_listed_and_explained() {
    let bench = Workbench::new();
    let list = bench.cogmap("study").done().out;
    let help = bench.cogmap("study --help").done().out;
    for name in ["small", "loop-b", "placement", "loop-a", "tour", "claims", "results"] {
        assert!(list.lines().any(|line| line.trim_start().starts_with(name)), "{name}\n{list}");
        assert!(help.contains(&format!("{name} (")), "{name}\n{help}");
    }
}

#[test]
fn a_study_leaves_a_row_for_each_run_and_mapper_whatever_the_number_of_jobs() {
    let bench = Workbench::new();
    bench.cogmap("study small --worlds *.world.json --seeds 3 --jobs 1 --seed 7 --out one").done();
    let said =
        bench.cogmap("study small --worlds room.world.json --seeds 3 --jobs 3 --seed 7 --out many").done();
    assert!(said.out.contains("Room, across, bad robot") && said.out.contains("criterion"), "{}", said.out);
    let runs = bench.read("one/runs.csv");
    assert_eq!(runs, bench.read("many/runs.csv"));
    assert_eq!(bench.read("one/summary.json"), bench.read("many/summary.json"));
    let rows: Vec<Vec<&str>> = runs.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 1 + 2 * 3 * 4, "a head; two robots, three seeds, four mappers");
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
    assert_eq!(rows[0][..7], ["world", "route", "robot", "odometry", "every", "seed", "mapper"]);
    assert_eq!(rows[1][..7], ["Room", "across", "good", "1", "", "7", "odometry"]);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("one/summary.json")).unwrap();
    assert_eq!(summary["seeds"], serde_json::json!({"first": 7, "count": 3}));
    assert!(summary["groups"][0]["figures"]["shape"]["low"].is_number());
    assert!(summary["mappers"]["perceptual"]["matching"].is_object(), "every parameter is there");
}

#[test]
fn a_study_that_makes_odometry_worse_draws_what_becomes_of_the_map() {
    let bench = Workbench::new();
    let said = bench
        .cogmap("study odometry-independence --worlds room.world.json --seeds 2 --seed 1 --out worse")
        .done()
        .out;
    assert!(said.contains("the curve in curve.svg"), "{said}");
    let curve = bench.read("worse/curve.svg");
    for word in ["times the robot’s odometry errors", "shape error, m", "transform", "consensus"] {
        assert!(curve.contains(word), "{word}");
    }
    assert!(std::fs::read(bench.path("worse/curve.png")).unwrap().starts_with(b"\x89PNG"));
    bench.cogmap("study small --worlds room.world.json --seeds 1 --out worse --force").done();
    assert!(!bench.path("worse/curve.svg").exists(), "a file of the run before");
}

#[test]
fn a_log_is_studied_against_its_relations() {
    let bench = Workbench::new();
    bench.put("walk.relations", "0 2 0.8 0 0 0 0 0\n0 4 1.6 0 0 0 0 0\n");
    let said = bench
        .cogmap("study relations --log walk.log --relations walk.relations --seeds 2 --odometry-noise 1");
    assert!(said.done().out.contains("walk.log, odometry noise 1, a view each 0.85 m or rad"));
}

#[test]
fn files_of_another_run_are_not_overwritten() {
    let bench = Workbench::new();
    bench.cogmap("study small --worlds room.world.json --seeds 1 --out first").done();
    let refused = bench.cogmap("study small --worlds room.world.json --seeds 1 --out first");
    assert!(refused.code == Some(2) && refused.err.contains("--force"), "{}", refused.err);
    bench.cogmap("study small --worlds room.world.json --seeds 1 --out first --force").done();
}

#[test]
fn a_study_of_ways_home_goes_on_where_it_was_cut_off() {
    const HOME: &str = "study home --seed 1 --seeds 2 --robot perfect --setting empty --strategy retrace";
    let bench = Workbench::new();
    let said = bench.cogmap(&format!("{HOME} --jobs 1 --out home")).done().out;
    assert!(said.contains("empty, perfect robot, generated") && said.contains("≤ 1 m"), "{said}");
    let (whole, summary) = (bench.read("home/runs.csv"), bench.read("home/summary.json"));
    let lines: Vec<&str> = whole.lines().collect();
    assert_eq!(lines.len(), 1 + 2);
    bench.put("home/runs.csv", format!("{}\n{}\n{}", lines[0], lines[2], &lines[1][..20]));
    bench.cogmap(&format!("{HOME} --jobs 2 --out home")).done();
    assert_eq!((bench.read("home/runs.csv"), bench.read("home/summary.json")), (whole, summary));
    for other in ["--robot good", "--seed 2"] {
        let refused = bench.cogmap(&format!("{} --out home", HOME.replace("--seed 1", other)));
        assert!(refused.code == Some(2) && refused.err.contains("--force"), "{}", refused.err);
    }
    let refused = bench.cogmap("study small --strategy retrace");
    assert!(refused.code == Some(2) && refused.err.contains("only the study `home`"), "{}", refused.err);
}
