use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand};
use cogmap_formats::plan::MapServer;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Robot, Setting, Strategy};

mod examples;

/// The mapper of a command that names none.
pub(crate) const DEFAULT_MAPPER: &str = "consensus";
/// The strategy of a robot that is told to go home without saying how.
pub(crate) const DEFAULT_STRATEGY: &str = "recommended";

/// What the command line asks for.
#[derive(Debug, Parser)]
#[command(
    name = "cogmap",
    version,
    about = "A laboratory for robot mapping: drives virtual robots, maps recorded logs, checks files",
    after_help = "Example: cogmap run worlds/small-office.world.json --out first-run\n\
                  Example: cogmap replay intel.log.gz --out intel\n\
                  `cogmap COMMAND --help` explains a command.\n\n\
                  Exit code: 0 done, 1 the run failed, 2 bad usage or bad input.",
    arg_required_else_help = true,
    disable_help_subcommand = true
)]
pub(crate) struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub(crate) request: Request,
}

/// One of the commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Request {
    /// Drive a virtual robot along a route and map what its laser sees
    #[command(after_help = examples::RUN)]
    Run(RunArguments),
    /// Map a recorded log, or run a session again
    #[command(after_help = examples::REPLAY)]
    Replay(ReplayArguments),
    /// Run an experiment with many seeds on all cores; without NAME, list the experiments
    #[command(after_help = crate::study::examples(), after_long_help = crate::study::explanations())]
    Study(StudyArguments),
    /// Draw the figures of the thesis anew, from real runs, as SVG and PNG
    #[command(after_help = examples::FIGURES)]
    Figures(FiguresArguments),
    /// Say what files are, what is in them and what is wrong with them
    #[command(after_help = examples::CHECK)]
    Check(CheckArguments),
}

/// `cogmap run`.
#[derive(Debug, Args)]
pub(crate) struct RunArguments {
    /// World to drive in: NAME.world.json, a ROS map_server YAML with its picture, a PNG or PGM
    /// floor plan, or generated:SEED, an office floor made from that seed
    pub(crate) world: PathBuf,
    #[command(flatten)]
    pub(crate) picture: PictureArguments,
    /// How far the odometry can be trusted: perfect, good, bad, or a robot FILE
    #[arg(long, value_name = "perfect|good|bad|FILE", default_value = "bad")]
    pub(crate) robot: PathBuf,
    /// Way through the building: a route of the world, a FILE with a list of points
    /// `[[x,y],…]` in metres, or random [default: the world's first route]
    #[arg(long, value_name = "NAME|FILE|random")]
    pub(crate) route: Option<PathBuf>,
    /// At the end of the route let the robot find its way home alone; the first mapper's belief leads it
    #[arg(long)]
    pub(crate) go_home: bool,
    /// How it finds home: recommended (ours), faithful (the thesis to the letter), retrace (the way that it
    /// came), tangent-bug (two distances and no map), oracle (sees the building; the yardstick)
    /// [default: recommended]
    #[arg(long, value_name = "NAME", requires = "go_home",
        value_parser = PossibleValuesParser::new(Strategy::names()))]
    pub(crate) strategy: Option<String>,
    /// Everything random comes from it
    #[arg(long, value_name = "N", default_value = "1", value_parser = seed, allow_negative_numbers = true)]
    pub(crate) seed: u64,
    #[command(flatten)]
    pub(crate) mappers: MapperArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// `cogmap replay`.
#[derive(Debug, Args)]
pub(crate) struct ReplayArguments {
    /// Recorded log (CARMEN .log or .clf), or session.json of an earlier run; gzipped or not
    #[arg(value_name = "LOG|SESSION")]
    pub(crate) input: PathBuf,
    /// Keep one scan each M metres or M radians, whichever comes first [default: every scan]
    #[arg(long, value_name = "M", value_parser = above_zero, allow_negative_numbers = true)]
    pub(crate) every: Option<f64>,
    /// Make the log's odometry worse by this factor; 1 is mild, 10 is a very bad robot
    #[arg(long, value_name = "K", value_parser = zero_or_above, allow_negative_numbers = true)]
    pub(crate) odometry_noise: Option<f64>,
    /// The added noise comes from it [default: 1]
    #[arg(long, value_name = "N", value_parser = seed, allow_negative_numbers = true)]
    pub(crate) seed: Option<u64>,
    /// Stop at the first broken line instead of counting and skipping it
    #[arg(long)]
    pub(crate) strict: bool,
    #[command(flatten)]
    pub(crate) mappers: MapperArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// `cogmap study`.
#[derive(Debug, Args)]
pub(crate) struct StudyArguments {
    /// Experiment to run
    #[arg(value_name = "NAME")]
    pub(crate) name: Option<String>,
    /// World files to run it in instead of its own: patterns such as 'worlds/*.world.json'; for `home`
    /// also ROS map_server files
    #[arg(long, value_name = "GLOB", num_args = 1..)]
    pub(crate) worlds: Vec<String>,
    /// How many seeds [default: the experiment's own, see --help]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub(crate) seeds: Option<u64>,
    /// How many drives at once [default: as many as there are cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) jobs: Option<u16>,
    /// First seed; the others follow it. Parameters were tuned on seeds below 100
    #[arg(long = "seed", value_name = "FIRST", default_value = "1000", value_parser = first_seed,
        allow_negative_numbers = true)]
    pub(crate) first: u64,
    /// Recorded log, for `relations` and `cadence`
    #[arg(long, value_name = "FILE")]
    pub(crate) log: Option<PathBuf>,
    /// Where the log's robot truly was: rows of `t1 t2 x y z roll pitch yaw`, matched by hand
    #[arg(long, value_name = "FILE", requires = "log")]
    pub(crate) relations: Option<PathBuf>,
    /// Make the log's odometry worse by this factor; give it again for more factors [default: 1, 10]
    #[arg(long, value_name = "K", requires = "log", value_parser = zero_or_above,
        allow_negative_numbers = true)]
    pub(crate) odometry_noise: Vec<f64>,
    /// Robot, for `home`; give it again for more [default: all]
    #[arg(long = "robot", value_name = "NAME", value_parser = PossibleValuesParser::new(Robot::NAMES))]
    pub(crate) robots: Vec<String>,
    /// What happens to the building, for `home`; give it again for more [default: all]
    #[arg(long = "setting", value_name = "NAME",
        value_parser = PossibleValuesParser::new(Setting::ALL.map(Setting::name)))]
    pub(crate) settings: Vec<String>,
    /// Who finds the way, for `home`; give it again for more [default: all]
    #[arg(long = "strategy", value_name = "NAME",
        value_parser = PossibleValuesParser::new(Strategy::names()))]
    pub(crate) strategies: Vec<String>,
    /// Directory for runs.csv and summary.json; made if it is missing. Without it only the tables
    /// are shown
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Replace the files of an earlier run in DIR
    #[arg(long, requires = "out")]
    pub(crate) force: bool,
}

/// `cogmap figures`.
#[derive(Debug, Args)]
pub(crate) struct FiguresArguments {
    /// Numbers of figures, such as 3.14 [default: all]
    #[arg(value_name = "ID")]
    pub(crate) ids: Vec<String>,
    /// Directory for the figures; made if it is missing
    #[arg(long, value_name = "DIR", default_value = "figures")]
    pub(crate) out: PathBuf,
    /// Everything random in the drives comes from it
    #[arg(long, value_name = "N", default_value = "1", value_parser = seed, allow_negative_numbers = true)]
    pub(crate) seed: u64,
    /// Light lines on a dark ground
    #[arg(long)]
    pub(crate) dark: bool,
    /// Only say which figures there are
    #[arg(long)]
    pub(crate) list: bool,
}

/// `cogmap check`.
#[derive(Debug, Args)]
pub(crate) struct CheckArguments {
    /// Worlds, floor plans, logs and sessions
    #[arg(value_name = "FILE", required = true)]
    pub(crate) files: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) picture: PictureArguments,
}

/// How large a plain picture is.
#[derive(Debug, Args)]
pub(crate) struct PictureArguments {
    /// Metres a pixel, for a picture without a map_server file
    #[arg(long, value_name = "M", value_parser = resolution, allow_negative_numbers = true)]
    pub(crate) resolution: Option<f64>,
}

/// Which mappers.
#[derive(Debug, Args)]
pub(crate) struct MapperArguments {
    /// Mapper to feed with the readings: perceptual (the thesis to the letter), consensus (ours),
    /// transform (the traditional one), odometry (the wheels alone); give it again for more
    /// mappers on the same run [default: consensus, or those of the session]
    #[arg(long = "mapper", value_name = "NAME",
        value_parser = PossibleValuesParser::new(MapperSetup::NAMES))]
    pub(crate) names: Vec<String>,
}

/// Where the files go.
#[derive(Debug, Args)]
pub(crate) struct OutputArguments {
    /// Directory for the map, the trajectories, the events, the session; made if it is missing.
    /// Without it only the summary is shown
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Replace the files of an earlier run in DIR
    #[arg(long, requires = "out")]
    pub(crate) force: bool,
    /// In the .tum files a row for every odometry record, not only for every scan
    #[arg(long, requires = "out")]
    pub(crate) dense: bool,
}

fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("not a number from 0 to {}", u64::MAX))
}

fn first_seed(text: &str) -> Result<u64, String> {
    const MOST: u64 = u64::MAX / 8;
    seed(text).ok().filter(|seed| *seed <= MOST).ok_or_else(|| format!("not a number from 0 to {MOST}"))
}

fn above_zero(text: &str) -> Result<f64, String> {
    match number(text)? {
        value if value > 0.0 => Ok(value),
        _ => Err("give a number above 0".into()),
    }
}

fn resolution(text: &str) -> Result<f64, String> {
    let [low, high] = MapServer::RESOLUTIONS;
    match number(text)? {
        value if (low..=high).contains(&value) => Ok(value),
        _ => Err(format!("give the metres of a pixel, from {low} to {high}")),
    }
}

fn zero_or_above(text: &str) -> Result<f64, String> {
    match number(text)? {
        value if value >= 0.0 => Ok(value),
        _ => Err("give 0 (no noise) or a number above it".into()),
    }
}

fn number(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err("give a number such as 0.5".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_of_the_arguments_holds_together() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn the_default_mapper_and_the_default_strategy_exist() {
        assert!(MapperSetup::named(DEFAULT_MAPPER).is_some());
        assert!(Strategy::named(DEFAULT_STRATEGY).is_some());
    }

    #[test]
    fn every_command_explains_itself_with_an_example() {
        let mut root = Arguments::command();
        assert!(root.render_long_help().to_string().contains("Example: cogmap"));
        for command in root.get_subcommands_mut() {
            let help = command.render_long_help().to_string();
            assert!(help.contains(&format!("Example: cogmap {}", command.get_name())), "{help}");
        }
    }

    #[test]
    fn numbers_out_of_range_are_refused_with_a_hint() {
        for text in ["0", "-1", "nan", "inf", "1e999", "", "half"] {
            assert!(above_zero(text).is_err(), "{text}");
        }
        assert_eq!(zero_or_above("0"), Ok(0.0));
        assert!(zero_or_above("-0.1").is_err());
    }
}
