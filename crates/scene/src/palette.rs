use crate::ramp::{ON_DARK, ON_LIGHT, Ramp};

/// The few colours of a theme, as numbers such as `0xff8800`.
pub(crate) struct Palette {
    /// The ground.
    pub(crate) paper: u32,
    /// The floor of a room, and rims that set things off from it.
    pub(crate) room: u32,
    /// What matters most: walls, titles.
    pub(crate) ink: u32,
    /// Text and lines that stand back.
    pub(crate) muted: u32,
    /// Borders.
    pub(crate) hairline: u32,
    /// Boxes and posts.
    pub(crate) furniture: u32,
    /// Their outline.
    pub(crate) furniture_edge: u32,
    /// Doors.
    pub(crate) door: u32,
    /// People.
    pub(crate) person: u32,
    /// What the laser sees.
    pub(crate) laser: u32,
    /// The robot and its way.
    pub(crate) robot: u32,
    /// The reference pair.
    pub(crate) reference: u32,
    /// Placements to distrust.
    pub(crate) warning: u32,
    /// What was just added.
    pub(crate) added: u32,
    /// What is seen to be free, and the way home.
    pub(crate) homeward: u32,
    /// The world laid over a memory.
    pub(crate) truth: u32,
    /// Local spaces: far apart to every eye, also to those that do not tell red from green.
    pub(crate) asrs: [u32; 8],
    /// The run, first view to last.
    pub(crate) ramp: Ramp,
}

pub(crate) const LIGHT: Palette = Palette {
    paper: 0xf8f7f4,
    room: 0xffffff,
    ink: 0x1c2027,
    muted: 0x5a616e,
    hairline: 0xdedbd3,
    furniture: 0xefece5,
    furniture_edge: 0x8f897c,
    door: 0x8a5a2b,
    person: 0x7c3a9c,
    laser: 0xd9480f,
    robot: 0x1f5fd6,
    reference: 0xd0146c,
    warning: 0xc2410c,
    added: 0x15803d,
    homeward: 0x0b7a4b,
    truth: 0xb9b5aa,
    asrs: [0x005cd2, 0xf6570f, 0x049e7a, 0xa03488, 0x884d00, 0x121479, 0x780a37, 0x4493d9],
    ramp: ON_LIGHT,
};

pub(crate) const DARK: Palette = Palette {
    paper: 0x14171c,
    room: 0x1b1f26,
    ink: 0xe8ebf0,
    muted: 0x9aa3b2,
    hairline: 0x2c323c,
    furniture: 0x272c35,
    furniture_edge: 0x737d8e,
    door: 0xd2a06a,
    person: 0xc79bff,
    laser: 0xff9f45,
    robot: 0x6aa5ff,
    reference: 0xff62aa,
    warning: 0xff8f5a,
    added: 0x4ade80,
    homeward: 0x3ddc97,
    truth: 0x4c5462,
    asrs: [0x2faaff, 0xff8e1d, 0x05c881, 0xd370bb, 0xe4dc3c, 0x7e68fe, 0xc6584e, 0x67d2e1],
    ramp: ON_DARK,
};
