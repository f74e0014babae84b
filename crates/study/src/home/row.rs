use cogmap_simulation::Setting;

/// One way home, or the attempt at one.
#[derive(Clone, Debug, PartialEq)]
pub struct HomeRow {
    /// The world, or `generated`.
    pub place: String,
    /// What happened to it.
    pub setting: Setting,
    /// The robot's name.
    pub robot: String,
    /// What all chance came from.
    pub seed: u64,
    /// Who found the way.
    pub strategy: String,
    /// How it went; `None` where the way out could not be driven, so that nothing was tried.
    pub trial: Option<Trial>,
}

/// How a way home ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The robot stopped and said that it was home.
    Home,
    /// The robot gave up.
    Stuck,
    /// Time ran out.
    Lost,
}

/// A way home in numbers; metres, rounded to a tenth of a millimetre so that a file holds them exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// How it ended.
    pub ended: Ended,
    /// From the robot to where it had begun, in truth.
    pub distance: f64,
    /// From where the robot believed home to be to where it was; `None` where it knew no way back.
    pub home_offset: Option<f64>,
    /// Length of the way out.
    pub out: f64,
    /// Length of the shortest way home for a disc of the robot's size; `None` where there is none.
    pub shortest: Option<f64>,
    /// Length of the way driven home.
    pub path: f64,
    /// How often the robot drove into something on the way home.
    pub collisions: f64,
    /// How often it decided.
    pub decisions: f64,
    /// How often it did so while the fail-safe led it.
    pub failsafe_steps: f64,
    /// Dead ends noticed.
    pub dead_ends: f64,
    /// Those within 1 m of one noticed before.
    pub reentries: f64,
    /// Radians turned for each metre.
    pub turning: f64,
    /// How often it turned by more than 30° after it had turned as much the other way, for each 10 m.
    pub zigzag: f64,
    /// What it said at the end.
    pub why: String,
}

/// The columns of `runs.csv`.
const COLUMNS: &str = "place,setting,robot,seed,strategy,ended,distance,home_offset,out,shortest,path,collisions,\
                       decisions,failsafe_steps,dead_ends,reentries,turning,zigzag,why";

impl Ended {
    const ALL: [Self; 3] = [Self::Home, Self::Stuck, Self::Lost];

    fn name(self) -> &'static str {
        match self {
            Self::Home => "home",
            Self::Stuck => "stuck",
            Self::Lost => "lost",
        }
    }
}

impl Trial {
    /// Whether the robot stopped by itself within so many metres of its start, and hit nothing.
    #[must_use]
    pub fn succeeds(&self, within: f64) -> bool {
        self.ended == Ended::Home && self.distance <= within && self.collisions == 0.0
    }

    /// Success weighted by path length, with success within 1 m; `None` where no way leads home.
    #[must_use]
    pub fn spl(&self) -> Option<f64> {
        let shortest = self.shortest?;
        let length = self.length().max(shortest);
        let share = if length > 0.0 { shortest / length } else { 1.0 };
        Some(if self.succeeds(1.0) { share } else { 0.0 })
    }

    /// The way driven and what is missing to the start, metres: a robot that stops short gains nothing by it.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.path + self.distance
    }

    /// Where the shortest way is at most 0.7 of the way out: whether the robot came within so many metres of
    /// home and drove less than halfway between the two.
    #[must_use]
    pub fn takes_shortcut(&self, within: f64) -> Option<bool> {
        let shortest = self.shortest.filter(|shortest| *shortest <= 0.7 * self.out)?;
        Some(self.succeeds(within) && self.path < f64::midpoint(shortest, self.out))
    }
}

impl HomeRow {
    /// The first line of `runs.csv`.
    #[must_use]
    pub fn head() -> String {
        format!("{COLUMNS}\n")
    }

    /// The row as a line.
    #[must_use]
    pub fn line(&self) -> String {
        let Self { place, setting, robot, seed, strategy, trial } = self;
        let mut cells =
            vec![place.clone(), setting.name().to_owned(), robot.clone(), seed.to_string(), strategy.clone()];
        if let Some(trial) = trial {
            let optional = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
            cells.push(trial.ended.name().to_owned());
            cells.push(trial.distance.to_string());
            cells.extend([trial.home_offset, Some(trial.out), trial.shortest].map(optional));
            let numbers = [trial.path, trial.collisions, trial.decisions, trial.failsafe_steps];
            let more = [trial.dead_ends, trial.reentries, trial.turning, trial.zigzag];
            cells.extend(numbers.iter().chain(&more).map(ToString::to_string));
            cells.push(trial.why.clone());
        } else {
            cells.resize(COLUMNS.split(',').count(), String::new());
        }
        cells.join(",") + "\n"
    }

    /// Reads a line that [`HomeRow::line`] wrote; `None` of any other.
    #[must_use]
    pub fn read(line: &str) -> Option<Self> {
        let cells: Vec<&str> = line.split(',').collect();
        let [place, setting, robot, seed, strategy, values @ ..] = cells.as_slice() else { return None };
        Some(Self {
            place: (*place).to_owned(),
            setting: Setting::named(setting)?,
            robot: (*robot).to_owned(),
            seed: seed.parse().ok()?,
            strategy: (*strategy).to_owned(),
            trial: if values.first()?.is_empty() { None } else { Some(trial(values)?) },
        })
    }
}

fn trial(values: &[&str]) -> Option<Trial> {
    let [ended, numbers @ .., why] = values else { return None };
    let numbers: Vec<Option<f64>> = numbers.iter().map(|cell| cell.parse().ok()).collect();
    let &[
        distance,
        home_offset,
        out,
        shortest,
        path,
        collisions,
        decisions,
        failsafe_steps,
        dead_ends,
        reentries,
        turning,
        zigzag,
    ] = numbers.as_slice()
    else {
        return None;
    };
    Some(Trial {
        ended: Ended::ALL.into_iter().find(|known| known.name() == *ended)?,
        distance: distance?,
        home_offset,
        out: out?,
        shortest,
        path: path?,
        collisions: collisions?,
        decisions: decisions?,
        failsafe_steps: failsafe_steps?,
        dead_ends: dead_ends?,
        reentries: reentries?,
        turning: turning?,
        zigzag: zigzag?,
        why: (*why).to_owned(),
    })
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(in crate::home) fn row(seed: u64, strategy: &str, path: f64) -> HomeRow {
        let trial = Trial {
            ended: Ended::Home,
            distance: 0.0,
            home_offset: None,
            out: 20.0,
            shortest: Some(10.0),
            path,
            collisions: 0.0,
            decisions: 31.0,
            failsafe_steps: 0.0,
            dead_ends: 1.0,
            reentries: 0.0,
            turning: 0.5,
            zigzag: 0.1,
            why: "home".to_owned(),
        };
        HomeRow {
            place: "generated".to_owned(),
            setting: Setting::Furnished,
            robot: "bad".to_owned(),
            seed,
            strategy: strategy.to_owned(),
            trial: Some(trial),
        }
    }

    #[test]
    fn a_row_survives_its_line() {
        let tried = row(7, "retrace", 12.5);
        let untried = HomeRow { trial: None, ..tried.clone() };
        for row in [tried, untried] {
            assert_eq!(HomeRow::read(row.line().trim_end()), Some(row.clone()));
            assert_eq!(row.line().matches(',').count(), HomeRow::head().matches(',').count());
        }
        assert_eq!(HomeRow::read("generated,furnished,bad,7,retrace,home,0.2"), None, "cut off");
    }

    #[test]
    fn only_an_own_stop_near_home_counts_and_detours_cost() {
        let trial = row(1, "retrace", 12.5).trial.unwrap();
        assert_eq!((trial.spl(), trial.takes_shortcut(1.0)), (Some(0.8), Some(true)));
        let short = Trial { path: 9.5, distance: 0.5, ..trial.clone() };
        assert_eq!(short.spl(), Some(1.0), "what is missing counts as driven, no more");
        let far = Trial { distance: 1.2, ..trial.clone() };
        assert!(far.spl() == Some(0.0) && far.succeeds(1.5) && !far.succeeds(1.0));
        assert!(!Trial { collisions: 1.0, ..trial.clone() }.succeeds(1.5));
        assert!(!Trial { ended: Ended::Stuck, ..trial }.succeeds(1.5));
    }
}
