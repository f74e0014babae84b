mod going_home;

use super::{
    CONSENSUS, NO_RECOGNITION, PERCEPTUAL, TRANSFORM, consensus, courses, grid, identity, independence,
    loop_b, no_recognition, odometry, perceptual, propagation, robots, transform, treated,
};
use crate::{
    Bound, Check, Claim, Condition, Group, Outcome, Request, Study, Treatment,
    metrics::{paired, share_estimate},
};

/// The thesis's claims, asked of its own form and of ours.
pub(crate) const STUDY: Study = Study {
    name: "claims",
    line: "C1 to C9: what the thesis claims, with figures and verdicts, for its form and for ours",
    about: "Runs what the thesis's nine claims need (its Abstract, §2.3, §3.2.3, §3.2.4, chapter 4) and judges \
            each by a criterion of ours that is printed beside it: the thesis judges by eye. Each claim is \
            asked of `perceptual`, the thesis's program to the letter, and of `consensus`, our own mapper, \
            which is not Yeap's model: what holds for ours is no evidence for his. Each is asked with the good \
            robot and with the bad one (the thesis used only the bad one). A claim is supported if the whole \
            95 % interval of every figure lies where its criterion wants it, refuted if that of any lies on the \
            other side, else undecided. What is said of a map's shape is said of `consensus` without its \
            recognition of places. Rates of 98 % and more are asked of five times the seeds. \
            Home is gone by `perceptual` and `faithful`, both the thesis's, and by `consensus` and `recommended`, both \
            ours, in the worlds of the thesis's experiments and on furnished floors made from the seeds.",
    seeds: 200,
    shown: &[
        "shape",
        "shape_share",
        "side_angle",
        "gap",
        "heading_gap",
        "fallbacks",
        "home_known",
        "purity",
        "home_reached",
        "home_distance",
        "shortcut_taken",
        "dead_ends_left",
        "help_needed",
    ],
    plan,
    judge,
};

/// The buildings' names.
const LOOP: &str = "Environment B";
/// Rates of 98 % and more need so many times the runs.
const MORE: u64 = 5;
/// With so many times its errors, odometry is useless.
const USELESS: f64 = 10.0;

fn plan(request: &Request) -> Result<Vec<Condition>, String> {
    if !request.worlds.is_empty() {
        return Err(
            "the claims have their own worlds: leave --worlds out, or run `loop-b` with it".to_owned()
        );
    }
    let robots = robots(&ROBOTS);
    let (loop_b, loop_a) =
        (courses(request, "environment-b", "loop")?, courses(request, "environment-a", "loop")?);
    let shapes = [odometry(), transform(), perceptual(), no_recognition()];
    let treatments = [1.0, USELESS].map(|odometry| Treatment { odometry, every: None });
    let mut conditions: Vec<Condition> =
        grid(&loop_b, &robots, &shapes).iter().flat_map(|base| treated(base, &treatments)).collect();
    let networks = [perceptual(), consensus()];
    let loops = [loop_b.as_slice(), loop_a.as_slice()].concat();
    conditions.extend(grid(&loops, &robots, &networks).into_iter().map(|c| Condition { times: MORE, ..c }));
    let sighted = identity::seeing(&robots, &[1.0]);
    conditions.extend(grid(&loop_b, &sighted, &[perceptual(), no_recognition()]));
    conditions.extend(going_home::conditions(&robots)?);
    Ok(conditions)
}

const ROBOTS: [&str; 2] = ["good", "bad"];

const STATEMENTS: [(&str, &str); 9] = [
    (
        "C1",
        "a map built without any error correction keeps a good layout although movement is measured badly",
    ),
    ("C2", "there are errors in such a map, but they stay local: movement measurements do not enter it"),
    ("C3", "on the same route this map is much better than a traditional one with error correction"),
    ("C4", "a network of local spaces closes loops although the map's ends do not meet"),
    ("C5", "a robot goes home, takes simple shortcuts and leaves dead ends with a mostly forgotten map"),
    ("C6", "the robot needs a user's help only rarely"),
    ("C7", "that two views have no common surface is very rare and happens only in special situations"),
    ("C8", "virtually all mapping problems come from recognition, not from placement"),
    (
        "C9",
        "dividing a big space into several local spaces is acceptable; one space for several rooms is not",
    ),
];

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for (id, statement) in STATEMENTS {
        for (form, shape) in [(PERCEPTUAL, PERCEPTUAL), (CONSENSUS, NO_RECOGNITION)] {
            for robot in ROBOTS {
                let claim = Claim { id, statement, form, robot };
                let asked = Asked { outcome, robot, form, shape };
                checks.extend(asked.of(id).into_iter().map(|check| check.of_claim(claim.clone())));
            }
        }
    }
    checks
}

/// Whom a claim is asked of: a form of the theory, the mapper that its shape is judged by, a robot.
struct Asked<'a> {
    outcome: &'a Outcome,
    robot: &'a str,
    form: &'a str,
    shape: &'a str,
}

impl<'a> Asked<'a> {
    fn of(&self, id: &str) -> Vec<Check> {
        match id {
            "C1" => self.good_layout(),
            "C2" => self.local_errors(),
            "C3" => self.better_than_traditional(),
            "C4" => self.closes_loops(),
            "C5" => self.goes_home(),
            "C6" => self.rarely_needs_help(),
            "C7" => self.rarely_lost(),
            "C8" => self.recognition_is_the_problem(),
            _ => self.pure_spaces(),
        }
    }

    /// The drives of a mapper under the conditions that are so.
    fn groups(&self, mapper: &'a str, is_so: impl Fn(&Condition) -> bool) -> Vec<Group<'a>> {
        let is_so = |condition: &Condition| !condition.goes_home() && is_so(condition);
        self.outcome.groups_of(self.robot, mapper).filter(|group| is_so(group.of())).collect()
    }

    /// The runs on the loop of 90 m, odometry as it is.
    fn on_loop(&self, mapper: &'a str, times: u64) -> Vec<Group<'a>> {
        self.groups(mapper, |c| c.place() == LOOP && c.treatment == Treatment::default() && c.times == times)
    }

    fn good_layout(&self) -> Vec<Check> {
        let check = |group: Group<'_>| {
            let shape = group.rate(|values| values.get("shape_share").map(|share| share <= 1.0));
            let sides = group.figure_of("side_angle");
            [
                Check::rate(
                    "shape error at most 1 % of the way in at least 90 % of runs",
                    shape,
                    Bound::AtLeast(0.9),
                ),
                Check::figure("long walls turned by at most 5° (median of rms)", sides, Bound::AtMost(5.0)),
            ]
        };
        self.on_loop(self.shape, 1).into_iter().flat_map(check).collect()
    }

    fn local_errors(&self) -> Vec<Check> {
        let useless = self.groups(self.shape, |c| c.treatment.odometry >= USELESS);
        let pairs = self.on_loop(self.shape, 1).into_iter().zip(useless);
        let check = |(mild, hard): (Group<'_>, Group<'_>)| {
            [independence::steady(&mild, &hard), propagation::local(&mild)]
        };
        pairs.flat_map(check).collect()
    }

    fn better_than_traditional(&self) -> Vec<Check> {
        let pairs = self.on_loop(self.shape, 1).into_iter().zip(self.on_loop(TRANSFORM, 1));
        let check = |(ours, traditional): (Group<'_>, Group<'_>)| {
            let ratio = paired(&ours.pairs(&traditional, "shape")).and_then(|paired| paired.ratio);
            let criterion = "the traditional map's shape error is at least twice as large (median)";
            [loop_b::lower_shape(&ours, &traditional), Check::figure(criterion, ratio, Bound::AtLeast(2.0))]
        };
        pairs.flat_map(check).collect()
    }

    fn closes_loops(&self) -> Vec<Check> {
        let check = |group: Group<'_>| {
            let gap = group.rate(|values| values.get("gap").map(|gap| gap <= 3.0));
            let mut checks = vec![
                Check::share(
                    "start and end share a space in at least 98 % of runs",
                    group.figure_of("home_known"),
                    Bound::AtLeast(0.98),
                ),
                Check::share(
                    "at most 0.5 % of new rooms are taken for old ones",
                    group.figure_of("false_closures"),
                    Bound::AtMost(0.005),
                ),
            ];
            if self.form == PERCEPTUAL {
                let criterion = "the ends come within 3 m of each other in at least 90 % of runs";
                checks.push(Check::rate(criterion, gap, Bound::AtLeast(0.9)));
            }
            checks
        };
        self.on_loop(self.form, MORE).into_iter().flat_map(check).collect()
    }

    fn rarely_lost(&self) -> Vec<Check> {
        let check = |group: Group<'_>| {
            let place = group.of().place();
            let lost = share_estimate(&group.parts("fallbacks", "views"));
            let excused = group.figure_of("fallbacks_excused");
            let mut checks = vec![Check::share(
                format!("{place}: at most 1 % of views without a reference"),
                lost,
                Bound::AtMost(0.01),
            )];
            if excused.is_some() {
                let criterion =
                    format!("{place}: at least 95 % of them where nothing or parallel walls are in view");
                checks.push(Check::share(criterion, excused, Bound::AtLeast(0.95)));
            }
            checks
        };
        self.groups(self.form, |condition| condition.times == MORE).into_iter().flat_map(check).collect()
    }

    fn recognition_is_the_problem(&self) -> Vec<Check> {
        identity::all_by_sight(&self.on_loop(self.shape, 1), self.outcome)
    }

    fn pure_spaces(&self) -> Vec<Check> {
        let check = |group: Group<'_>| {
            let pure = group.rate(|values| values.get("purity").map(|purity| purity >= 90.0));
            let criterion = "no space swallows rooms: 90 % of the surfaces bound the room that most of their \
                             space's do, in at least 90 % of runs";
            Check::rate(criterion, pure, Bound::AtLeast(0.9))
        };
        self.on_loop(self.form, MORE).into_iter().map(check).collect()
    }
}
