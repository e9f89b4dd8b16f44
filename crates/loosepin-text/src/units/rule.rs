//! The range that a value must lie in.

/// Turns in one run, at most: far more than anybody waits for, and few enough that counters hold them.
const MAX_TURNS: f64 = 1e6;
/// Pressure angles of teeth lie below 45 deg; usual ones are 14.5 to 30 deg.
const PRESSURE_ANGLE_RAD: f64 = std::f64::consts::FRAC_PI_4;

macro_rules! rules {
    ($x:ident: $($rule:ident $words:literal $holds:expr;)+) => {
        /// The range that a value must lie in, whether written in a file or drawn in a study.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Rule {
            $(#[doc = concat!("Must be ", $words, ".")] $rule,)+
        }

        impl Rule {
            /// All rules.
            #[cfg(test)]
            pub(super) const ALL: &[Rule] = &[$(Rule::$rule,)+];

            /// Whether a value keeps the rule. No value that is not finite keeps any.
            pub fn allows(self, $x: f64) -> bool {
                $x.is_finite() && match self { $(Rule::$rule => $holds,)+ }
            }

            /// The rule in words, to follow "must be".
            pub fn words(self) -> &'static str {
                match self { $(Rule::$rule => $words,)+ }
            }
        }
    };
}

impl Rule {
    /// The numbers that rules name, SI.
    pub(super) const LIMITS: [f64; 5] = [0.0, 0.5, 1.0, MAX_TURNS, PRESSURE_ANGLE_RAD];
}

rules! {
    x:
    Finite "finite" true;
    Positive "> 0" x > 0.0;
    NonNegative ">= 0" x >= 0.0;
    Restitution "in (0, 1]" x > 0.0 && x <= 1.0;
    PoissonRatio "in [0, 0.5]" (0.0..=0.5).contains(&x);
    AtLeastOne ">= 1" x >= 1.0;
    Turns "in [0, 1e6]" (0.0..=MAX_TURNS).contains(&x);
    SomeTurns "in (0, 1e6]" x > 0.0 && x <= MAX_TURNS;
    Probability "in (0, 1)" x > 0.0 && x < 1.0;
    PressureAngle ">= 0 deg and < 45 deg" (0.0..PRESSURE_ANGLE_RAD).contains(&x);
    RequiredProbability "in (0, 1]" x > 0.0 && x <= 1.0;
}
