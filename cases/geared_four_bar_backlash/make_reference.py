"""Makes reference.csv and expected.toml of this case (see cases/oracle/README.md)."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "oracle"))
from reference import write

write(Path(__file__).parent)
