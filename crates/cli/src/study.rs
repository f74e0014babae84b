//! `cogmap study`: experiments with many seeds.

mod home;
mod home_tables;
mod markdown;
mod tables;

use std::path::PathBuf;
use std::sync::Arc;

use cogmap_scene::Theme;
use cogmap_simulation::World;
use cogmap_study::{Check, Log, Outcome, Request, Seeds, Study, Summary, figures::curve, runner};

use crate::arguments::StudyArguments;
use crate::failure::Failure;
use crate::input::Input;
use crate::log;
use crate::output::Output;
use crate::progress;
use crate::table::Table;
use crate::terminal;
use crate::timing::Timing;
use cogmap_formats::Kind;

/// Runs an experiment and leaves what came out; without a name, lists the experiments.
pub(crate) fn study(arguments: &StudyArguments) -> Result<(), Failure> {
    let Some(name) = &arguments.name else { return terminal::say(&list()) };
    if name == cogmap_study::home::NAME {
        return home::home(arguments);
    }
    let only_home = [
        ("--robot", &arguments.robots),
        ("--setting", &arguments.settings),
        ("--strategy", &arguments.strategies),
    ];
    if let Some((option, _)) = only_home.iter().find(|(_, names)| !names.is_empty()) {
        return Err(
            Failure::input(format!("{option}: only the study `home` can be asked so")).help("leave it out")
        );
    }
    let study = Study::named(name).ok_or_else(|| unknown(name))?;
    let mut timing = Timing::start();
    let request = Request {
        worlds: worlds(&arguments.worlds)?,
        log: log(arguments)?,
        noise: arguments.odometry_noise.clone(),
    };
    let conditions = (study.plan)(&request).map_err(Failure::input)?;
    let output = Output::at(arguments.out.as_deref(), arguments.force)?;
    let seeds = Seeds { first: arguments.first, count: arguments.seeds.unwrap_or(study.seeds) };
    timing.done("read");
    let bar = progress::bar(runner::drives(&conditions, seeds).len() as u64, "drives");
    let jobs = arguments.jobs.map_or(0, usize::from);
    let rows = runner::run(&conditions, seeds, jobs, || bar.inc(1)).map_err(Failure::run)?;
    bar.finish_and_clear();
    let outcome = Outcome { conditions, rows };
    timing.done("drive, map and score");
    let checks = (study.judge)(&outcome);
    conclude(study, seeds, (&outcome, &checks), (output.as_ref(), timing))
}

/// Writes the files and shows the tables.
fn conclude(
    study: &Study,
    seeds: Seeds,
    (outcome, checks): (&Outcome, &[Check]),
    (output, mut timing): (Option<&Output>, Timing),
) -> Result<(), Failure> {
    let summary = Summary::of(study, seeds, outcome, checks);
    let summary = serde_json::to_string_pretty(&summary).unwrap_or_default() + "\n";
    timing.done("sum up");
    let mut said = if study.name == "results" {
        markdown::of(seeds, outcome)
    } else {
        tables::of(study, seeds, outcome, checks)
    };
    said += &format!("\nDone in {:.1} s.", timing.total());
    said += &match output {
        Some(output) => {
            let mut files = vec![
                ("runs.csv".into(), outcome.csv().into_bytes()),
                ("summary.json".into(), summary.into_bytes()),
            ];
            let curve = curve(outcome);
            if let Some(plate) = &curve {
                files.extend(crate::figures::files("curve", plate, Theme::Light)?);
            }
            output.write_all(&files)?;
            output.write("timing.json", timing.to_json().as_bytes())?;
            let place = output.directory().display();
            let drawn = if curve.is_some() { ", the curve in curve.svg and curve.png" } else { "" };
            format!(" Every run is in {place}/runs.csv, every figure in {place}/summary.json{drawn}.\n")
        }
        None => " Nothing was kept: add --out DIR for every run and every figure.\n".into(),
    };
    terminal::say(&said)
}

/// The worlds that patterns name.
fn worlds(patterns: &[String]) -> Result<Vec<Arc<World>>, Failure> {
    let mut worlds = Vec::new();
    for path in paths(patterns)? {
        let input = Input::read(&path)?;
        let world = cogmap_formats::world::read(input.text()?, &input.name)?;
        let problems = world.problems();
        if !problems.is_empty() {
            return Err(crate::run::problems_of(&path, &problems));
        }
        worlds.push(Arc::new(world));
    }
    Ok(worlds)
}

/// The files that patterns name.
fn paths(patterns: &[String]) -> Result<Vec<PathBuf>, Failure> {
    let mut all = Vec::new();
    for pattern in patterns {
        let of = |what: String| Failure::input(format!("--worlds {pattern}: {what}"));
        let paths = glob::glob(pattern).map_err(|error| of(error.msg.to_owned()))?;
        let mut paths: Vec<PathBuf> = paths.filter_map(Result::ok).collect();
        paths.sort();
        if paths.is_empty() {
            return Err(of("no such file".into()).help("name world files, as in 'worlds/*.world.json'"));
        }
        all.extend(paths);
    }
    Ok(all)
}

/// The log that the arguments name, with its relations.
fn log(arguments: &StudyArguments) -> Result<Option<Arc<Log>>, Failure> {
    let Some(path) = &arguments.log else { return Ok(None) };
    let input = Input::read(path)?;
    let recording = match input.kind() {
        Kind::Log => log::read(&input, false)?.recording,
        kind => return Err(log::not_a_log(&input, kind)),
    };
    let relations = match &arguments.relations {
        Some(path) => {
            let input = Input::read(path)?;
            cogmap_formats::relations::read(input.text()?, &input.name)?
        }
        None => Vec::new(),
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok(Some(Arc::new(Log { name, recording, relations })))
}

fn unknown(name: &str) -> Failure {
    let names = Study::ALL.iter().map(|study| study.name).chain([cogmap_study::home::NAME]);
    let names: Vec<&str> = names.collect();
    Failure::input(format!("there is no study `{name}`")).help(format!("choose from {}", names.join(", ")))
}

/// The names with a line each.
fn list() -> String {
    let mut table = Table::of_words(&["study", "what it asks"]);
    for study in &Study::ALL {
        table.row(vec![study.name.into(), study.line.into()]);
    }
    table.row(vec![cogmap_study::home::NAME.into(), cogmap_study::home::LINE.into()]);
    format!("{}\nRun one: cogmap study NAME --out DIR. Explained: cogmap study --help\n", table.render())
}

/// How the command is called.
pub(crate) fn examples() -> String {
    "Example: cogmap study\n\
     Example: cogmap study loop-b --out loop-b\n\
     Example: cogmap study relations --log intel.log.gz --relations intel.relations\n\
     Example: cogmap study home --robot bad --seeds 50 --seed 1 --out home\n\
     Example: cogmap study small --seeds 20 --seed 1 --worlds 'worlds/*office.world.json'\n\n\
     `cogmap study --help` explains each study."
        .to_owned()
}

/// What each study runs and measures.
pub(crate) fn explanations() -> String {
    let mut text = String::from("Studies:\n\n");
    for study in &Study::ALL {
        text += &format!("{} ({} seeds)\n  {}\n\n", study.name, study.seeds, study.about);
    }
    let home = (cogmap_study::home::NAME, cogmap_study::home::SEEDS, cogmap_study::home::ABOUT);
    text += &format!("{} ({} seeds)\n  {}\n\n", home.0, home.1, home.2);
    text + "runs.csv has a row for each run and mapper, the same seeds for all mappers; summary.json has every\n\
            figure with its 95 % interval, every parameter, and what each column means; where noise or steps vary, \
            curve.svg and curve.png draw what becomes of the map's shape.\n\n"
        + &examples()
}
