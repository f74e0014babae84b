use cogmap_scene::Thing;

use super::Run;
use crate::{
    contents::{Contents, contents},
    story::{Facts, Teller},
};

/// What is told about the memories.
impl Run {
    /// What is known about a thing in a mapper's mind; nothing where it is not there.
    pub(crate) fn facts(&self, mapper: usize, thing: Thing) -> Option<Facts> {
        Teller::of(&self.session, mapper, &|t| self.position_at(t))?.facts(thing)
    }

    /// What a mapper has in mind, with at most so many surfaces of each local space.
    pub(crate) fn contents(&self, mapper: usize, most: usize) -> Option<Contents> {
        contents(&self.session, mapper, most, &|t| self.position_at(t))
    }
}
