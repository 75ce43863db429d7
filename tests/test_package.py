"""What an installation holds: the wheel, and the wheel that stands for a checkout."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import venv
import zipfile
from pathlib import Path

import pytest

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent
Completed = subprocess.CompletedProcess[str]
HOOK = {"domeshim.pth", "domeshim.start", "_domeshim_gate.py"}


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files that make the package, in a folder of their own."""
    folder = tmp_path_factory.mktemp("checkout")
    for name in ("domeshim", "glsl"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md", "LICENSE", ".gitignore", *HOOK):
        shutil.copy(ROOT / name, folder)
    return folder


def install(checkout: Path, folder: Path, kind: str) -> tuple[set[str], Path]:
    """Build the wheel and unpack it into a new virtual environment; the names in it and the python."""
    build = f"import hatchling.build as b; print(b.build_{kind}({str(folder)!r}))"
    made = run(Path(sys.executable), build, checkout, dict(os.environ))
    assert made.returncode == 0, made.stderr
    venv.create(folder / "venv", symlinks=True)
    [site] = (folder / "venv").glob("lib/python*/site-packages")
    with zipfile.ZipFile(folder / made.stdout.strip()) as wheel:
        wheel.extractall(site)
        return set(wheel.namelist()), folder / "venv" / "bin" / "python"


def run(python: Path, program: str, folder: Path, environ: dict[str, str]) -> Completed:
    command = [str(python), "-c", program]
    return subprocess.run(command, cwd=folder, env=environ, capture_output=True, text=True, timeout=LONGEST)


def output(python: Path, program: str, **variables: str) -> str:
    result = run(python, program, python.parent, variables)
    assert (result.returncode, result.stderr) == (0, "")
    return result.stdout


FINDERS = "import sys; print([type(f).__name__ for f in sys.meta_path].count('ImportFinder'))"
FOLDERS = (
    "import pathlib, domeshim; from domeshim.shading.snippets import glsl_folder;"
    "print(pathlib.Path(domeshim.__file__).parent); print(glsl_folder())"
)


def test_the_wheel_holds_the_package_the_snippets_and_the_hook(checkout, tmp_path):
    names, python = install(checkout, tmp_path, "wheel")
    snippets = {path.relative_to(checkout).as_posix() for path in (checkout / "glsl").rglob("*.glsl")}
    assert snippets
    assert {f"domeshim/{snippet}" for snippet in snippets} <= names
    assert {"domeshim/cli/run.py", "domeshim/py.typed"} <= names
    tops = {name.partition("/")[0] for name in names}
    assert {name for name in tops if not name.endswith(".dist-info")} == {"domeshim", *HOOK}
    [entry_points] = (name for name in names if name.endswith("entry_points.txt"))
    [site] = (tmp_path / "venv").glob("lib/python*/site-packages")
    assert "domeshim = domeshim.cli:main" in (site / entry_points).read_text()
    assert output(python, FINDERS) == "0\n"
    assert output(python, FINDERS, DOME="1") == "1\n"
    assert output(python, FOLDERS).split() == [str(site / "domeshim"), str(site / "domeshim" / "glsl")]


def test_an_editable_installation_reads_the_checkout_and_has_the_hook(checkout, tmp_path):
    names, python = install(checkout, tmp_path, "editable")
    assert names >= HOOK
    assert not any(name.startswith(("domeshim/", "glsl/")) for name in names)
    assert output(python, FINDERS) == "0\n"
    assert output(python, FINDERS, DOME="1") == "1\n"
    assert output(python, FOLDERS).split() == [str(checkout / "domeshim"), str(checkout / "glsl")]


def test_an_editable_installation_whose_checkout_is_gone_says_so_in_one_line(checkout, tmp_path):
    moved = tmp_path / "moved"
    shutil.copytree(checkout, moved)
    _, python = install(moved, tmp_path, "editable")
    shutil.rmtree(moved)
    result = run(python, "print('here')", tmp_path, {"DOME": "1"})
    assert (result.returncode, result.stdout) == (0, "here\n")
    assert result.stderr.startswith("domeshim: DOME is set, but the installation is broken")
    assert result.stderr.count("\n") == 1


def test_the_version_is_written_once(checkout, tmp_path):
    import domeshim

    names, _ = install(checkout, tmp_path, "wheel")
    assert f"domeshim-{domeshim.__version__}.dist-info/METADATA" in names
