use cogmap_geometry::{DVec2, Pose, Segment};

use crate::{Bounds, Role};

/// Something to draw: what it is and where it lies, metres, y up.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it is.
    pub role: Role,
    /// Where it lies.
    pub shape: Shape,
}

impl Item {
    /// An item of that role.
    #[must_use]
    pub fn new(role: Role, shape: Shape) -> Self {
        Self { role, shape }
    }
}

/// The form of an item.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Lines that do not hang together.
    Segments(Vec<Segment>),
    /// A line through all points.
    Polyline(Vec<DVec2>),
    /// A line through all points with an arrowhead at the last.
    Arrow(Vec<DVec2>),
    /// An area.
    Polygon(Vec<DVec2>),
    /// A round area: centre and radius.
    Disc(DVec2, f64),
    /// Places marked by the sign of their role.
    Signs(Vec<DVec2>),
    /// The footprint of a robot of that radius, with its heading.
    Robot(Pose, f64),
    /// Text around a point, left out where it is wider than so many metres.
    Label {
        /// The middle of the text.
        at: DVec2,
        /// One line.
        text: String,
        /// Metres.
        room: f64,
    },
}

/// A sample of the legend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sample {
    /// A line of that role.
    Line(Role),
    /// A line with an arrowhead.
    Arrow(Role),
    /// An area of that role.
    Area(Role),
    /// The sign of that role.
    Sign(Role),
    /// A robot of that role.
    Robot(Role),
    /// All colours from the first view to the last.
    Run,
    /// All colours from now to long ago.
    Age,
    /// Some of the colours of local spaces.
    Asrs,
    /// A node of the network.
    Node,
    /// An exit between its jambs.
    Exit,
    /// An exit that was only seen.
    SupposedExit,
    /// An edge of the network that closed a loop.
    ClosedLoop,
}

/// A line of the legend.
#[derive(Clone, Debug, PartialEq)]
pub struct LegendEntry {
    /// What is explained.
    pub sample: Sample,
    /// What it means.
    pub text: String,
}

impl LegendEntry {
    /// An entry that explains `sample`.
    #[must_use]
    pub fn new(sample: Sample, text: impl Into<String>) -> Self {
        Self { sample, text: text.into() }
    }
}

/// One description of the picture, whoever paints it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// What the picture shows, in a few words.
    pub title: String,
    /// Details for the line beneath.
    pub note: String,
    /// What stays as it is from one picture to the next, from the ground up; painters may keep it.
    pub still: Vec<Item>,
    /// What changes all the time, above the rest.
    pub changing: Vec<Item>,
    /// How many views the colours of [`Role::SurfaceOfView`] are spread over.
    pub views: usize,
    /// What the marks mean.
    pub legend: Vec<LegendEntry>,
}

impl Scene {
    /// The same scene seen from another frame.
    #[must_use]
    pub fn seen_from(mut self, other_from_this: Pose) -> Self {
        for item in self.still.iter_mut().chain(&mut self.changing) {
            item.shape.carry(other_from_this);
        }
        self
    }

    /// The smallest rectangle that holds everything but what the laser sees; `None` if that is nothing.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        let items = self.still.iter().chain(&self.changing);
        let lasting = items.filter(|item| !matches!(item.role, Role::LaserFan | Role::LaserHit));
        lasting.flat_map(|item| item.shape.extremes()).fold(None, Bounds::around)
    }
}

impl Shape {
    pub(crate) fn carry(&mut self, pose: Pose) {
        match self {
            Self::Segments(segments) => segments.iter_mut().for_each(|segment| *segment = pose * *segment),
            Self::Polyline(points) | Self::Arrow(points) | Self::Polygon(points) | Self::Signs(points) => {
                points.iter_mut().for_each(|point| *point = pose * *point);
            }
            Self::Disc(at, _) | Self::Label { at, .. } => *at = pose * *at,
            Self::Robot(robot, _) => *robot = pose * *robot,
        }
    }

    /// Points whose bounds are the shape's.
    fn extremes(&self) -> Vec<DVec2> {
        match self {
            Self::Segments(segments) => segments.iter().flat_map(|s| [s.a, s.b]).collect(),
            Self::Polyline(points) | Self::Arrow(points) | Self::Polygon(points) | Self::Signs(points) => {
                points.clone()
            }
            Self::Disc(center, radius) => vec![*center - *radius, *center + *radius],
            Self::Robot(pose, radius) => vec![pose.position - *radius, pose.position + *radius],
            Self::Label { at, .. } => vec![*at],
        }
    }
}
