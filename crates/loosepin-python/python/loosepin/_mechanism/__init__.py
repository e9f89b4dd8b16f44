"""What is computed of a mechanism alone: parts of a run, sweeps, wear, motion without dynamics, checks. Studies are not here."""
