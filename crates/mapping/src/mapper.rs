//! The step that joins the rooms: a reading in, a report out.

use cogmap_geometry::Pose;
use serde::{Deserialize, Serialize};

use crate::{
    memory::{Consensus, ConsensusParams, FrameId, Memory, Mfis, Perceptual, PerceptualParams, SurfaceId},
    perception::Reading,
    places::{Network, Places},
    report::StepReport,
    traditional::{Odometry, OdometryParams, Transform, TransformParams},
};

/// Which mapper, with every parameter that it uses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "mapper", rename_all = "snake_case")]
#[allow(clippy::large_enum_variant, reason = "there are a few a session")]
pub enum MapperSetup {
    /// Yeap's perceptual mapping as the thesis programs it (§3.2.1), to the letter.
    Perceptual(PerceptualParams),
    /// Ours: all recognised surfaces together say where the robot is.
    Consensus(Box<ConsensusParams>),
    /// The traditional algorithm: views put together by a corrected movement (§3.1).
    Transform(TransformParams),
    /// Views put together by odometry alone (§3.1.2 without §3.1.3's correction).
    Odometry(OdometryParams),
}

impl MapperSetup {
    /// The names that [`MapperSetup::named`] knows.
    pub const NAMES: [&'static str; 4] = ["perceptual", "consensus", "transform", "odometry"];

    /// The mapper of that name with its default parameters.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "perceptual" => Some(Self::Perceptual(PerceptualParams::default())),
            "consensus" => Some(Self::Consensus(Box::default())),
            "transform" => Some(Self::Transform(TransformParams::default())),
            "odometry" => Some(Self::Odometry(OdometryParams::default())),
            _ => None,
        }
    }

    /// The name under which it is chosen.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Perceptual(_) => "perceptual",
            Self::Consensus(_) => "consensus",
            Self::Transform(_) => "transform",
            Self::Odometry(_) => "odometry",
        }
    }
}

/// Where the robot believed it was when it took a view.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathPoint {
    /// Number of the view.
    pub step: usize,
    /// Seconds.
    pub t: f64,
    /// The local frame that the robot was in.
    pub frame: FrameId,
    /// Where it was in that frame.
    pub frame_from_robot: Pose,
}

/// A mapper at work: the one way in is [`Mapper::observe`].
#[derive(Clone, Debug)]
pub struct Mapper {
    mind: Mind,
    /// The mappers of the theory share their map out among local spaces; the traditional ones do not.
    places: Option<Places>,
}

#[derive(Clone, Debug)]
enum Mind {
    /// §3.2.1.
    Perceptual(Box<Perceptual>),
    /// Ours.
    Consensus(Box<Consensus>),
    /// §3.1.3.
    Transform(Transform),
    /// §3.1.2.
    Odometry(Odometry),
}

impl Mapper {
    /// A mapper with an empty memory; what is random in it comes from `seed`.
    #[must_use]
    pub fn new(setup: &MapperSetup, seed: u64) -> Self {
        let (mind, places) = match setup {
            MapperSetup::Perceptual(params) => {
                (Mind::Perceptual(Box::new(Perceptual::new(params))), Some(Places::new(&params.places)))
            }
            MapperSetup::Consensus(params) => {
                (Mind::Consensus(Box::new(Consensus::new(params))), Some(Places::new(&params.places)))
            }
            MapperSetup::Transform(params) => (Mind::Transform(Transform::new(params, seed)), None),
            MapperSetup::Odometry(params) => (Mind::Odometry(Odometry::new(params)), None),
        };
        Self { mind, places }
    }

    /// Takes a reading in; `None` where the mapper lets it pass (views are taken at the ends of
    /// steps, and by distance while a person drives).
    pub fn observe(&mut self, reading: &Reading) -> Option<StepReport> {
        // §3.2.1: the view becomes part of the map …
        let mut report = match &mut self.mind {
            Mind::Perceptual(mapper) => mapper.observe(reading),
            Mind::Consensus(mapper) => Some(mapper.observe(reading)),
            Mind::Transform(mapper) => mapper.observe(reading),
            Mind::Odometry(mapper) => mapper.observe(reading),
        }?;
        if let Some(places) = &mut self.places {
            // … §3.2.2: the map is shared out among local spaces …
            report.place = Some(places.follow(&report, self.mind.memory()));
            // … §2.2.2: and memory may reach no farther than the last few of them.
            report.forgot = self.mind.forget(places.network());
        }
        Some(report)
    }

    /// What it remembers: the map and the path.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        self.mind.memory()
    }

    /// The local spaces and exits that it found; `None` for the traditional mappers, which know none.
    #[must_use]
    pub fn network(&self) -> Option<&Network> {
        self.places.as_ref().map(Places::network)
    }

    /// Whether it only ever adds up what the wheels say.
    #[must_use]
    pub fn is_odometry(&self) -> bool {
        matches!(self.mind, Mind::Odometry(_))
    }

    /// The map.
    #[must_use]
    pub fn mfis(&self) -> &Mfis {
        self.memory().mfis()
    }

    /// Where each view was taken, oldest first.
    #[must_use]
    pub fn path(&self) -> &[PathPoint] {
        self.memory().path()
    }

    /// Where the robot is in the map when odometry stands at `odom_from_robot`: the last view's
    /// place, and odometry since then. `None` before the first view.
    #[must_use]
    pub fn map_from_robot(&self, odom_from_robot: Pose) -> Option<Pose> {
        let (frame, frame_from_robot) = self.frame_from_robot(odom_from_robot)?;
        Some(self.mfis().map_from_frame(frame) * frame_from_robot)
    }

    /// The same in the local frame that the robot is in.
    #[must_use]
    pub fn frame_from_robot(&self, odom_from_robot: Pose) -> Option<(FrameId, Pose)> {
        let last = self.path().last()?;
        Some((last.frame, last.frame_from_robot * self.memory().moved_to(odom_from_robot)?))
    }
}

impl Mind {
    fn forget(&mut self, network: &Network) -> Vec<SurfaceId> {
        match self {
            Self::Perceptual(mapper) => mapper.forget(network),
            Self::Consensus(_) | Self::Transform(_) | Self::Odometry(_) => Vec::new(),
        }
    }

    fn memory(&self) -> &Memory {
        match self {
            Self::Perceptual(mapper) => mapper.memory(),
            Self::Consensus(mapper) => mapper.memory(),
            Self::Transform(mapper) => mapper.memory(),
            Self::Odometry(mapper) => mapper.memory(),
        }
    }
}
