use super::Run;
use crate::{
    plots::Plots,
    schematic::{Schematic, schematic},
};

/// What is plotted of a run.
impl Run {
    /// What can be plotted, as far as the run has ever come.
    pub(crate) fn plots(&mut self) -> &Plots {
        self.note_curves();
        self.curves.all()
    }

    pub(super) fn note_curves(&mut self) {
        let mut curves = std::mem::take(&mut self.curves);
        curves.note(&self.session, |t| self.position_at(t));
        self.curves = curves;
    }

    /// Forgets what lies after a position: it belongs to a run that will not be.
    pub(crate) fn forget_after(&mut self, position: u64) {
        self.landmarks.forget_after(position);
        self.curves.forget_after(position);
    }

    /// The network of a mapper at this moment; nothing where it has none.
    pub(crate) fn schematic(&self, mapper: usize) -> Option<Schematic> {
        schematic(&self.session, mapper, |t| self.position_at(t))
    }
}
