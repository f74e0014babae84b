use std::collections::VecDeque;

use cogmap_geometry::{DVec2, Metric, Pose, trig};
use cogmap_mapping::perception::Reading;

use serde::{Deserialize, Serialize};

mod sight;

use sight::{NEAR, Seen, Sight, sees_past};

/// What [`Vigilance`] goes by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct VigilanceParams {
    /// Half the width that must be free: the robot's radius and what the laser may err, metres …
    pub half_width: f64,
    /// … and so much more after a metre, metres: wheels that slip and differ lead the robot astray by a
    /// distance that grows as the way to the power of 1.5.
    pub astray: f64,
    /// Scans that are kept …
    pub scans: usize,
    /// … while odometry has moved by no more than this since, metres.
    pub reach: f64,
    /// Metres that are kept between the robot's edge and what is ahead.
    pub gap: f64,
    /// How hard the robot can brake, metres per second squared.
    pub braking: f64,
    /// Something that the last scan sees past by so much has gone away, metres; something that stands where
    /// an earlier one saw past by so much has come there by itself.
    pub gone: f64,
    /// Nobody comes nearer faster than this, metres per second; people stop for a robot that stands.
    pub walking: f64,
    /// Whoever moves nearer than this is let pass, metres.
    pub polite: f64,
}

impl Default for VigilanceParams {
    fn default() -> Self {
        Self {
            half_width: 0.26,
            astray: 0.05,
            scans: 24,
            reach: 1.0,
            gap: 0.05,
            braking: 0.8,
            gone: 0.25,
            walking: 1.2,
            polite: 1.0,
        }
    }
}

/// Watches where the robot is about to go, on scans alone: whatever the map says, nothing is run
/// into that was seen a moment ago. Ours; the thesis leaves it to its robot.
#[derive(Clone, Debug)]
pub struct Vigilance {
    params: VigilanceParams,
    sights: VecDeque<Sight>,
    /// Metres per second between the last two scans.
    speed: f64,
    /// Where the stretch that is driven began, in odometry's frame, and how long it was to be, metres.
    stretch: Option<(DVec2, f64)>,
    /// A scan of a moment ago, to tell what has moved since, and the metres to the nearest thing that has.
    before: VecDeque<Reading>,
    moving: Option<f64>,
}

/// The robot is farther on than when it last looked, and faster than it was on the mean, metres.
const LATE: f64 = 0.25;

/// How long before a scan that it is compared with was taken, seconds.
const MOMENT: f64 = 0.2;

/// Of scans that were taken nearer to each other than this, metres …
const SAME_PLACE: f64 = 0.1;
/// … and turned by less, radians, the middle one is not kept.
const SAME_VIEW: f64 = 20.0 * trig::PI / 180.0;

impl Vigilance {
    /// A watch that has seen nothing yet.
    #[must_use]
    pub fn new(params: &VigilanceParams) -> Self {
        Self {
            params: params.clone(),
            sights: VecDeque::new(),
            speed: 0.0,
            stretch: None,
            before: VecDeque::new(),
            moving: None,
        }
    }

    /// Takes a scan in.
    pub fn observe(&mut self, reading: &Reading) {
        let here = reading.odom_from_robot;
        self.speed = self.sights.back().map_or(0.0, |last| {
            let (way, time) = (last.odom_from_robot.from_here(here).position.x, reading.t - last.t);
            if time > 0.0 { way / time } else { 0.0 }
        });
        self.sights
            .retain(|sight| sight.odom_from_robot.position.distance(here.position) <= self.params.reach);
        for sight in &mut self.sights {
            sight.forget_what_is_gone(reading, self.params.gone);
        }
        self.moving = self.nearest_moving(reading);
        self.before.push_back(reading.clone());
        while self.before.get(1).is_some_and(|later| later.t <= reading.t - MOMENT) {
            self.before.pop_front();
        }
        self.sights.push_back(Sight::of(reading));
        self.thin();
    }

    /// Drops what tells little more than its neighbours, then the oldest.
    fn thin(&mut self) {
        if let [.., before, _, last] = self.sights.make_contiguous() {
            let moved = before.odom_from_robot.from_here(last.odom_from_robot);
            if moved.position.norm() < SAME_PLACE && moved.heading.abs() < SAME_VIEW {
                self.sights.remove(self.sights.len() - 2);
            }
        }
        if self.sights.len() > self.params.scans {
            self.sights.pop_front();
        }
    }

    /// How far the robot can travel straight on after a turn, metres, at most `wanted`, as far as what it
    /// saw lately goes: the swept disc touches no point.
    #[must_use]
    pub fn free_way(&self, turn: f64, wanted: f64) -> f64 {
        let Some(last) = self.sights.back() else { return 0.0 };
        let VigilanceParams { half_width, astray, gap, .. } = self.params;
        let ahead = last.odom_from_robot * Pose::new(0.0, 0.0, turn);
        let (origin, along) = (ahead.position, ahead.forward());
        let widest = half_width + astray * wanted * wanted.sqrt();
        let mut free = wanted;
        for &Seen { at, .. } in self.sights.iter().flat_map(|sight| &sight.points) {
            let seen = at - origin;
            let (x, y) = (along.dot(seen), along.perp_dot(seen).abs());
            if x <= 0.0 || y >= widest || x >= free + widest + gap {
                continue;
            }
            let way = x.min(wanted);
            let radius = half_width + astray * way * way.sqrt();
            if y < radius {
                free = free.min(x - (radius * radius - y * y).sqrt() - gap);
            }
        }
        free.max(0.0)
    }

    /// Metres to the nearest thing that stands where a scan of a moment ago saw free floor.
    fn nearest_moving(&self, reading: &Reading) -> Option<f64> {
        let before = self.before.iter().rev().find(|before| before.t <= reading.t - 0.5 * MOMENT)?;
        let odom_from_laser = |reading: &Reading| reading.odom_from_robot * reading.scan.robot_from_laser;
        let before_from_laser = odom_from_laser(before).from_here(odom_from_laser(reading));
        let moved = |beam: &usize| {
            let point = reading.scan.point(*beam).filter(|point| point.length() < NEAR);
            point.is_some_and(|point| sees_past(&before.scan, before_from_laser * point, self.params.gone))
        };
        let moving: Vec<usize> = (0..reading.scan.ranges.len()).filter(moved).collect();
        let pairs = moving.windows(2).filter(|pair| pair[1] == pair[0] + 1);
        pairs.filter_map(|pair| reading.scan.range(pair[0])).reduce(f64::min)
    }

    /// Whether somebody moves so near that the robot had better let him pass.
    #[must_use]
    pub fn somebody_passes(&self) -> bool {
        self.moving.is_some_and(|distance| distance < self.params.polite + self.params.half_width)
    }

    /// Whether nothing has come so near that the robot should brake; at rest nothing has.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        let VigilanceParams { braking, walking, half_width, .. } = self.params;
        let comes = self.speed * 0.5 + walking * (self.speed / braking + MOMENT) + half_width;
        if self.speed > 0.05 && self.moving.is_some_and(|distance| distance < comes) {
            return false;
        }
        let brakes = self.speed * self.speed / (2.0 * braking) + LATE;
        let needs = self.left().map_or(brakes, |left| left.min(brakes));
        self.speed <= 0.05 || self.free_way(0.0, needs) >= needs - self.params.gap
    }

    /// The robot is about to drive so far straight on, metres: before the end of that it need not brake for what
    /// stands beyond.
    pub fn expect(&mut self, travel: f64) {
        self.stretch = self.sights.back().map(|sight| (sight.odom_from_robot.position, travel));
    }

    /// Metres of the stretch that are still to be driven.
    fn left(&self) -> Option<f64> {
        let (from, travel) = self.stretch?;
        let here = self.sights.back()?.odom_from_robot.position;
        Some((travel - from.distance(here)).max(0.0))
    }
}

#[cfg(test)]
mod tests {
    use cogmap_mapping::perception::{Moment, Scan};

    use super::*;

    /// What a robot sees that stands at x and looks along it, with a wall across at 3 m and a post at 1.5 m.
    fn reading(t: f64, x: f64, post: Option<f64>) -> Reading {
        let ranges = (0..361).map(|beam| {
            let bearing = f64::from(beam - 180) * 0.5_f64.to_radians();
            let wall = (3.0 - x) / trig::cos(bearing).max(1e-9);
            post.filter(|_| bearing.abs() < 0.05).map_or(wall, |post| post - x).min(9.0)
        });
        let scan = Scan {
            robot_from_laser: Pose::IDENTITY,
            angle_min: -trig::FRAC_PI_2,
            angle_increment: 0.5_f64.to_radians(),
            range_max: 8.19,
            ranges: ranges.collect(),
            labels: Vec::new(),
        };
        Reading { t, odom_from_robot: Pose::new(x, 0.0, 0.0), moment: Moment::WithinStep, scan }
    }

    #[test]
    fn the_robot_stops_short_of_what_it_saw() {
        let mut vigilance = Vigilance::new(&VigilanceParams::default());
        assert_eq!(vigilance.free_way(0.0, 1.0), 0.0, "nothing seen is not nothing there");
        vigilance.observe(&reading(0.0, 0.0, Some(1.5)));
        let free = vigilance.free_way(0.0, 2.0);
        assert!(free > 1.0 && free < 1.5 - 0.25 - 0.05, "{free}");
        assert_eq!(vigilance.free_way(trig::FRAC_PI_2, 0.8), 0.8);
    }

    #[test]
    fn what_has_moved_on_is_no_longer_in_the_way() {
        let mut vigilance = Vigilance::new(&VigilanceParams::default());
        vigilance.observe(&reading(0.0, 0.0, Some(1.5)));
        vigilance.observe(&reading(1.0, 0.0, None));
        assert_eq!(vigilance.free_way(0.0, 2.0), 2.0);
    }

    #[test]
    fn whoever_walks_into_the_way_is_let_pass_and_a_wall_is_nobody() {
        let mut vigilance = Vigilance::new(&VigilanceParams::default());
        vigilance.observe(&reading(0.0, 0.0, None));
        vigilance.observe(&reading(0.5, 0.0, None));
        assert!(!vigilance.somebody_passes());
        vigilance.observe(&reading(1.0, 0.0, Some(1.0)));
        assert!(vigilance.somebody_passes());
        vigilance.observe(&reading(1.5, 0.0, Some(1.0)));
        vigilance.observe(&reading(2.0, 0.0, Some(1.0)));
        assert!(!vigilance.somebody_passes(), "he stands now");
    }

    #[test]
    fn a_fast_robot_brakes_for_what_a_slow_one_need_not_mind_yet() {
        let clear = |dt: f64| {
            let mut vigilance = Vigilance::new(&VigilanceParams::default());
            vigilance.observe(&reading(0.0, 0.0, Some(0.85)));
            vigilance.observe(&reading(dt, 0.1, Some(0.85)));
            vigilance.is_clear()
        };
        assert!(!clear(0.1) && clear(0.5));
    }

    #[test]
    fn a_robot_brakes_for_what_stands_on_its_stretch_and_not_for_what_stands_beyond() {
        let clear = |travel: f64| {
            let mut vigilance = Vigilance::new(&VigilanceParams::default());
            vigilance.observe(&reading(0.0, 0.0, Some(0.65)));
            vigilance.expect(travel);
            vigilance.observe(&reading(0.25, 0.1, Some(0.65)));
            vigilance.is_clear()
        };
        assert!(clear(0.3) && !clear(0.6));
    }
}
