//! The largest model that is computed.

/// Largest number of moving bodies: `check` of such a chain takes seconds, and no drawing has more.
pub const MAX_BODIES: usize = 1000;
/// Joints, at most: in a grid of loops there are three for two bodies.
pub const MAX_JOINTS: usize = 2000;
/// Entries of each other table, at most.
pub const MAX_ENTRIES: usize = 1000;

/// Tables of a model file, what their entries are called, and how many there may be.
pub(in crate::model) const SIZES: [(&str, &str, usize); 10] = [
    ("body", "moving bodies", MAX_BODIES),
    ("joint", "joints", MAX_JOINTS),
    ("contact", "contacts", MAX_ENTRIES),
    ("coupling", "couplings", MAX_ENTRIES),
    ("cam", "cams", MAX_ENTRIES),
    ("spring", "springs", MAX_ENTRIES),
    ("load", "loads", MAX_ENTRIES),
    ("drive", "drives", MAX_ENTRIES),
    ("control", "controls", MAX_ENTRIES),
    ("output", "outputs", MAX_ENTRIES),
];
