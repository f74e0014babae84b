use crate::{
    Colour,
    palette::Palette,
    theme::{Sign, Style},
};

/// What a figure adds to the things themselves, to explain them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Annotation {
    /// A word beside a thing.
    Word,
    /// A length or an angle that is measured.
    Measure,
    /// A ring around what is worth a look, or a limit.
    Ring,
    /// A surface that was known before.
    Known,
    /// A surface that was just added.
    Added,
    /// Where a memory lacks something or has it wrong.
    Flaw,
    /// A movement, or a way to go.
    Movement,
    /// A line of sight.
    Sight,
    /// The edge of a plot.
    Axis,
    /// Lines that help to read a plot.
    Grid,
    /// A measured curve.
    Curve,
    /// A point of a curve that matters.
    Mark,
    /// What somebody points at …
    Pointed,
    /// … and what sets it off from what lies beside it.
    PointedRim,
    /// One of several curves in a plot, by its number.
    Series(usize),
}

impl Annotation {
    pub(crate) fn style(self, palette: &Palette) -> Style {
        let solid = Colour::solid;
        match self {
            Self::Word => Style::area(solid(palette.ink), None),
            Self::Measure => Style::line(solid(palette.warning), 1.5),
            Self::Ring => Style::line(solid(palette.warning), 1.75),
            Self::Known => Style::line(solid(palette.muted), 2.0),
            Self::Added => Style::line(solid(palette.added), 3.0),
            Self::Flaw => Style::line(solid(palette.warning), 3.0),
            Self::Movement => Style::line(solid(palette.robot), 2.0),
            Self::Sight => Style::line(solid(palette.laser).with_alpha(150), 1.0),
            Self::Axis => Style::line(solid(palette.muted), 1.0),
            Self::Grid => Style::line(solid(palette.hairline), 1.0),
            Self::Curve => Style::line(solid(palette.robot), 2.0),
            Self::Mark => Style::points(solid(palette.warning), Sign::Dot(4.5)),
            Self::Pointed => Style {
                fill: Some(solid(palette.robot)),
                sign: Sign::Square(3.5),
                ..Style::line(solid(palette.robot), 4.0)
            },
            Self::PointedRim => Style::line(solid(palette.paper), 8.0),
            Self::Series(number) => {
                let colour = solid(palette.asrs[number % palette.asrs.len()]);
                Style { fill: Some(colour), sign: Sign::Dot(3.0), ..Style::line(colour, 2.0) }
            }
        }
    }
}
