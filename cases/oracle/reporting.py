"""One line a check, and how many failed."""

failures = 0


def report(name, size, tolerance):
    global failures
    passed = size <= tolerance
    failures += not passed
    print(f"{'ok  ' if passed else 'FAIL'} {name}: {size:.2e} (limit {tolerance:.0e})")


def status():
    """1 where one failed: for the shell."""
    return 1 if failures else 0
