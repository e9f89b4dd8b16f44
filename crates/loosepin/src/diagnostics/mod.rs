//! Complaints about files: place, code, rule, hint.
