"""What a folder of pictures says of itself: the plan, the machine, each picture's hash, and what failed."""

from __future__ import annotations

import json
import platform
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from domeshim import __version__
from domeshim.errors import DomeError
from domeshim.render.files import digest, write
from domeshim.render.plan import Plan, Reel

NAME = "manifest.json"


@dataclass
class Manifest:
    """The record of one plan's pictures, kept beside them."""

    plan: Plan
    hashes: dict[str, str] = field(default_factory=dict)
    """SHA-256 of each made picture's pixels, by its file's path within the folder."""
    failed: dict[str, str] = field(default_factory=dict)
    """Why a picture could not be made."""
    notes: list[str] = field(default_factory=list)

    @property
    def path(self) -> Path:
        """Its file."""
        return self.plan.output / NAME

    def key(self, frame: int, eye: str) -> str:
        """What a picture is called in it."""
        return str(self.plan.path(frame, eye).relative_to(self.plan.output))

    def save(self) -> None:
        """Write it.

        Raises OSError.
        """
        plan = self.plan
        said = {
            "domeshim": __version__,
            "python": platform.python_version(),
            "machine": f"{platform.system()} {platform.machine()}",
            "fingerprint": plan.fingerprint,
            "program": asdict(plan.reel),
            "frames": [plan.first, plan.last],
            "size": plan.size,
            "name": plan.name,
            "suffix": plan.suffix,
            "offset": plan.offset,
            "eyes": list(plan.eyes),
            "tile": plan.tile,
            "pictures": dict(sorted(self.hashes.items())),
            "failed": self.failed,
            "notes": self.notes,
        }
        write(self.path, json.dumps(said, indent=1).encode())

    @classmethod
    def load(cls, folder: Path) -> Manifest:
        """The manifest of a folder.

        Raises DomeError where there is none, or one that cannot be read.
        """
        path = folder / NAME
        try:
            said: dict[str, Any] = json.loads(path.read_text())
            first, last = said["frames"]
            plan = Plan(
                Reel.from_json(json.dumps(said["program"])),
                first,
                last,
                said["size"],
                folder,
                said["name"],
                said["suffix"],
                said["offset"],
                tuple(said["eyes"]),
                said["tile"],
            )
            return cls(plan, said["pictures"], said["failed"], said["notes"])
        except FileNotFoundError:
            raise DomeError(f"{folder}: no {NAME} in it: not a folder of rendered pictures") from None
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise DomeError(f"{path}: cannot be read ({error})") from None

    def resume(self) -> None:
        """Take over what an interrupted run of the same plan has already noted."""
        try:
            before = Manifest.load(self.plan.output)
        except DomeError:
            return
        if before.plan.fingerprint == self.plan.fingerprint:
            self.hashes |= before.hashes
            wanted = self.wanted
            self.failed |= {key: why for key, why in before.failed.items() if key not in wanted}

    @property
    def wanted(self) -> set[str]:
        """The plan's pictures."""
        plan = self.plan
        return {self.key(frame, eye) for eye in plan.eyes for frame in plan.frames}

    @property
    def keys(self) -> list[str]:
        """What shall be in the folder: the plan's pictures, and those that were asked for before."""
        return sorted(self.wanted | set(self.hashes) | set(self.failed))

    def complaints(self) -> dict[str, str]:
        """What is wrong with the folder's pictures, by file: missing, not whole, or not what was rendered."""
        found = {key: self._complaint(key) for key in self.keys}
        return {key: complaint for key, complaint in found.items() if complaint}

    def _complaint(self, key: str) -> str:
        try:
            found = digest(self.plan.output / key)
        except FileNotFoundError:
            return f"missing ({self.failed[key]})" if key in self.failed else "missing"
        if found is None:
            return "not a whole picture"
        known = self.hashes.get(key)
        if known is None:
            return "not in the manifest"
        return "" if found == known else "differs from what was rendered"
