use serde::{Deserialize, Serialize};

use crate::{
    Colour, Role,
    palette::{DARK, LIGHT, Palette},
};

/// Which ground the picture stands on. Every colour of every picture comes from here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Theme {
    /// Dark lines on light paper: print and projectors.
    #[default]
    Light,
    /// Light lines on a dark ground.
    Dark,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub colour: Colour,
    /// Pixels.
    pub width: f64,
}

/// The sign that marks a single place; its size does not depend on the scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sign {
    /// A round dot of that radius, pixels.
    Dot(f64),
    /// A square on its corner.
    Diamond(f64),
    /// A triangle on its base.
    Triangle(f64),
}

/// How a thing is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// What its area is filled with.
    pub fill: Option<Colour>,
    /// What its outline is drawn with.
    pub stroke: Option<Stroke>,
    /// What marks its points, where it is a set of points.
    pub sign: Sign,
}

impl Theme {
    pub(crate) fn palette(self) -> &'static Palette {
        match self {
            Self::Light => &LIGHT,
            Self::Dark => &DARK,
        }
    }

    /// The ground of the picture.
    #[must_use]
    pub fn paper(self) -> Colour {
        Colour::solid(self.palette().paper)
    }

    /// The colour of the surfaces that a view saw first, a share of the way through the run.
    #[must_use]
    pub fn of_run(self, share: f64) -> Colour {
        self.palette().ramp.at(share)
    }

    /// What a thing looks like in a run of `views` views, at so many pixels a metre.
    #[must_use]
    pub fn style(self, role: Role, views: usize, pixels_per_metre: f64) -> Style {
        let palette = self.palette();
        let share = |view: usize| view as f64 / (views.max(2) - 1) as f64;
        let solid = Colour::solid;
        match role {
            Role::Room => Style::area(solid(palette.room), None),
            Role::RoomLabel => Style::area(solid(palette.muted), None),
            Role::Wall => Style::line(solid(palette.ink), (pixels_per_metre * 0.05).clamp(1.25, 3.0)),
            Role::Furniture => {
                Style::area(solid(palette.furniture), Some((solid(palette.furniture_edge), 1.0)))
            }
            Role::Door => Style::line(solid(palette.door), (pixels_per_metre * 0.05).clamp(1.5, 3.0)),
            Role::DoorSwing => Style::line(solid(palette.door).with_alpha(96), 1.0),
            Role::TruePath => Style::line(solid(palette.robot).with_alpha(170), 1.5),
            Role::Robot => Style::area(solid(palette.robot), Some((solid(palette.room), 1.5))),
            Role::LaserFan => Style::area(solid(palette.laser).with_alpha(22), None),
            Role::LaserHit => Style::points(solid(palette.laser), Sign::Dot(1.25)),
            Role::Truth => Style::line(solid(palette.truth), 1.0),
            Role::SurfaceOfView(view) => {
                Style::line(self.of_run(share(view)), (pixels_per_metre * 0.04).clamp(1.0, 2.5))
            }
            Role::DebrisOfView(view) => Style::line(self.of_run(share(view)), 0.75),
            Role::SeenNow => Style::line(solid(palette.robot).with_alpha(90), 6.0),
            Role::ReferenceKnown => Style::line(solid(palette.reference).with_alpha(90), 9.0),
            Role::ReferenceSeen => Style::line(solid(palette.reference), 2.0),
            Role::Path => Style::line(solid(palette.muted), 1.0),
            Role::PathStep => Style::points(solid(palette.muted), Sign::Dot(1.75)),
            Role::WeakPlacement => Style::points(solid(palette.warning), Sign::Diamond(4.5)).hollow(palette),
            Role::FallbackPlacement => Style::points(solid(palette.warning), Sign::Triangle(4.5)),
            Role::BelievedRobot => Style::area(solid(palette.room), Some((solid(palette.robot), 2.0))),
        }
    }
}

impl Style {
    fn line(colour: Colour, width: f64) -> Self {
        Self { fill: None, stroke: Some(Stroke { colour, width }), sign: Sign::Dot(width) }
    }

    fn area(fill: Colour, edge: Option<(Colour, f64)>) -> Self {
        let stroke = edge.map(|(colour, width)| Stroke { colour, width });
        Self { fill: Some(fill), stroke, sign: Sign::Dot(1.0) }
    }

    fn points(fill: Colour, sign: Sign) -> Self {
        Self { fill: Some(fill), stroke: None, sign }
    }

    fn hollow(self, palette: &Palette) -> Self {
        let stroke = self.fill.map(|colour| Stroke { colour, width: 1.5 });
        Self { fill: Some(Colour::solid(palette.paper)), stroke, ..self }
    }
}
