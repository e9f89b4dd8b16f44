//! Deviations of an output, the list of them. Nobody else asks which deviation it is: they ask whether play is in it and what it counts from.

use serde::{Deserialize, Serialize};

/// The motion that a deviation is of.
#[derive(Clone, Copy)]
enum Motion {
    /// With the play of the joints.
    WithPlay,
    /// Ideal, of the same parts.
    WithoutPlay,
}

/// What a deviation counts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// From zero: it is the output itself.
    Zero,
    /// The ideal motion of the same parts.
    SameParts,
    /// The ideal motion of parts as the drawing has them.
    NominalParts,
}

macro_rules! deviations {
    ($($(#[$doc:meta])* $name:ident: $word:literal = $motion:ident from $reference:ident),* $(,)?) => {
        /// Deviation of an output.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
        pub enum Deviation {
            $($(#[$doc])* #[serde(rename = $word)] $name,)*
        }

        impl Deviation {
            /// Every deviation, in the order in which study files name them.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$name),*];

            /// Word in study files, results and tables.
            pub const fn word(self) -> &'static str {
                match self { $(Self::$name => $word,)* }
            }

            const fn motion(self) -> Motion {
                match self { $(Self::$name => Motion::$motion,)* }
            }

            /// What it counts from.
            pub const fn reference(self) -> Reference {
                match self { $(Self::$name => Reference::$reference,)* }
            }
        }

        // From the ideal motion of the same parts itself it is zero.
        $(const _: () = assert!(Deviation::$name.has_play() || !Deviation::$name.is_by_play_alone());)*
    };
}

deviations! {
    /// The output itself.
    Value: "value" = WithPlay from Zero,
    /// Ideal motion of the parts as they are, from that of nominal ones: what scatter of the parts alone makes.
    Dimensional: "dimensional" = WithoutPlay from NominalParts,
    /// What play alone makes.
    Clearance: "clearance" = WithPlay from SameParts,
    /// What scatter of the parts and play make together.
    Total: "total" = WithPlay from NominalParts,
}

impl Deviation {
    /// What an answer is about where nothing is said: what all causes make together.
    pub const fn of_all_causes() -> Self {
        Self::Total
    }

    /// The output itself.
    pub const fn of_value() -> Self {
        Self::Value
    }

    /// Whether it is the output itself, and no deviation.
    pub const fn is_value(self) -> bool {
        matches!(self.reference(), Reference::Zero)
    }

    /// Whether it is the output itself as a run has it.
    pub const fn is_value_of_run(self) -> bool {
        self.is_value() && self.has_play()
    }

    /// The noun for it, without its cause.
    pub const fn noun(self) -> &'static str {
        match (self.is_value(), self.has_play()) {
            (true, true) => "value",
            (true, false) => "ideal value",
            (false, _) => "deviation",
        }
    }

    /// Whether it counts from the ideal motion with the dimensions of the drawing, not from that of the same mechanism without clearance.
    pub const fn is_from_drawing(self) -> bool {
        matches!(self.reference(), Reference::NominalParts)
    }

    /// Whether play has a part in it.
    pub const fn has_play(self) -> bool {
        matches!(self.motion(), Motion::WithPlay)
    }

    /// Whether play alone makes it: part scatter does not move what it counts from.
    pub const fn is_by_play_alone(self) -> bool {
        matches!(self.reference(), Reference::SameParts)
    }

    /// Whether the ideal motion of the parts as they are has a part in it.
    pub const fn needs_own_ideal(self) -> bool {
        !self.has_play() || self.is_by_play_alone()
    }

    /// What makes it, in words; `None` where all of it is meant.
    pub const fn cause(self) -> Option<&'static str> {
        if self.is_by_play_alone() {
            Some("play")
        } else if self.has_play() {
            None
        } else {
            Some("part scatter")
        }
    }

    /// The deviation from the value of the motion with play, of the ideal motion of the same parts, and of that of nominal ones. Asks for none
    /// that it does not need.
    pub fn between(
        self,
        with_play: impl FnOnce() -> f64,
        own: impl FnOnce() -> f64 + Copy,
        nominal: impl FnOnce() -> f64,
    ) -> f64 {
        let value = if self.has_play() { with_play() } else { own() };
        match self.reference() {
            Reference::Zero => value,
            Reference::SameParts => value - own(),
            Reference::NominalParts => value - nominal(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Deviation;

    #[test]
    fn identity_the_word_is_what_files_hold() {
        for deviation in Deviation::ALL {
            assert_eq!(serde_json::to_value(deviation).unwrap(), deviation.word());
        }
    }

    #[test]
    fn analytic_parts_of_a_deviation_add_up_to_all_of_it() {
        let of = |deviation: Deviation| deviation.between(|| 7.0, || 5.0, || 2.0);
        for (deviation, value, cause) in [
            (Deviation::Value, 7.0, None),
            (Deviation::Dimensional, 3.0, Some("part scatter")),
            (Deviation::Clearance, 2.0, Some("play")),
            (Deviation::Total, 5.0, None),
        ] {
            assert_eq!((of(deviation), deviation.cause()), (value, cause), "{deviation:?}");
            assert_eq!(deviation.noun() == "deviation", !deviation.is_value(), "{deviation:?}");
        }
        assert_eq!(of(Deviation::Total), of(Deviation::Dimensional) + of(Deviation::Clearance));
    }
}
