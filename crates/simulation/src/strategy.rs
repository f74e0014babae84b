use std::fmt;

use cogmap_navigation::StrategySetup;
use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{self, MapAccess, Visitor, value::MapAccessDeserializer},
};

/// The name of [`Strategy::Oracle`].
const ORACLE: &str = "oracle";

/// Who finds the way home. In files the name alone where no parameter differs from its default, else
/// an object with all of them.
///
/// ```
/// use cogmap_simulation::Strategy;
/// let strategy: Strategy = serde_json::from_str(r#""retrace""#).unwrap();
/// assert_eq!(strategy.name(), "retrace");
/// assert_eq!(serde_json::to_string(&strategy).unwrap(), r#""retrace""#);
/// let patient: Strategy = serde_json::from_str(r#"{"strategy": "retrace", "patience": 99}"#).unwrap();
/// assert_ne!(patient, strategy);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "there is one a way home")]
pub enum Strategy {
    /// The robot's own program, which knows what the robot knows.
    Robot(StrategySetup),
    /// The person at the controls, who sees the building as it truly is: the yardstick.
    Oracle,
}

impl Strategy {
    /// The names that [`Strategy::named`] knows.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        StrategySetup::NAMES.into_iter().chain([ORACLE]).collect()
    }

    /// The strategy of that name with its default parameters.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        if name == ORACLE { Some(Self::Oracle) } else { StrategySetup::named(name).map(Self::Robot) }
    }

    /// Every parameter of the robot's own program; the oracle has none.
    #[must_use]
    pub fn setup(&self) -> Option<&StrategySetup> {
        match self {
            Self::Robot(setup) => Some(setup),
            Self::Oracle => None,
        }
    }

    /// The name under which it is chosen.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Robot(setup) => setup.name(),
            Self::Oracle => ORACLE,
        }
    }
}

impl Serialize for Strategy {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Robot(setup) if Self::named(self.name()).as_ref() != Some(self) => {
                setup.serialize(serializer)
            }
            _ => serializer.serialize_str(self.name()),
        }
    }
}

impl<'de> Deserialize<'de> for Strategy {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NameOrSetup)
    }
}

struct NameOrSetup;

impl<'de> Visitor<'de> for NameOrSetup {
    type Value = Strategy;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "the name of a strategy ({})", Strategy::names().join(", "))
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<Strategy, E> {
        Strategy::named(name).ok_or_else(|| E::invalid_value(de::Unexpected::Str(name), &self))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Strategy, A::Error> {
        StrategySetup::deserialize(MapAccessDeserializer::new(map)).map(Strategy::Robot)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_strategy_is_found_by_its_name_and_written_by_it() {
        for name in Strategy::names() {
            let strategy = Strategy::named(name).unwrap();
            assert_eq!(strategy.name(), name);
            let text = serde_json::to_string(&strategy).unwrap();
            assert_eq!(text, format!("\"{name}\""));
            assert_eq!(serde_json::from_str::<Strategy>(&text).unwrap(), strategy);
        }
    }

    #[test]
    fn changed_parameters_survive_a_file() {
        let text = r#"{"strategy": "retrace", "tolerance": 0.2}"#;
        let strategy: Strategy = serde_json::from_str(text).unwrap();
        let again = serde_json::to_string(&strategy).unwrap();
        assert!(again.starts_with('{'), "{again}");
        assert_eq!(serde_json::from_str::<Strategy>(&again).unwrap(), strategy);
    }

    #[test]
    fn an_unknown_name_is_answered_with_those_that_are_known() {
        let error = serde_json::from_str::<Strategy>("\"retrase\"").unwrap_err().to_string();
        assert!(
            error.contains("retrase") && error.contains("retrace, ") && error.contains("oracle"),
            "{error}"
        );
    }
}
