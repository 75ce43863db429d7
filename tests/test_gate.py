"""The start-up hook, in real interpreters: a bare virtual environment with the hook in its site-packages."""

from __future__ import annotations

import json
import os
import pkgutil
import shutil
import subprocess
import sys
import venv
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent
HOOK = ("domeshim.pth", "domeshim.start", "_domeshim_gate.py")
Run = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture(scope="module")
def bare_python(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("bare")
    venv.create(folder, symlinks=True)
    return folder / "bin" / "python"


@pytest.fixture
def site(bare_python: Path):
    """The site-packages with domeshim in it; each test finds it whole."""
    [folder] = bare_python.parent.parent.glob("lib/python*/site-packages")
    shutil.rmtree(folder)
    folder.mkdir()
    for name in HOOK:
        shutil.copy(ROOT / name, folder)
    shutil.copytree(ROOT / "domeshim", folder / "domeshim", ignore=shutil.ignore_patterns("__pycache__"))
    return folder


@pytest.fixture
def run(bare_python: Path, site: Path, tmp_path: Path) -> Run:
    """Runs a program of these lines with these variables set."""

    def run(program: str, *flags: str, **variables: str) -> subprocess.CompletedProcess[str]:
        (tmp_path / "prog.py").write_text(program)
        environ = {name: os.environ[name] for name in os.environ if not name.startswith(("DOME", "PYTHON"))}
        command = [str(bare_python), *flags, str(tmp_path / "prog.py")]
        return subprocess.run(
            command, env=environ | variables, capture_output=True, text=True, timeout=LONGEST
        )

    return run


LIST_MODULES = "import sys, json; print(json.dumps(sorted(sys.modules)))"
COUNT_FINDERS = "import sys; print(sum(type(f).__name__ == 'ImportFinder' for f in sys.meta_path))"


@pytest.mark.parametrize("variables", [{}, {"DOME": ""}, {"DOME": "0"}, {"DOME": " 0 "}])
def test_dome_off_imports_just_what_python_imports_without_the_hook(run, site, variables):
    with_hook = set(json.loads(run(LIST_MODULES, **variables).stdout))
    assert not any("domeshim" in name for name in with_hook - {"_domeshim_gate"})
    assert "_domeshim_gate" not in with_hook or sys.version_info >= (3, 15)  # PEP 829 always imports it
    for name in HOOK:
        (site / name).write_text("\n")  # Python 3.13 has a codec to load for any such file
    assert with_hook - {"_domeshim_gate"} == set(json.loads(run(LIST_MODULES, **variables).stdout))


def test_dome_on_arms_the_finder_and_loads_nothing_heavy(run):
    result = run(COUNT_FINDERS + "\n" + LIST_MODULES, DOME="1")
    count, modules = result.stdout.splitlines()
    assert count == "1"
    assert not {"OpenGL", "numpy", "glfw", "moderngl", "click", "PIL"} & set(json.loads(modules))
    assert result.stderr == ""


def test_the_hook_run_twice_arms_once(run, site):
    shutil.copy(site / "domeshim.pth", site / "another.pth")
    again = f"import site; site.addsitedir({str(site)!r}); import _domeshim_gate; _domeshim_gate.arm()\n"
    assert run(again + COUNT_FINDERS, DOME="1").stdout == "1\n"


def _folder_gone(site: Path) -> None:
    shutil.rmtree(site / "domeshim")


def _startup_gone(site: Path) -> None:
    (site / "domeshim" / "startup.py").unlink()


def _startup_cut_off(site: Path) -> None:
    (site / "domeshim" / "startup.py").write_text("def arm_at_start(:\n")


def _startup_raises(site: Path) -> None:
    (site / "domeshim" / "startup.py").write_text("raise RuntimeError('two\\nlines')\n")


def _empty_folder(site: Path) -> None:
    shutil.rmtree(site / "domeshim")
    (site / "domeshim").mkdir()


BREAKAGES = [_folder_gone, _startup_gone, _startup_cut_off, _startup_raises, _empty_folder]


@pytest.mark.parametrize("breakage", BREAKAGES)
def test_a_broken_installation_says_so_in_one_line_and_python_starts(run, site, breakage):
    breakage(site)
    broken = run("print('here')", DOME="1")
    assert (broken.returncode, broken.stdout) == (0, "here\n")
    assert len(broken.stderr.splitlines()) == 1
    assert broken.stderr.startswith("domeshim: DOME is set, but the installation is broken")
    off = run("print('here')")
    assert (off.returncode, off.stdout, off.stderr) == (0, "here\n", "")


def test_a_hook_without_its_gate_does_not_stop_python(run, site):
    (site / "_domeshim_gate.py").unlink()
    assert run("print('here')", DOME="1").stdout == "here\n"
    if sys.version_info < (3, 15):
        assert run("print('here')").stderr == ""


def test_a_broken_installation_without_stderr_does_not_stop_python(bare_python, site, tmp_path):
    _folder_gone(site)
    out = tmp_path / "out"
    shell = f'DOME=1 \'{bare_python}\' -c \'open("{out}", "w").write("here")\' 2>&-'
    assert subprocess.run(shell, shell=True, timeout=LONGEST).returncode == 0
    assert out.read_text() == "here"


@pytest.mark.parametrize("flags", [(), ("-I",), ("-X", "dev")])
def test_a_malformed_option_is_one_line_and_status_2_before_the_programs_first_line(run, flags):
    result = run("print('here')", *flags, DOME="1", DOME_FOV="abc")
    assert result.returncode == 2
    assert result.stdout == ""
    assert result.stderr == "domeshim: DOME_FOV=abc: not a number; accepted: degrees over 0 to 360\n"


def test_with_the_dome_off_a_malformed_option_is_not_even_read(run):
    assert run("print('here')", DOME_FOV="abc").stdout == "here\n"


def test_a_dome_error_at_the_top_is_one_line(run):
    result = run("from domeshim.errors import ScreenError\nraise ScreenError('no screen')", DOME="1")
    assert (result.returncode, result.stderr) == (1, "domeshim: no screen\n")


def test_other_errors_keep_their_traceback(run):
    result = run("1 / 0", DOME="1")
    assert result.returncode == 1
    assert result.stderr.startswith("Traceback (most recent call last):")
    assert result.stderr.endswith("ZeroDivisionError: division by zero\n")


def test_each_file_of_the_hook_is_one_line():
    pth, start = ((ROOT / name).read_text() for name in HOOK[:2])
    assert pth.count("\n") == start.count("\n") == 1
    assert pth.startswith("import ")
    assert callable(pkgutil.resolve_name(start.strip()))  # as PEP 829 says that it is looked up


FAKE_OVERLAY = """
import sys, types
calls = []
class Overlay:
    def __init__(self, session): calls.append(("made", session.options.enabled))
    def module_imported(self, name, module): calls.append((name, module.__name__, hasattr(module, "glBegin")))
    def remove(self): calls.append("removed")
fake = types.ModuleType("domeshim.intercept.overlay")
fake.Overlay = Overlay
sys.modules["domeshim.intercept.overlay"] = fake
"""


@pytest.fixture
def own_opengl(tmp_path: Path) -> None:
    """A program's own copy of PyOpenGL beside it, where GLUT brings GL along."""
    files = {"": "", "GL": "def glBegin(): pass\n", "GLU": "", "GLUT": "import OpenGL.GL\n"}
    for name, text in files.items():
        folder = tmp_path / "OpenGL" / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "__init__.py").write_text(text)


@pytest.mark.usefixtures("own_opengl")
def test_the_overlay_hears_of_a_programs_own_opengl(run):
    result = run(FAKE_OVERLAY + "import OpenGL.GLUT, OpenGL.GLU\nprint(calls)", DOME="1")
    assert result.stderr == ""
    assert result.stdout == str([
        ("made", True),
        ("OpenGL.GL", "OpenGL.GL", True),
        ("OpenGL.GLUT", "OpenGL.GLUT", False),
        ("OpenGL.GLU", "OpenGL.GLU", False),
    ]) + "\n"  # fmt: skip


@pytest.mark.usefixtures("own_opengl")
def test_install_is_once_and_uninstall_puts_all_back(run):
    program = """
import OpenGL.GL, domeshim
before = list(sys.meta_path), sys.excepthook
domeshim.install(); domeshim.install()
print(calls)
domeshim.install(dome=False)
print(calls[2:])
domeshim.uninstall(); domeshim.uninstall()
print(calls[5:], (sys.meta_path, sys.excepthook) == before)
import OpenGL.GLU
print(calls[6:])
"""
    heard = ("OpenGL.GL", "OpenGL.GL", True)
    lines = [[("made", True), heard], ["removed", ("made", False), heard]]
    result = run(FAKE_OVERLAY + program)
    assert result.stderr == ""
    assert result.stdout.splitlines() == [*map(str, lines), "['removed'] True", "[]"]


@pytest.mark.usefixtures("own_opengl")
def test_an_overlay_that_imports_what_is_watched_is_not_lost_in_itself(run):
    beginning = "def __init__(self, session):"
    program = FAKE_OVERLAY.replace(beginning, beginning + " import OpenGL.GLU;")
    result = run(program + "import OpenGL.GL\nprint([call[0] for call in calls])", DOME="1")
    assert result.stderr == ""
    assert result.stdout == "['made', 'OpenGL.GL', 'OpenGL.GLU']\n"
