use cogmap_geometry::Segment;
use cogmap_mapping::memory::{Mfis, StoredSurface};

use super::{
    Drawing, Runs,
    draw::ring,
    maps::{map_of, off_in_the_end, off_in_words, one, plan_of},
    outings::{LARGE_BAD, LARGE_GOOD, SMALL_BAD, SMALL_GOOD},
    runs::Run,
};

const MAPPER: &str = "transform";

fn source(run: &Run) -> String {
    format!("the traditional mapper, {}", run.words())
}

/// Fig. 3.5.
pub(super) fn small_good(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&SMALL_GOOD)?;
    let outcome = format!("In the end it believes itself {} from where it is.", off_in_words(&run, MAPPER)?);
    Ok(one(map_of(&run, MAPPER), outcome, source(&run)))
}

/// Fig. 3.6.
pub(super) fn small_bad(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&SMALL_BAD)?;
    let (mapper, _) = run.mind(MAPPER)?;
    let mut scene = map_of(&run, MAPPER);
    let off = off_in_words(&run, MAPPER)?;
    let outcome = match longest_double(mapper.mfis()) {
        Some(double) => {
            let at = run.world_from_map() * double;
            scene.changing.push(ring(at.midpoint(), 0.5 * at.length() + 0.15));
            format!("The longest such is encircled. In the end it believes itself {off} from where it is.")
        }
        None => format!("In this run there is none. In the end it believes itself {off} from where it is."),
    };
    Ok(one(scene, outcome, source(&run)))
}

/// Two surfaces of a map are one thing within this, metres …
const NEAR: f64 = 0.35;
/// … and turned no more than this, radians …
const TURNED: f64 = 0.2;
/// … if both are at least so long, metres.
const LENGTH: f64 = 0.45;

/// The longest surface that lies along an older one and yet was stored.
fn longest_double(mfis: &Mfis) -> Option<Segment> {
    let long = || mfis.surfaces().iter().filter(|surface| surface.segment.length() >= LENGTH);
    let lies_along = |old: &StoredSurface, new: &StoredSurface| {
        let (old, new) = (mfis.in_map(old), mfis.in_map(new));
        old.distance_to(new.midpoint()) < NEAR && old.angle_to(new) < TURNED
    };
    let doubles = long().filter(|new| long().any(|old| old.step < new.step && lies_along(old, new)));
    doubles.map(|surface| mfis.in_map(surface)).max_by(|a, b| a.length().total_cmp(&b.length()))
}

/// Fig. 3.7.
pub(super) fn large_plan(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&LARGE_GOOD)?;
    let steps = run.mind(MAPPER)?.1.reports.len().saturating_sub(1);
    let outcome = format!("It is {:.0} m long and took {steps} steps.", run.length());
    Ok(one(plan_of(&run), outcome, run.words()))
}

/// Fig. 3.8.
pub(super) fn large_good(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&LARGE_GOOD)?;
    let off = off_in_words(&run, MAPPER)?;
    let outcome = format!("After {:.0} m the robot believes itself {off} from where it is.", run.length());
    Ok(one(map_of(&run, MAPPER), outcome, source(&run)))
}

/// A heading error below this is not what the thesis saw, almost 90°, in radians.
const ALMOST_A_RIGHT_ANGLE: f64 = 60.0 * cogmap_geometry::trig::PI / 180.0;

/// Fig. 3.9.
pub(super) fn large_bad(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&LARGE_BAD)?;
    let (_, radians) = off_in_the_end(&run, MAPPER)?;
    let off = off_in_words(&run, MAPPER)?;
    let mut outcome =
        format!("After {:.0} m the robot believes itself {off} from where it is.", run.length());
    if radians < ALMOST_A_RIGHT_ANGLE {
        outcome += " The thesis saw almost 90° and a triangle; this run is not as bad.";
    }
    Ok(one(map_of(&run, MAPPER), outcome, source(&run)))
}
