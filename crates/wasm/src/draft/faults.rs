use std::collections::BTreeSet;

use cogmap_formats::{Complaint, FormatError, world};
use serde::Serialize;
use tsify::Tsify;

use super::{Draft, Thing, file_name};

/// Something that is wrong with a drawn building, and where.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Tsify)]
pub struct Fault {
    /// Which of its things; nothing where it is the building as a whole.
    pub thing: Option<usize>,
    /// Which of that thing's points; a door's are its hinge and its latch.
    pub point: Option<usize>,
    /// What is wrong and what to do.
    pub message: String,
}

/// What the command line's `check` would say of a drawn building, and the file that it would say it of.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Tsify)]
pub struct Checked {
    /// What keeps the building from being used.
    pub faults: Vec<Fault>,
    /// What is hardly meant so, and keeps it from nothing.
    pub remarks: Vec<Fault>,
    /// What the file is called.
    pub file: String,
    /// The world file.
    pub text: String,
}

impl Checked {
    /// Writes a draft down and reads it again, as whoever gets the file will.
    pub(crate) fn of(draft: &Draft) -> Self {
        let file = file_name(&draft.name);
        let Some(world) = draft.world() else {
            let faults = vec![draft.fault("", "there is no start: put one where the robot is to begin")];
            return Self { faults, remarks: Vec::new(), file, text: String::new() };
        };
        let text = world::write(&world);
        let mut faults = draft.routes_of_one_name();
        let read = world::read(&text, &file);
        faults.extend(read.err().map(|error| draft.faults_of(error)).unwrap_or_default());
        let remarks = world.remarks();
        let remarks = remarks.into_iter().map(|remark| draft.fault(&remark.place, &remark.message)).collect();
        Self { faults, remarks, file, text }
    }
}

impl Draft {
    fn faults_of(&self, error: FormatError) -> Vec<Fault> {
        match error {
            FormatError::Problems { complaints, .. } => {
                let fault = |it: Complaint| self.fault(&it.place.key, &it.problem);
                complaints.into_iter().map(fault).collect()
            }
            other => vec![self.fault(&other.place().key, &other.to_string())],
        }
    }

    /// A file cannot hold two routes of one name: there the second would take the place of the first.
    fn routes_of_one_name(&self) -> Vec<Fault> {
        let mut names = BTreeSet::new();
        let routes = self.things.iter().enumerate().filter_map(|(i, it)| Some((i, name_of_route(it)?)));
        let again = routes.filter(|(_, name)| !names.insert(*name));
        let fault = |(index, name): (usize, &String)| {
            let message = format!("another route is called {name:?} too: give each its own name");
            Fault { thing: Some(index), point: None, message }
        };
        again.map(fault).collect()
    }

    /// What is wrong at a place of the file, such as `boxes[3].size`.
    fn fault(&self, place: &str, message: &str) -> Fault {
        let (thing, rest) = self.find(place).unzip();
        let point = match rest.unwrap_or_default() {
            rest if rest.starts_with(".hinge") => Some(0),
            rest if rest.starts_with(".latch") => Some(1),
            rest => first_number(rest.trim_start_matches(".outline").trim_start_matches(".path")),
        };
        Fault { thing, point, message: message.to_owned() }
    }

    /// The thing that stands at a place of the file, and what is left of the place.
    fn find<'a>(&self, place: &'a str) -> Option<(usize, &'a str)> {
        if let Some(rest) = place.strip_prefix("routes.") {
            return self.find_route(rest);
        }
        let list = place.split(['[', '.']).next()?;
        let rest = place.get(list.len()..)?;
        let rest_of_thing = rest.find(']').and_then(|end| rest.get(end + 1..)).unwrap_or_default();
        let mut same = self.things.iter().enumerate().filter(|(_, thing)| thing.list() == list);
        same.nth(first_number(rest).unwrap_or(0)).map(|(index, _)| (index, rest_of_thing))
    }

    /// Routes are called by their names, which may hold anything.
    fn find_route<'a>(&self, place: &'a str) -> Option<(usize, &'a str)> {
        let rest = |thing| {
            let rest = place.strip_prefix(name_of_route(thing)?.as_str())?;
            (rest.is_empty() || rest.starts_with('[')).then_some(rest)
        };
        let fits = self.things.iter().enumerate().filter_map(|(index, thing)| Some((index, rest(thing)?)));
        fits.min_by_key(|(_, rest)| rest.len())
    }
}

impl Thing {
    /// Under which key of the file it stands.
    pub(super) fn list(&self) -> &'static str {
        match self {
            Self::Wall { .. } => "walls",
            Self::Box { .. } => "boxes",
            Self::Post { .. } => "posts",
            Self::Door { .. } => "doors",
            Self::Person { .. } => "people",
            Self::Start { .. } => "start",
            Self::Route { .. } => "routes",
            Self::Room { .. } => "rooms",
        }
    }
}

fn name_of_route(thing: &Thing) -> Option<&String> {
    match thing {
        Thing::Route { name, .. } => Some(name),
        _ => None,
    }
}

/// The number in the brackets that a text begins with.
fn first_number(text: &str) -> Option<usize> {
    text.strip_prefix('[')?.split(']').next()?.parse().ok()
}
