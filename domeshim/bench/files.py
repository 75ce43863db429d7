"""What the bench leaves on disk: a table, JSON, the plot."""

from __future__ import annotations

import json
from pathlib import Path

from domeshim.bench.plot import work_precision
from domeshim.bench.results import Results
from domeshim.errors import OptionError


def write(results: Results, folder: Path) -> None:
    """bench.md, bench.json and bench.png. Raises OptionError where they cannot be written."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "bench.json").write_text(json.dumps(results.as_json(), indent=2) + "\n")
        (folder / "bench.md").write_text(results.markdown())
        work_precision(results, folder / "bench.png")
    except OSError as error:
        raise OptionError(f"--output={folder}: {error.strerror or error}; accepted: a folder") from None
