use lexopt::prelude::{Long, Short, Value, ValueExt};

use crate::steps;

/// The port that `demo` listens on unless told otherwise.
pub(crate) const DEFAULT_PORT: u16 = 8080;

/// What `cargo xtask --help` prints.
pub(crate) const USAGE: &str = "\
Usage: cargo xtask <COMMAND>

  demo [--port N] [--build-only]  build the page and serve it on 127.0.0.1
                                  (port 8080 unless told otherwise; 0 takes any free port)
  test [STEP]...                  run every check, or the chosen steps in the usual order
  test --list                     print the steps

Both install what is missing first.

Example: cargo xtask demo --port 9000
Example: cargo xtask test fmt clippy";

/// What the command line asks for.
#[derive(Debug, PartialEq)]
pub(crate) enum Request {
    Help,
    ListSteps,
    /// The names of the chosen steps; none means all of them.
    Test(Vec<String>),
    Demo(DemoOptions),
}

/// How to run `demo`.
#[derive(Debug, PartialEq)]
pub(crate) struct DemoOptions {
    pub(crate) port: u16,
    pub(crate) build_only: bool,
}

/// Reads the command line.
pub(crate) fn parse(mut parser: lexopt::Parser) -> Result<Request, lexopt::Error> {
    match parser.next()? {
        None | Some(Long("help") | Short('h')) => Ok(Request::Help),
        Some(Value(command)) if command == "help" => Ok(Request::Help),
        Some(Value(command)) if command == "test" => parse_test(parser),
        Some(Value(command)) if command == "demo" => parse_demo(parser),
        Some(other) => Err(other.unexpected()),
    }
}

fn parse_test(mut parser: lexopt::Parser) -> Result<Request, lexopt::Error> {
    let mut chosen = Vec::new();
    while let Some(argument) = parser.next()? {
        match argument {
            Long("list") => return Ok(Request::ListSteps),
            Long("help") | Short('h') => return Ok(Request::Help),
            Value(step) => chosen.push(known_step(step.string()?)?),
            other => return Err(other.unexpected()),
        }
    }
    Ok(Request::Test(chosen))
}

fn known_step(name: String) -> Result<String, lexopt::Error> {
    if steps::exists(&name) {
        return Ok(name);
    }
    let message = format!("there is no step `{name}`: `cargo xtask test --list` prints them");
    Err(message.into())
}

fn parse_demo(mut parser: lexopt::Parser) -> Result<Request, lexopt::Error> {
    let mut options = DemoOptions { port: DEFAULT_PORT, build_only: false };
    while let Some(argument) = parser.next()? {
        match argument {
            Long("port") => options.port = parser.value()?.parse()?,
            Long("build-only") => options.build_only = true,
            Long("help") | Short('h') => return Ok(Request::Help),
            other => return Err(other.unexpected()),
        }
    }
    Ok(Request::Demo(options))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(arguments: &[&str]) -> Result<Request, String> {
        parse(lexopt::Parser::from_args(arguments)).map_err(|error| error.to_string())
    }

    fn demo(port: u16, build_only: bool) -> Result<Request, String> {
        Ok(Request::Demo(DemoOptions { port, build_only }))
    }

    #[test]
    fn demo_serves_on_the_default_port_unless_told_otherwise() {
        assert_eq!(parsed(&["demo"]), demo(DEFAULT_PORT, false));
        assert_eq!(parsed(&["demo", "--port", "9000"]), demo(9000, false));
        assert_eq!(parsed(&["demo", "--build-only"]), demo(DEFAULT_PORT, true));
    }

    #[test]
    fn chosen_steps_must_exist() {
        let chosen = vec!["fmt".to_owned(), "doc".to_owned()];
        assert_eq!(parsed(&["test", "fmt", "doc"]), Ok(Request::Test(chosen)));
        assert!(parsed(&["test", "fmmt"]).is_err_and(|error| error.contains("--list")));
    }

    #[test]
    fn nonsense_is_an_error_and_no_argument_asks_for_help() {
        assert_eq!(parsed(&[]), Ok(Request::Help));
        for nonsense in
            [&["serve"][..], &["demo", "--port", "70000"], &["demo", "--port"], &["test", "--nope"]]
        {
            assert!(parsed(nonsense).is_err(), "{nonsense:?}");
        }
    }
}
