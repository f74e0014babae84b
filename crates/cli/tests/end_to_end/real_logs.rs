use crate::workbench::{Workbench, project};

/// The rows of `estimate.tum` for a log of `shared/data` beside the project; `None` where it is missing.
fn rows(log: &str) -> Option<usize> {
    let path = project().join("../shared/data/logs").join(log);
    if !path.exists() {
        println!("skipped: {} is missing", path.display());
        return None;
    }
    let bench = Workbench::new();
    let path = path.canonicalize().unwrap();
    bench.cogmap_with(["replay".as_ref(), path.as_os_str(), "--out".as_ref(), "out".as_ref()]).done();
    for name in
        ["map.json", "map.svg", "map.png", "events.jsonl", "report.json", "session.json", "timing.json"]
    {
        assert!(bench.path("out").join(name).exists(), "{name}");
    }
    Some(bench.read("out/estimate.tum").lines().count())
}

#[test]
fn the_intel_laboratory_is_mapped() {
    assert!(rows("intel.log.gz").is_none_or(|rows| rows == 2663));
}

#[test]
fn the_loop_of_malaga_is_mapped() {
    assert!(rows("sena.log.gz").is_none_or(|rows| rows == 225));
}
