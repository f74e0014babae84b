use cogmap_scene::Theme;
use serde::Deserialize;
use tsify::Tsify;

/// Light or dark.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Look {
    /// Dark lines on light paper.
    Light,
    /// Light lines on a dark ground.
    Dark,
}

impl From<Look> for Theme {
    fn from(look: Look) -> Self {
        match look {
            Look::Light => Self::Light,
            Look::Dark => Self::Dark,
        }
    }
}
