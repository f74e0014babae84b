use cogmap_scene::{Sample, Scene};

/// What legends say in the page's language; where it has no words for something, the engine's English stays.
#[derive(Debug, Default)]
pub(crate) struct Captions(Vec<(String, String)>);

impl Captions {
    /// From what legends say in English, `{}` for a number, and what they are to say instead.
    pub(crate) fn new(english: Vec<String>, words: Vec<String>) -> Self {
        Self(english.into_iter().zip(words).collect())
    }

    /// Words the legend of a scene.
    pub(crate) fn put(&self, scene: &mut Scene) {
        let views = scene.views.to_string();
        for entry in &mut scene.legend {
            let counted = entry.text.strip_suffix(&views).filter(|_| entry.sample == Sample::Run);
            let english = counted.map_or_else(|| entry.text.clone(), |text| format!("{text}{{}}"));
            if let Some((_, words)) = self.0.iter().find(|(known, _)| *known == english) {
                entry.text = words.replace("{}", &views);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use cogmap_scene::{LegendEntry, Role};

    use super::*;

    #[test]
    fn legends_say_what_there_are_words_for_numbers_and_all() {
        let words = |texts: [&str; 2]| texts.map(str::to_owned).to_vec();
        let captions = Captions::new(
            words(["door", "first seen in view 1–{}"]),
            words(["Tür", "in Ansicht 1–{} gesehen"]),
        );
        let legend = vec![
            LegendEntry::new(Sample::Line(Role::Door), "door"),
            LegendEntry::new(Sample::Run, "first seen in view 1–1"),
            LegendEntry::new(Sample::Line(Role::Wall), "wall"),
        ];
        let mut scene = Scene { views: 1, legend, ..Scene::default() };
        captions.put(&mut scene);
        let said: Vec<_> = scene.legend.iter().map(|entry| entry.text.as_str()).collect();
        assert_eq!(said, ["Tür", "in Ansicht 1–1 gesehen", "wall"]);
    }
}
