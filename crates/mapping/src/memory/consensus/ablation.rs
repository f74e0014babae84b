use super::{Alignment, ConsensusParams, FreeSpace, Loss, Novelty, Reach, Recognition, Search};

/// Farther than any map reaches, metres; as a factor, more than any residual needs.
const NEVER: f64 = 1e6;

impl ConsensusParams {
    /// For each extension of the theory its name and these parameters with that one switched off.
    ///
    /// ```
    /// use cogmap_mapping::memory::ConsensusParams;
    /// let ablations = ConsensusParams::default().ablations();
    /// let (name, without) = &ablations[ablations.len() - 1];
    /// assert!(*name == "recognition" && !without.recognition.on);
    /// ```
    #[must_use]
    pub fn ablations(&self) -> Vec<(&'static str, Self)> {
        let alignment = |alignment| Self { alignment, ..*self };
        let recognition = |recognition| Self { recognition, ..*self };
        vec![
            ("all references", alignment(Alignment { all_references: false, ..self.alignment })),
            ("robust weights", alignment(Alignment { doubt: NEVER, ..self.alignment })),
            ("true ends", alignment(Alignment { end_gate: 0.0, ..self.alignment })),
            (
                "observability",
                alignment(Alignment { information: 1e-3, information_share: 1e-9, ..self.alignment }),
            ),
            (
                "memory wider than the frame",
                Self { reach: Reach { along_links: 0.0, ..self.reach }, ..*self },
            ),
            (
                "several starts",
                Self {
                    search: Search { search_below: 0.0, search_contradiction: 1.0, ..self.search },
                    ..*self
                },
            ),
            ("longer sightings", Self { novelty: Novelty { cover: 0.05, ..self.novelty }, ..*self }),
            ("local frames", Self { frame_size: NEVER, ..*self }),
            ("free space", Self { free_space: FreeSpace { margin: NEVER, ..self.free_space }, ..*self }),
            ("noticing loss", Self { loss: Loss { on: false, ..self.loss }, ..*self }),
            ("recognition", recognition(Recognition { on: false, ..self.recognition })),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_ablation_switches_one_thing_off() {
        let whole = ConsensusParams::default();
        let ablations = whole.ablations();
        for (index, (name, params)) in ablations.iter().enumerate() {
            assert_ne!(*params, whole, "{name}");
            assert!(ablations[index + 1..].iter().all(|(other, same)| other != name && same != params));
        }
    }
}
