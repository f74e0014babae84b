//! How a run is taken up again where it was left: everything that is recorded happens once more.

use cogmap_formats::{
    sha256_hex,
    situation::{self, Situation, SituationFile},
    world,
};
use cogmap_simulation::{Command, Driver, Session, Source, World};
use serde::Deserialize;
use tsify::Tsify;

use crate::{
    failure::Failure,
    opening,
    run::{Label, Run},
};

/// A building that comes with the page.
#[derive(Clone, Debug, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct KnownBuilding {
    /// The name of its world file, without extension.
    pub file: String,
    /// The world file.
    pub text: String,
}

/// What is needed to take a run up again.
#[derive(Clone, Debug, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct Kept {
    /// Where the situation came from, for messages.
    pub name: String,
    /// The situation.
    pub situation: String,
    /// The buildings that it may name.
    pub buildings: Vec<KnownBuilding>,
}

/// What is still to be gone through again, and what happens then.
pub(crate) struct Resumption {
    /// The moment at which the run is taken up.
    pub(crate) at: u64,
    /// As far as this it has to be gone through first.
    until: u64,
    pub(crate) live: bool,
    /// Follows the route in mind, as far as it would have driven as it is written.
    pub(crate) driver: Option<Driver>,
}

impl Resumption {
    /// One more turn; `false` once everything has happened again.
    pub(crate) fn turn(&mut self, session: &mut Session) -> bool {
        if session.position() < self.until {
            let changes = self.rehearse(session);
            if session.advance() {
                if let (true, Some(driver), Some(world)) = (changes, &mut self.driver, session.world()) {
                    driver.see(world);
                }
                return true;
            }
        }
        false
    }

    /// What the driver would do now is held against what was done. Whether the building changes now, which is
    /// not the driver's doing.
    fn rehearse(&mut self, session: &Session) -> bool {
        let Some(driver) = &mut self.driver else { return false };
        let (now, commands) = (session.position(), session.record().commands());
        let due = commands.get(commands.partition_point(|timed| timed.tick < now));
        let Some(due) = due.filter(|timed| timed.tick == now) else { return false };
        if matches!(due.command, Command::Change(_)) {
            return true;
        }
        let would = session.world_from_robot().and_then(|pose| driver.next_command(pose));
        if would.as_ref() != Some(&due.command) {
            self.driver = None;
        }
        false
    }
}

/// A run that can be taken up again. `log` is what a log's run was made from.
pub(crate) fn resume(kept: &Kept, log: Option<&[u8]>) -> Result<Run, Failure> {
    let find = |name: &str| building(&kept.buildings, name);
    let file = situation::read(&kept.situation, &kept.name, find)?;
    let label = label(&file);
    let Situation { record, at, live, on_route } = file.situation;
    let (session, until, driver) = match &record.source {
        Source::World { world, robot, ticks, .. } => {
            let (ticks, driver) = (*ticks, on_route.then(|| opening::driver(world, robot)).flatten());
            (Session::drive(record)?, ticks, driver)
        }
        Source::Log { path, sha256, .. } => {
            let needed = || Failure::new(&format!("{}: the log {path} is needed as well", kept.name));
            let log = log.filter(|log| sha256_hex(log) == *sha256).ok_or_else(needed)?;
            (opening::log_session(record, log, &label.name)?, at, None)
        }
    };
    Ok(Run::resuming(session, label, Resumption { at, until, live, driver }))
}

/// A run of which the page knows every part by name is one of the page's own.
fn label(file: &SituationFile) -> Label {
    let name = opening::world_name(&file.situation.record);
    let label = file.building.as_deref().map_or_else(|| opening::label(&name, true), opening::page_label);
    Label { name, foreign: !file.plain, settled: !file.plain, warnings: file.warnings.clone(), ..label }
}

fn building(known: &[KnownBuilding], name: &str) -> Option<World> {
    if let Some(seed) = name.strip_prefix(opening::GENERATED) {
        return opening::generated(seed).ok();
    }
    let known = known.iter().find(|known| known.file == name)?;
    world::read(&known.text, &known.file).ok()
}
