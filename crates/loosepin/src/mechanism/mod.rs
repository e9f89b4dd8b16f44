//! A model compiled for computing: tree, loops, slots, ideal position.
