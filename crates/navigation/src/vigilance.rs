use std::collections::VecDeque;

use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::perception::Reading;
use serde::{Deserialize, Serialize};

/// What [`Vigilance`] goes by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct VigilanceParams {
    /// Half the width that must be free ahead: the robot's radius and a margin, metres.
    pub half_width: f64,
    /// Scans that are kept …
    pub scans: usize,
    /// … while odometry has moved by no more than this since, metres.
    pub reach: f64,
    /// Metres that are kept between the robot's edge and what is ahead.
    pub gap: f64,
}

impl Default for VigilanceParams {
    fn default() -> Self {
        Self { half_width: 0.29, scans: 24, reach: 1.0, gap: 0.06 }
    }
}

/// Watches where the robot is about to go, on scans alone: whatever the map says, nothing is run
/// into that was seen a moment ago. Ours; the thesis leaves it to its robot.
#[derive(Clone, Debug)]
pub struct Vigilance {
    params: VigilanceParams,
    sights: VecDeque<Sight>,
}

/// The points of a scan, in the odometry's frame; over so short a way odometry does not drift.
#[derive(Clone, Debug)]
struct Sight {
    odom_from_robot: Pose,
    points: Vec<DVec2>,
}

impl Vigilance {
    /// A watch that has seen nothing yet.
    #[must_use]
    pub fn new(params: &VigilanceParams) -> Self {
        Self { params: params.clone(), sights: VecDeque::new() }
    }

    /// Takes a scan in.
    pub fn observe(&mut self, reading: &Reading) {
        let odom_from_laser = reading.odom_from_robot * reading.scan.robot_from_laser;
        let points = (0..reading.scan.ranges.len())
            .filter_map(|beam| reading.scan.point(beam))
            .map(|point| odom_from_laser * point);
        let sight = Sight { odom_from_robot: reading.odom_from_robot, points: points.collect() };
        self.sights.push_back(sight);
        let here = reading.odom_from_robot.position;
        while self.sights.len() > self.params.scans
            || self
                .sights
                .front()
                .is_some_and(|sight| sight.odom_from_robot.position.distance(here) > self.params.reach)
        {
            self.sights.pop_front();
        }
    }

    /// How far the robot can travel straight on after a turn, metres, at most `wanted`, as far as what it
    /// saw lately goes: the swept disc touches no point.
    #[must_use]
    pub fn free_way(&self, turn: f64, wanted: f64) -> f64 {
        let Some(last) = self.sights.back() else { return 0.0 };
        let ahead = last.odom_from_robot * Pose::new(0.0, 0.0, turn);
        let robot_from_odom = ahead.inverse();
        let radius = self.params.half_width;
        let mut free = wanted;
        for point in self.sights.iter().flat_map(|sight| &sight.points) {
            let seen = robot_from_odom * *point;
            if seen.x > 0.0 && seen.y.abs() < radius && seen.x < free + radius + self.params.gap {
                let touch = seen.x - (radius * radius - seen.y * seen.y).sqrt() - self.params.gap;
                free = free.min(touch);
            }
        }
        free.max(0.0)
    }
}
