use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::Path;
use std::sync::{Arc, Mutex};

use cogmap_simulation::{Robot, Setting, Strategy, World};
use cogmap_study::Seeds;
use cogmap_study::home::{self, DecisionTimes, HomeRow, HomeSummary, Plan, Task};

use super::{home_tables, paths};
use crate::arguments::StudyArguments;
use crate::failure::Failure;
use crate::output::Output;
use crate::timing::Timing;
use crate::{building, progress, terminal};

/// The file with every way home.
const RUNS: &str = "runs.csv";
/// The file that says what the rows depend on besides the seeds.
const PLAN: &str = "plan.txt";

/// Tries every strategy on many ways home, and goes on where an earlier run was cut off.
pub(super) fn home(arguments: &StudyArguments) -> Result<(), Failure> {
    let mut timing = Timing::start();
    let plan = plan(arguments)?;
    let mut rows = match &arguments.out {
        Some(directory) => earlier(directory, &plan, arguments.force)?,
        None => Vec::new(),
    };
    let finished: BTreeSet<_> = rows.iter().map(key).collect();
    let tasks: Vec<Task> = plan.tasks();
    let left: Vec<Task> =
        tasks.iter().copied().filter(|task| !finished.contains(&key_of(&plan, task))).collect();
    let resumes = !rows.is_empty();
    let output = Output::at(arguments.out.as_deref(), arguments.force || resumes)?;
    let file = output.as_ref().map(|output| begin(output, &plan, &rows)).transpose()?.map(Mutex::new);
    timing.done("read");
    let bar = progress::bar(left.len() as u64, "ways out");
    let done = |rows: &[HomeRow]| {
        // All of a task at once, so that a run that is cut off leaves whole tasks behind.
        let text: String = rows.iter().map(HomeRow::line).collect();
        if let Some(Ok(mut file)) = file.as_ref().map(Mutex::lock) {
            let _ = file.write_all(text.as_bytes());
        }
        bar.inc(1);
    };
    let jobs = arguments.jobs.map_or(0, usize::from);
    let (new, times) = home::run(&plan, &left, jobs, done).map_err(Failure::run)?;
    bar.finish_and_clear();
    timing.done("drive out and home");
    rows.extend(new);
    let order = |row: &HomeRow| tasks.iter().position(|task| key_of(&plan, task) == key(row));
    rows.sort_by_cached_key(order);
    conclude((&plan, &rows, &times), output.as_ref(), timing)
}

fn conclude(
    (plan, rows, times): (&Plan, &[HomeRow], &DecisionTimes),
    output: Option<&Output>,
    mut timing: Timing,
) -> Result<(), Failure> {
    let summary = HomeSummary::of(plan, rows);
    timing.done("sum up");
    let mut said = home_tables::of(plan, &summary, times);
    said += &format!("\nDone in {:.1} s.", timing.total());
    said += &match output {
        Some(output) => {
            let json = serde_json::to_string_pretty(&summary).unwrap_or_default() + "\n";
            output.write_all(&[
                (RUNS.into(), text(rows).into_bytes()),
                (PLAN.into(), plan.signature().into_bytes()),
                ("summary.json".into(), json.into_bytes()),
            ])?;
            output.write("timing.json", timing.to_json_with("decisions", times).as_bytes())?;
            let place = output.directory().display();
            format!(" Every way home is in {place}/{RUNS}, every figure in {place}/summary.json.\n")
        }
        None => " Nothing was kept: add --out DIR for every run and every figure.\n".into(),
    };
    terminal::say(&said)
}

fn plan(arguments: &StudyArguments) -> Result<Plan, Failure> {
    let or_all = |wanted: &[String], all: &[&'static str]| match wanted {
        [] => all.iter().map(|&name| name.to_owned()).collect(),
        wanted => wanted.to_vec(),
    };
    let settings = Setting::ALL.map(Setting::name);
    let settings: Vec<String> = or_all(&arguments.settings, &settings);
    let robots: Vec<String> = or_all(&arguments.robots, &Robot::NAMES);
    let strategies: Vec<String> = or_all(&arguments.strategies, &Strategy::names());
    Ok(Plan {
        worlds: worlds(&arguments.worlds)?,
        robots: robots.iter().filter_map(|name| Robot::named(name)).collect(),
        settings: settings.iter().filter_map(|name| Setting::named(name)).collect(),
        strategies: strategies.iter().filter_map(|name| Strategy::named(name)).collect(),
        seeds: Seeds { first: arguments.first, count: arguments.seeds.unwrap_or(home::SEEDS) },
    })
}

/// World files and floor plans.
fn worlds(patterns: &[String]) -> Result<Vec<Arc<World>>, Failure> {
    let read = |path: std::path::PathBuf| building::read(&path, None).map(Arc::new);
    paths(patterns)?.into_iter().map(read).collect()
}

/// Whose task a row belongs to.
fn key(row: &HomeRow) -> (String, String, u64) {
    (row.place.clone(), row.robot.clone(), row.seed)
}

fn key_of(plan: &Plan, task: &Task) -> (String, String, u64) {
    (plan.place(task.place), plan.robots[task.robot].name.clone(), task.seed)
}

/// The rows that an earlier run of the same plan left; none where there was none.
fn earlier(directory: &Path, plan: &Plan, force: bool) -> Result<Vec<HomeRow>, Failure> {
    let path = directory.join(RUNS);
    if force || !path.exists() {
        return Ok(Vec::new());
    }
    let read = |name: &str| fs::read_to_string(directory.join(name)).unwrap_or_default();
    let (signature, text) = (read(PLAN), read(RUNS));
    let lines = text.strip_prefix(&HomeRow::head()).filter(|_| signature == plan.signature());
    let refused = |what: &str| {
        Failure::input(format!("--out {}: it holds {what}", directory.display()))
            .help("name another directory, or replace what it holds with --force")
    };
    // What was being written when a run was cut off is written anew.
    let whole = lines.ok_or_else(|| refused("the files of another run"))?;
    let whole = whole.rsplit_once('\n').map_or("", |(whole, _)| whole);
    let rows: Vec<HomeRow> = whole.lines().filter_map(HomeRow::read).collect();
    let tasks: BTreeSet<_> = plan.tasks().iter().map(|task| key_of(plan, task)).collect();
    if rows.iter().any(|row| !tasks.contains(&key(row))) {
        return Err(refused("runs of other seeds"));
    }
    Ok(rows)
}

/// The file of rows, to be added to.
fn begin(output: &Output, plan: &Plan, rows: &[HomeRow]) -> Result<File, Failure> {
    output.write(PLAN, plan.signature().as_bytes())?;
    output.write(RUNS, text(rows).as_bytes())?;
    let path = output.directory().join(RUNS);
    OpenOptions::new().append(true).open(&path).map_err(|error| Failure::unwritable(&path, &error))
}

fn text(rows: &[HomeRow]) -> String {
    HomeRow::head() + &rows.iter().map(HomeRow::line).collect::<String>()
}
