//! Verdicts: the one way from a bounded share to a word.

use serde::{Deserialize, Serialize};

/// Verdict on a requirement that a share of mechanisms keeps a limit, whatever the epistemic inputs are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Met for every value of the epistemic inputs, numerical error included.
    Met,
    /// Kept in a stated share of the box of the epistemic inputs, with a stated confidence; not shown for every value.
    Promised,
    /// Not met for at least one value, numerical error included.
    NotMet,
    /// The numerical error reaches over the limit, or the share is unknown: more runs decide.
    Undecided,
}

/// Bounds of the share of mechanisms that keep a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownShare {
    /// The least over the epistemic inputs, numerical error taken off.
    pub least: f64,
    /// The least that was really seen, at one value of the epistemic inputs, numerical error added.
    pub seen: f64,
}

impl KnownShare {
    /// An unknown share.
    pub const NOTHING: Self = Self { least: 0.0, seen: 1.0 };
}

impl Verdict {
    /// Verdict on `share >= required`.
    pub fn of(share: KnownShare, required: f64) -> Self {
        if share.least >= required {
            Self::Met
        } else if share.seen < required {
            Self::NotMet
        } else {
            Self::Undecided
        }
    }

    /// Verdict of a requirement that a promise decides, once the search has reached this one. A value at which it is not met stays one.
    #[must_use]
    pub fn by_promise(self, is_promised: bool) -> Self {
        match (self, is_promised) {
            (Self::NotMet, _) => Self::NotMet,
            (_, true) => Self::Promised,
            (_, false) => Self::Undecided,
        }
    }

    /// Verdict over several requirements: the worst of them; `None` if nothing is required.
    pub fn of_all(verdicts: impl IntoIterator<Item = Self>) -> Option<Self> {
        let rank = |verdict: &Self| match verdict {
            Self::Met => 0,
            Self::Promised => 1,
            Self::Undecided => 2,
            Self::NotMet => 3,
        };
        verdicts.into_iter().max_by_key(rank)
    }
}

#[cfg(test)]
mod tests {
    use super::{KnownShare, Verdict};

    #[test]
    fn analytic_verdicts_just_above_at_and_just_below_what_is_required() {
        let of = |least: f64, seen: f64| Verdict::of(KnownShare { least, seen }, 0.95);
        assert_eq!(of(0.95, 0.97), Verdict::Met);
        assert_eq!(of(0.949, 0.95), Verdict::Undecided);
        assert_eq!(of(0.90, 0.949), Verdict::NotMet);
        assert_eq!(of(f64::NAN, f64::NAN), Verdict::Undecided);
        assert_eq!(Verdict::of(KnownShare::NOTHING, 0.01), Verdict::Undecided);
    }

    #[test]
    fn what_is_promised_is_never_met() {
        use Verdict::{Met, NotMet, Promised, Undecided};
        assert_eq!([Met, Undecided, NotMet].map(|verdict| verdict.by_promise(true)), [Promised, Promised, NotMet]);
        assert_eq!([Met, Undecided, NotMet].map(|verdict| verdict.by_promise(false)), [Undecided, Undecided, NotMet]);
        assert_eq!(Verdict::of_all([Met, Promised]), Some(Promised));
        assert_eq!(Verdict::of_all([Undecided, Promised]), Some(Undecided));
    }

    #[test]
    fn the_verdict_over_all_is_the_worst_and_none_over_none() {
        use Verdict::{Met, NotMet, Undecided};
        assert_eq!(Verdict::of_all([]), None);
        assert_eq!(Verdict::of_all([Met, Met]), Some(Met));
        assert_eq!(Verdict::of_all([Met, Undecided, Met]), Some(Undecided));
        assert_eq!(Verdict::of_all([Undecided, NotMet, Met]), Some(NotMet));
    }
}
