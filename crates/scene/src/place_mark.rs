use crate::{
    Colour, Theme,
    theme::{Sign, Style},
};

/// What a thing in a picture of the network of local spaces is; numbers are those of ASRs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaceMark {
    /// A surface that belongs to a local space.
    Surface(u32),
    /// The same for one too short to say much.
    Debris(u32),
    /// The floor of a local space.
    Floor(u32),
    /// A local space as a node of the network.
    Node(u32),
    /// The number of a local space.
    Number,
    /// An exit, from jamb to jamb.
    Exit,
    /// An exit that was seen, but not gone through yet.
    SupposedExit,
    /// What sets an exit off from the walls beside it.
    ExitRim,
    /// An edge of the network: from a local space through an exit to the next.
    Passage,
    /// An edge that closed a loop …
    ClosedLoop,
    /// … and the gap along its middle.
    ClosedLoopGap,
    /// The origin of a local frame.
    Frame,
    /// How two local frames lie to each other.
    Link,
    /// The same, known because a place was recognised.
    RecognisedLink,
}

impl PlaceMark {
    pub(crate) fn style(self, theme: Theme, pixels_per_metre: f64) -> Style {
        let palette = theme.palette();
        let solid = Colour::solid;
        match self {
            Self::Surface(asr) => Style::surface(theme.of_asr(asr), pixels_per_metre),
            Self::Debris(asr) => Style::debris(theme.of_asr(asr)),
            Self::Floor(asr) => {
                let colour = theme.of_asr(asr);
                Style::area(colour.with_alpha(30), Some((colour.with_alpha(90), 1.0)))
            }
            Self::Node(asr) => Style {
                sign: Sign::Dot((pixels_per_metre * 0.3).clamp(7.5, 9.0)),
                ..Style::area(solid(palette.room), Some((theme.of_asr(asr), 2.0)))
            },
            Self::Number => Style::area(solid(palette.ink), None),
            Self::Exit => Style {
                fill: Some(solid(palette.ink)),
                sign: Sign::Square(2.75),
                ..Style::line(solid(palette.ink), 2.0)
            },
            Self::SupposedExit => Style {
                fill: Some(solid(palette.paper)),
                sign: Sign::Square(2.25),
                ..Style::line(solid(palette.muted), 1.0)
            },
            Self::ExitRim => Style::line(solid(palette.paper), 6.0),
            Self::Passage => Style::line(solid(palette.ink).with_alpha(150), 1.5),
            Self::ClosedLoop => Style::line(solid(palette.ink), 5.0),
            Self::ClosedLoopGap => Style::line(solid(palette.paper), 2.0),
            Self::Frame => Style::points(solid(palette.muted), Sign::Square(2.5)),
            Self::Link => Style::line(solid(palette.muted).with_alpha(160), 1.0),
            Self::RecognisedLink => Style::line(solid(palette.reference), 2.0),
        }
    }
}
