//! The `loosepin` command.

fn main() {}
