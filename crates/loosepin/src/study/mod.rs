//! Where mechanisms and uncertainty meet: a study file, its runs, its results.
