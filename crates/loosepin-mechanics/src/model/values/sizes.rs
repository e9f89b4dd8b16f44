//! The largest model that is computed.

/// Moving bodies, at most: `check` of a chain of so many takes seconds, and no drawing has more.
pub const MOST_BODIES: usize = 1000;
/// Joints, at most: in a grid of loops there are three for two bodies.
pub const MOST_JOINTS: usize = 2000;
/// Entries of each other table, at most.
pub const MOST_ENTRIES: usize = 1000;

/// Tables of a model file, what their entries are called, and how many there may be.
pub(in crate::model) const SIZES: [(&str, &str, usize); 10] = [
    ("body", "moving bodies", MOST_BODIES),
    ("joint", "joints", MOST_JOINTS),
    ("contact", "contacts", MOST_ENTRIES),
    ("coupling", "couplings", MOST_ENTRIES),
    ("cam", "cams", MOST_ENTRIES),
    ("spring", "springs", MOST_ENTRIES),
    ("load", "loads", MOST_ENTRIES),
    ("drive", "drives", MOST_ENTRIES),
    ("control", "controls", MOST_ENTRIES),
    ("output", "outputs", MOST_ENTRIES),
];
