use crate::{
    Colour, Role,
    palette::Palette,
    theme::{Sign, Style},
};

/// What a thing in a picture of the way home is (§3.3). Green is what is seen and the way home, blue what
/// is assumed and the way out, as in the thesis's figures; what is only assumed is dashed too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HomingMark {
    /// Where the run began.
    Home,
    /// The way out.
    WayOut,
    /// The way home.
    WayHome,
    /// The part of a movement option that is seen (Fig. 3.25).
    Seen,
    /// The straight line from its end to home, which is only assumed.
    Assumed,
    /// An option that is not for choice.
    Barred,
    /// The part of the way on that was decided for (Fig. 3.28).
    Chosen,
    /// How the robot means to go on from there.
    InMind,
    /// What sets the two off from the surfaces beneath.
    Rim,
    /// A waypoint of the remembered route (Fig. 3.33).
    Waypoint,
    /// A surface that navigation does not trust (Fig. 3.29); the map keeps it.
    Forgotten,
}

impl HomingMark {
    pub(crate) fn style(self, palette: &Palette) -> Style {
        let solid = Colour::solid;
        let (green, blue) = (solid(palette.homeward), solid(palette.robot));
        match self {
            Self::Home => Style {
                sign: Sign::House(8.0),
                ..Style::area(solid(palette.ink), Some((solid(palette.room), 1.5)))
            },
            Self::WayOut => Style::line(blue.with_alpha(170), 1.5),
            Self::WayHome => Style::line(green, 2.0),
            Self::Seen => Style::line(green, 1.5),
            Self::Assumed => Style::line(blue.with_alpha(170), 1.0).dashed(),
            Self::Barred => Style::line(solid(palette.muted).with_alpha(150), 1.5).dashed(),
            Self::Chosen => Style::line(green, 3.0),
            Self::InMind => Style::line(blue, 2.0).dashed(),
            Self::Rim => Style::line(solid(palette.paper).with_alpha(200), 6.0),
            Self::Waypoint => {
                Style { sign: Sign::Diamond(4.0), ..Style::area(solid(palette.paper), Some((blue, 1.5))) }
            }
            Self::Forgotten => Style::line(solid(palette.muted).with_alpha(130), 1.0),
        }
    }
}

impl From<HomingMark> for Role {
    fn from(mark: HomingMark) -> Self {
        Self::Homing(mark)
    }
}
