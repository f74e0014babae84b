//! Times tasks natively and as wasm in Node, in turns.

use std::{
    fs,
    hint::black_box,
    io::{BufRead, BufReader, Lines, Write},
    path::{Path, PathBuf},
    process::{Child, ChildStdin, ChildStdout, Command, Stdio},
    time::Instant,
};

use crate::{Bench, TASKS, Task};

const TARGET: &str = "wasm32-unknown-unknown";
const FOLDER: &str = env!("CARGO_MANIFEST_DIR");
/// Rounds of a task go on for so many seconds …
const SECONDS: f64 = 4.0;
/// … but there are so many at least: the best one counts, for what else the machine does only adds, and what runs
/// the wasm compiles it better only after some rounds.
const LEAST_ROUNDS: usize = 6;

/// What a task gave.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    /// The task.
    pub task: Task,
    /// Of how many units a run consists: readings, steps or scans.
    pub units: usize,
    /// Microseconds for a unit in the best round.
    pub native: f64,
    /// The same in Node, if it could be timed there.
    pub wasm: Option<f64>,
    /// Whether it led to the same bits there.
    pub same: bool,
}

/// Times those of [`TASKS`] that `wanted` agrees to and prints each as it is done; `log` is a recorded log, if
/// there is one.
pub fn race(log: Option<&Path>, wanted: impl Fn(Task) -> bool) -> Vec<Outcome> {
    let mut bench = Bench::new(log.and_then(|log| fs::read(log).ok()).unwrap_or_default());
    let mut node = match build().and_then(|module| Node::start(&module, log)) {
        Ok(node) => Some(node),
        Err(missing) => {
            println!("wasm is not timed: {missing}");
            None
        }
    };
    println!("\n{:<24}{:>7}{:>13}{:>13}{:>9}", "µs for one", "", "native", "wasm", "wasm÷");
    let mut outcomes = Vec::new();
    for (number, &task) in TASKS.iter().enumerate().filter(|(_, task)| wanted(**task)) {
        let Some(outcome) = time((number, task), &mut bench, node.as_mut()) else { continue };
        print(&outcome);
        outcomes.push(outcome);
    }
    let same = outcomes.iter().filter(|outcome| outcome.wasm.is_some()).all(|outcome| outcome.same);
    println!("native and wasm led to {} bits", if same { "the same" } else { "DIFFERENT" });
    outcomes
}

/// The microseconds of a task, natively and as wasm.
#[must_use]
pub fn micros(outcomes: &[Outcome], task: Task) -> Option<(f64, Option<f64>)> {
    outcomes.iter().find(|outcome| outcome.task == task).map(|outcome| (outcome.native, outcome.wasm))
}

/// `None` where the task cannot be run.
fn time((number, task): (usize, Task), bench: &mut Bench, mut node: Option<&mut Node>) -> Option<Outcome> {
    // Both make it ready at once, for that can take long.
    if let Some(node) = &mut node {
        node.ask(&format!("prepare {number}"))?;
    }
    let units = bench.prepare(number);
    if let Some(node) = &mut node {
        node.answer()?;
    }
    let begin = Instant::now();
    let (mut native, mut wasm, mut same, mut rounds) = (f64::INFINITY, None, true, 0);
    while rounds < LEAST_ROUNDS || begin.elapsed().as_secs_f64() < SECONDS {
        bench.rewind();
        let start = Instant::now();
        let sum = black_box(&mut *bench).run();
        native = start.elapsed().as_secs_f64().min(native);
        if let Some(node) = &mut node {
            let (seconds, other) = node.run()?;
            wasm = Some(seconds.min(wasm.unwrap_or(f64::INFINITY)));
            same &= sum.to_bits() == other.to_bits();
        }
        rounds += 1;
    }
    #[allow(clippy::cast_precision_loss, reason = "a run has a few thousand units")]
    let of_unit = |seconds: f64| seconds * 1e6 / units as f64;
    (units > 0).then(|| Outcome { task, units, native: of_unit(native), wasm: wasm.map(of_unit), same })
}

fn print(outcome: &Outcome) {
    let &Outcome { task, units, native, wasm, .. } = outcome;
    let name = match task {
        Task::Extraction => "extraction".to_owned(),
        Task::Mapper(name) => name.to_owned(),
        Task::Grown(surfaces) => format!("{surfaces} surfaces"),
        Task::WayHome(setting) => format!("home, {setting}"),
        Task::Cast(segments, method) => format!("{segments} segments, {}", crate::METHODS[method]),
    };
    let other = wasm.map_or(String::new(), |wasm| format!("{wasm:>13.1}{:>8.2}×", wasm / native));
    println!("{name:<24}{:>7}{native:>13.1}{other}", format!("of {units}"));
}

/// The same code as wasm in Node.
struct Node {
    process: Child,
    questions: ChildStdin,
    answers: Lines<BufReader<ChildStdout>>,
}

impl Node {
    fn start(module: &Path, log: Option<&Path>) -> Result<Self, String> {
        let mut command = Command::new("node");
        command.arg(Path::new(FOLDER).join("node.mjs")).arg(module).arg(log.unwrap_or(Path::new("-")));
        let start = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut process =
            start.map_err(|why| format!("node does not start ({why}): install Node 20 or newer"))?;
        match (process.stdin.take(), process.stdout.take()) {
            (Some(questions), Some(answers)) => {
                Ok(Self { process, questions, answers: BufReader::new(answers).lines() })
            }
            _ => Err("node cannot be talked to".to_owned()),
        }
    }

    fn ask(&mut self, question: &str) -> Option<()> {
        writeln!(self.questions, "{question}").ok()
    }

    fn answer(&mut self) -> Option<String> {
        self.answers.next()?.ok()
    }

    /// The seconds of a run, and its sum.
    fn run(&mut self) -> Option<(f64, f64)> {
        self.ask("run")?;
        let answer = self.answer()?;
        let (milliseconds, sum) = answer.split_once(' ')?;
        Some((milliseconds.parse::<f64>().ok()? / 1e3, sum.parse().ok()?))
    }
}

impl Drop for Node {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Builds the code for wasm; otherwise what is missing and how to get it.
fn build() -> Result<PathBuf, String> {
    let folder = target_folder().ok_or("this bench was not started from a target folder")?;
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut build = Command::new(cargo);
    build
        .current_dir(FOLDER)
        .args(["build", "--profile", "page", "--lib", "--target", TARGET])
        .arg("--target-dir");
    // Flags of the shell's would hide those of `.cargo/config.toml`, with which the page is built.
    build.arg(&folder).env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    match build.status() {
        Ok(status) if status.success() => optimised(&folder.join(TARGET).join("page/cogmap_bench.wasm")),
        Ok(_) => Err(format!(
            "the build for {TARGET} failed; if the target is missing: rustup target add {TARGET}"
        )),
        Err(why) => Err(format!("cargo does not start: {why}")),
    }
}

/// How the page's engine is optimised.
const OPTIMISE: [&str; 3] = ["-O3", "--one-caller-inline-max-function-size", "60"];

/// The module made as fast as the page's is made.
fn optimised(module: &Path) -> Result<PathBuf, String> {
    let optimiser = Path::new(FOLDER).join("../../web/node_modules/.bin/wasm-opt");
    let out = module.with_extension("optimised.wasm");
    let done = Command::new(optimiser).args(OPTIMISE).arg(module).arg("-o").arg(&out).status();
    match done {
        Ok(status) if status.success() => Ok(out),
        Ok(_) => Err("wasm-opt cannot read what was built".to_owned()),
        Err(why) => {
            Err(format!("wasm-opt does not start ({why}): cargo xtask demo --build-only installs it"))
        }
    }
}

/// `TARGET` of `TARGET/release/deps/steps-0123456789abcdef`.
fn target_folder() -> Option<PathBuf> {
    Some(std::env::current_exe().ok()?.ancestors().nth(3)?.to_path_buf())
}
