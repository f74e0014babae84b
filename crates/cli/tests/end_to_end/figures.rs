use crate::workbench::Workbench;

#[test]
fn a_figure_is_left_as_svg_and_png_and_says_that_it_is_new() {
    let bench = Workbench::new();
    let said = bench.cogmap("figures 3.4 2.5 --out drawn").done().out;
    assert!(said.find("2.5 ").unwrap() < said.find("3.4 ").unwrap(), "{said}");
    let files = bench.files_in("drawn");
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["2.5.png", "2.5.svg", "3.4.png", "3.4.svg"]);
    assert!(files[0].1.starts_with(b"\x89PNG"));
    assert!(bench.read("drawn/2.5.svg").contains("A new run that shows what Fig. 2.5 of the thesis shows"));
}

#[test]
fn the_list_names_every_figure_and_draws_none() {
    let bench = Workbench::new();
    let said = bench.cogmap("figures --list").done().out;
    assert_eq!(said.lines().count(), 48, "{said}");
    assert!(said.starts_with("2.1 ") && said.contains("\n3.40 "), "{said}");
    assert!(!bench.path("figures").exists());
}

#[test]
fn an_unknown_figure_is_bad_usage_and_nothing_is_made() {
    let bench = Workbench::new();
    let outcome = bench.cogmap("figures 2.5 4.1 --out drawn");
    assert_eq!(outcome.code, Some(2), "{outcome:?}");
    assert!(outcome.err.contains("no figure `4.1`") && outcome.err.contains("2.1, 2.2"), "{}", outcome.err);
    assert!(!bench.path("drawn").exists());
}
