use std::path::Path;

use cogmap_scene::{Picture, Plate, Theme, png, svg};
use cogmap_study::figures::{Figure, Runs};

use crate::arguments::FiguresArguments;
use crate::failure::Failure;
use crate::output::create;
use crate::progress;
use crate::terminal;

/// Pixels across a figure.
const WIDTH: f64 = 800.0;
/// Pixels of the PNG file to one of the figure.
const PIXEL_RATIO: f64 = 2.0;

/// `cogmap figures`.
pub(crate) fn figures(arguments: &FiguresArguments) -> Result<(), Failure> {
    let wanted = wanted(&arguments.ids)?;
    if arguments.list {
        return terminal::say(&list(&wanted));
    }
    create(&arguments.out)?;
    let theme = if arguments.dark { Theme::Dark } else { Theme::Light };
    let mut runs = Runs::new(arguments.seed);
    let bar = progress::bar(wanted.len() as u64, "figures");
    for figure in wanted {
        let plate =
            figure.draw(&mut runs).map_err(|why| Failure::run(format!("figure {}: {why}", figure.id)))?;
        write(figure, &plate, theme, &arguments.out)?;
        bar.suspend(|| terminal::say(&format!("{}\n", line(figure))))?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    terminal::say(&format!("in {}, each as SVG and PNG\n", arguments.out.display()))
}

/// The figures of those numbers in the order of the thesis; all where none is named.
fn wanted(ids: &[String]) -> Result<Vec<&'static Figure>, Failure> {
    if let Some(unknown) = ids.iter().find(|id| Figure::of(id).is_none()) {
        let known: Vec<&str> = Figure::all().map(|figure| figure.id).collect();
        return Err(Failure::input(format!("there is no figure `{unknown}`"))
            .help(format!("choose from {}", known.join(", "))));
    }
    let named = |figure: &&Figure| ids.is_empty() || ids.iter().any(|id| id == figure.id);
    Ok(Figure::all().filter(named).collect())
}

fn list(figures: &[&Figure]) -> String {
    figures.iter().map(|figure| line(figure) + "\n").collect()
}

fn line(figure: &Figure) -> String {
    format!("{:<5} {}", figure.id, figure.title)
}

fn write(figure: &Figure, plate: &Plate, theme: Theme, directory: &Path) -> Result<(), Failure> {
    for (name, content) in files(figure.id, plate, theme)? {
        let path = directory.join(name);
        std::fs::write(&path, content).map_err(|error| Failure::unwritable(&path, &error))?;
    }
    Ok(())
}

/// A plate as SVG and PNG.
pub(crate) fn files(name: &str, plate: &Plate, theme: Theme) -> Result<[(String, Vec<u8>); 2], Failure> {
    let picture: Picture = plate.picture(WIDTH, theme);
    let drawing = svg::document(&picture, &plate.title, &plate.caption);
    let pixels = png::file(&picture, PIXEL_RATIO)
        .ok_or_else(|| Failure::run(format!("figure {name}: too large for a PNG file")))?;
    Ok([(format!("{name}.svg"), drawing.into_bytes()), (format!("{name}.png"), pixels)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_numbers_all_figures_are_wanted() {
        assert_eq!(wanted(&[]).unwrap().len(), Figure::all().count());
    }

    #[test]
    fn an_unknown_number_is_refused_with_those_that_exist() {
        let failure = wanted(&["3.99".to_owned()]).err().unwrap();
        assert_eq!(failure.exit_code(), std::process::ExitCode::from(2));
        assert!(failure.to_string().contains("3.10, 3.11"), "{failure}");
    }
}
