"""The start-up hook: Python calls arm() as it starts, and only a set DOME goes further.

It lies beside the package, not inside, so that with DOME off nothing of domeshim is ever imported.
Older Pythons come here through domeshim.pth, Python 3.15 and later through domeshim.start (PEP 829).
"""

import os
import sys

_tried = False


def arm() -> None:
    """Arm domeshim, once, if DOME asks for it; if that fails, say so in one line on stderr and go on."""
    global _tried  # noqa: PLW0603 - Python reads the hook of a virtual environment twice
    if _tried or os.environ.get("DOME", "").strip() in ("", "0"):
        return
    _tried = True
    try:
        from domeshim.startup import arm_at_start  # noqa: PLC0415 - nothing of domeshim unless asked for

        arm_at_start()
    except Exception as error:  # whatever is broken in there, Python shall start
        if sys.stderr is not None:
            reason = " ".join(f"{type(error).__name__}: {error}".split())
            sys.stderr.write(f"domeshim: DOME is set, but the installation is broken; no dome ({reason})\n")
