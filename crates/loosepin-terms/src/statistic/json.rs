//! A statistic in results: `{ "kind": word }`, with the number under its name where it has one.

use std::fmt;

use serde::de::{Error, IgnoredAny, MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::Statistic;

impl Statistic {
    fn named_number(self) -> Option<(&'static str, f64)> {
        Some((self.description().number?.name, self.parameter()?))
    }
}

impl Serialize for Statistic {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let number = self.named_number();
        let mut map = serializer.serialize_map(Some(1 + usize::from(number.is_some())))?;
        map.serialize_entry("kind", self.word())?;
        if let Some((name, value)) = number {
            map.serialize_entry(name, &value)?;
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for Statistic {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Written)
    }
}

/// Reads a statistic from a file.
struct Written;

impl<'de> Visitor<'de> for Written {
    type Value = Statistic;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a statistic")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Statistic, A::Error> {
        let (mut kind, mut number): (Option<String>, Option<(&'static str, f64)>) = (None, None);
        while let Some(key) = map.next_key::<String>()? {
            let is_named = |known: &&'static str| *known == key;
            if key == "kind" {
                kind = Some(map.next_value()?);
            } else if let Some(name) = names_of_numbers().find(is_named) {
                number = map.next_value::<Option<f64>>()?.map(|value| (name, value)).or(number);
            } else {
                map.next_value::<IgnoredAny>()?;
            }
        }
        let kind = kind.ok_or_else(|| A::Error::missing_field("kind"))?;
        let statistic = Statistic::from_word(&kind, number.map(|(_, value)| value));
        statistic.filter(|statistic| statistic.named_number() == number).ok_or_else(|| {
            A::Error::custom(format!("statistic '{kind}' has another parameter, or there is none of this name"))
        })
    }
}

fn names_of_numbers() -> impl Iterator<Item = &'static str> {
    Statistic::with_parameter(f64::NAN).into_iter().filter_map(|statistic| Some(statistic.description().number?.name))
}
