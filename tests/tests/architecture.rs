use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use serde_json::Value;

/// The rooms from the ground up: a crate may name only crates of lower floors.
const FLOORS: [&[&str]; 8] = [
    &["cogmap-geometry"],
    &["cogmap-mapping"],
    &["cogmap-navigation"],
    &["cogmap-simulation"],
    &["cogmap-formats", "cogmap-scene"],
    &["cogmap-study", "cogmap-bench"],
    &["cogmap", "cogmap-wasm"],
    &["cogmap-tests"],
];

/// Crates that stand beside the building: they name no room, and no room names them.
const OUTSIDE: [&str; 1] = ["xtask"];

/// What the robot's own code must never reach: the truth, files, a browser, outside randomness.
const OUT_OF_REACH: [&str; 8] = [
    "cogmap-simulation",
    "cogmap-formats",
    "cogmap-scene",
    "cogmap-study",
    "web-sys",
    "js-sys",
    "wasm-bindgen",
    "getrandom",
];

/// For each package, the packages that it names.
type Graph = BTreeMap<String, BTreeSet<String>>;

#[test]
fn every_dependency_leads_to_a_lower_floor() {
    let named = workspace_graph(&metadata());
    assert!(named.contains_key("cogmap-mapping"));
    assert_eq!(wrong_arrows(&named), Vec::<String>::new());
}

#[test]
fn the_robot_cannot_reach_the_truth() {
    let built = resolved_graph(&metadata());
    let mapping = reachable(&built, "cogmap-mapping");
    assert!(mapping.contains("cogmap-geometry"));
    assert!(!mapping.contains("cogmap-navigation"));
    let navigation = reachable(&built, "cogmap-navigation");
    for forbidden in OUT_OF_REACH {
        assert!(!mapping.contains(forbidden), "mapping reaches {forbidden}");
        assert!(!navigation.contains(forbidden), "navigation reaches {forbidden}");
    }
}

#[test]
fn an_arrow_that_leads_up_is_found() {
    for (from, to) in [
        ("cogmap-mapping", "cogmap-simulation"),
        ("cogmap-mapping", "cogmap-navigation"),
        ("cogmap-formats", "cogmap-scene"),
        ("cogmap-geometry", "xtask"),
        ("xtask", "cogmap-geometry"),
        ("cogmap-newcomer", "cogmap-geometry"),
    ] {
        let mut graph = Graph::new();
        graph.insert(to.to_owned(), BTreeSet::new());
        graph.insert(from.to_owned(), BTreeSet::from([to.to_owned()]));
        assert!(!wrong_arrows(&graph).is_empty(), "{from} → {to}");
    }
}

/// The arrows between members of the workspace that the floors do not allow, and strangers.
fn wrong_arrows(graph: &Graph) -> Vec<String> {
    let mut wrong = Vec::new();
    for (from, names) in graph {
        if OUTSIDE.contains(&from.as_str()) {
            let rooms = names.iter().filter(|to| graph.contains_key(*to));
            wrong.extend(rooms.map(|to| format!("{from} → {to}")));
            continue;
        }
        let Some(floor) = floor(from) else {
            wrong.push(format!("{from} has no floor"));
            continue;
        };
        let rooms = names.iter().filter(|to| graph.contains_key(*to));
        let up = rooms.filter(|to| self::floor(to).is_none_or(|lower| lower >= floor));
        wrong.extend(up.map(|to| format!("{from} → {to}")));
    }
    wrong
}

fn floor(package: &str) -> Option<usize> {
    FLOORS.iter().position(|rooms| rooms.contains(&package))
}

/// Everything that a package is built from, itself included; nothing if it does not exist.
fn reachable(graph: &Graph, package: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open: Vec<_> = graph.get_key_value(package).into_iter().collect();
    while let Some((name, needs)) = open.pop() {
        if found.insert(name.clone()) {
            open.extend(needs.iter().filter_map(|need| graph.get_key_value(need)));
        }
    }
    found
}

/// What each member of the workspace declares, tests and build scripts included.
fn workspace_graph(metadata: &Value) -> Graph {
    let members: BTreeSet<_> = strings(&metadata["workspace_members"]).collect();
    list(&metadata["packages"])
        .filter(|package| members.contains(text(&package["id"])))
        .map(|package| {
            let named = list(&package["dependencies"]);
            let named = named.map(|it| text(&it["name"]).to_owned()).collect();
            (text(&package["name"]).to_owned(), named)
        })
        .collect()
}

/// What each package is built from on any platform, leaving out what only its tests need.
fn resolved_graph(metadata: &Value) -> Graph {
    let names: BTreeMap<_, _> =
        list(&metadata["packages"]).map(|package| (text(&package["id"]), text(&package["name"]))).collect();
    let mut graph = Graph::new();
    for node in list(&metadata["resolve"]["nodes"]) {
        let needs = list(&node["deps"])
            .filter(|need| list(&need["dep_kinds"]).any(|kind| kind["kind"] != "dev"))
            .map(|need| names[text(&need["pkg"])].to_owned());
        // Two versions of a package count as one.
        let entry = graph.entry(names[text(&node["id"])].to_owned());
        entry.or_default().extend(needs);
    }
    graph
}

fn metadata() -> Value {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    let reason = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "cargo metadata: {reason}");
    serde_json::from_slice(&output.stdout).unwrap()
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().unwrap().iter()
}

fn strings(value: &Value) -> impl Iterator<Item = &str> {
    list(value).map(text)
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap()
}
