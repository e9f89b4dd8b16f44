//! Measurements: readings of a backlash test, features of a motion, a specimen. What `loosepin identify` makes of them stands in
//! `loosepin-identify`.

pub(crate) mod measured;
pub(crate) mod measurement;
pub(crate) mod motion;
pub(crate) mod specimen;
pub(crate) mod specimen_problem;
