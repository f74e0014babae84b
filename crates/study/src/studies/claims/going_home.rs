use cogmap_simulation::{Robot, Strategy};

use super::{Asked, consensus, perceptual};
use crate::{Bound, Check, Condition, Course, Ground, Group, Outing, Treatment, metrics::Rate, world};

/// The thesis's experiments: round a corner, by a shortcut, through boxes (§3.3.5); and a dead end that
/// faces home (§3.3.3).
const WORLDS: [&str; 4] = ["around-a-corner", "shortcut", "box-course", "u-trap"];

/// Ways home by what each form remembers and in its own way.
pub(super) fn conditions(robots: &[Robot]) -> Result<Vec<Condition>, String> {
    let course = |name: &&str| Ok(Outing::Course(Course::through(&world(name)?, "tour")?));
    let mut outings = WORLDS.iter().map(course).collect::<Result<Vec<Outing>, String>>()?;
    outings.push(Outing::Floors);
    let strategy = |name| Strategy::named(name).ok_or_else(|| format!("there is no strategy `{name}`"));
    let forms =
        vec![perceptual().homing(strategy("faithful")?), consensus().homing(strategy("recommended")?)];
    let with = |outing: &Outing, robot: &Robot| Condition {
        ground: Ground::WayHome { outing: outing.clone(), robot: robot.clone() },
        treatment: Treatment::default(),
        mappers: forms.clone(),
        times: 1,
    };
    Ok(outings.iter().flat_map(|outing| robots.iter().map(move |robot| with(outing, robot))).collect())
}

impl<'a> Asked<'a> {
    fn ways_home(&self) -> impl Iterator<Item = Group<'a>> {
        self.outcome.groups_of(self.robot, self.form).filter(|group| group.of().goes_home())
    }

    /// C5, place by place; shortcuts and dead ends wherever there were any.
    pub(super) fn goes_home(&self) -> Vec<Check> {
        let reached = |group: Group<'_>| {
            let criterion = format!(
                "{}: stops by itself within 1.5 m of its start, nothing touched, in at least 95 % of runs",
                group.of().place()
            );
            Check::share(criterion, group.figure_of("home_reached"), Bound::AtLeast(0.95))
        };
        let mut checks: Vec<Check> = self.ways_home().map(reached).collect();
        for (measure, criterion) in [
            ("shortcut_taken", "where there is a shortcut, takes it in at least 95 % of runs"),
            ("dead_ends_left", "where it meets a dead end, comes home all the same in at least 95 % of runs"),
        ] {
            checks.push(Check::rate(criterion, self.wherever(measure), Bound::AtLeast(0.95)));
        }
        checks
    }

    /// C6, place by place.
    pub(super) fn rarely_needs_help(&self) -> Vec<Check> {
        let helped = |group: Group<'_>| {
            let criterion = format!("{}: needs its user in at most 5 % of runs", group.of().place());
            Check::share(criterion, group.figure_of("help_needed"), Bound::AtMost(0.05))
        };
        self.ways_home().map(helped).collect()
    }

    /// How often something came to pass, all places together.
    fn wherever(&self, measure: &str) -> Rate {
        self.ways_home().fold(Rate::default(), |sum, group| {
            let rate = group.rate(|values| values.get(measure).map(|value| value > 0.0));
            Rate { hits: sum.hits + rate.hits, runs: sum.runs + rate.runs }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Outcome, Seeds, Verdict, runner, studies::robots};

    #[test]
    fn both_forms_are_sent_home_and_judged_by_where_they_come_to() {
        let all = conditions(&robots(&["good", "bad"])).unwrap();
        let place = |condition: &Condition| (condition.place().to_owned(), condition.robot().to_owned());
        assert_eq!(all.len(), 10);
        assert_eq!(place(&all[0]), ("Around a corner".to_owned(), "good".to_owned()));
        assert_eq!(place(&all[9]), ("generated floors".to_owned(), "bad".to_owned()));
        let conditions = all[..1].to_vec();
        let rows = runner::run(&conditions, Seeds { first: 1, count: 2 }, 1, || {}).unwrap();
        let outcome = Outcome { conditions, rows };
        for form in ["perceptual", "consensus"] {
            let asked = Asked { outcome: &outcome, robot: "good", form, shape: form };
            let [home, help] = [&asked.goes_home()[0], &asked.rarely_needs_help()[0]];
            assert!(home.met && help.met, "{form}: {home:?} {help:?}");
            assert_eq!(home.verdict, Verdict::Undecided, "two runs decide nothing");
            let group = asked.ways_home().next().unwrap();
            assert!(group.values("home_distance").iter().all(|metres| *metres < 0.6), "{form}");
        }
    }
}
