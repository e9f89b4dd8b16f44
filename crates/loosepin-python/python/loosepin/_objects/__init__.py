"""How objects behave in Python: as exceptions, arrays, pickles and seeds, and what they write to the log."""
