"""domeshim run against Python itself: whatever a program can tell of how it is run must be the same."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent
PYTHON = [sys.executable]
DOMESHIM = [sys.executable, "-m", "domeshim", "run"]

PROBE = """\
'''The probe's docstring.'''
import atexit, pickle, sys
main = sys.modules["__main__"]
class Thing: pass
print(sys.argv, sys.path[0], __name__, __file__, __doc__)
print(__package__, __spec__ and __spec__.name, getattr(main, "__cached__", None) is None)
print(type(__builtins__).__name__, type(__loader__).__name__, main.Thing is Thing)
print(type(pickle.loads(pickle.dumps(Thing()))).__name__, [n for n in dir() if "dome" in n.lower()])
def f(x: 1 + 1): pass
print(f.__annotations__)
atexit.register(lambda: print("at exit", main.Thing.__name__))
"""


def run(command: list[str], folder: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    environ = {**os.environ, "PYTHONPATH": str(ROOT), **variables}
    return subprocess.run(command, cwd=folder, env=environ, capture_output=True, text=True, timeout=LONGEST)


def same(arguments: list[str], folder: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    """Both ways agree in status, stdout and stderr; gives what they agree in."""
    expected = run(PYTHON + arguments, folder, **variables)
    got = run(DOMESHIM + arguments, folder, **variables)
    assert got.stdout == expected.stdout
    assert got.stderr == expected.stderr
    assert got.returncode == expected.returncode
    return got


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "beside.py").write_text("here = True\n")
    (tmp_path / "sub" / "probe.py").write_text(PROBE + "import beside\n")
    return tmp_path


def test_a_program_sees_what_it_would_see_without_us(folder):
    result = same(["sub/probe.py", "a", "--help", "-m", "--", "--fov", "b c", ""], folder)
    assert "'--help', '-m', '--', '--fov', 'b c', ''" in result.stdout


def test_an_absolute_path_a_link_and_a_safe_path(folder):
    same([str(folder / "sub" / "probe.py")], folder)
    (folder / "link.py").symlink_to("sub/probe.py")
    same(["link.py"], folder)
    (folder / "sub" / "probe.py").write_text(PROBE)
    same(["sub/probe.py"], folder, PYTHONSAFEPATH="1")


def test_a_folder_a_zip_file_a_module_and_a_package(folder):
    (folder / "sub" / "__main__.py").write_text(PROBE)
    same(["sub", "x"], folder)
    same(["sub", "x"], folder, PYTHONSAFEPATH="1")
    with zipfile.ZipFile(folder / "packed.zip", "w") as archive:
        archive.writestr("__main__.py", PROBE)
    same(["packed.zip", "x"], folder)
    same(["-m", "sub", "--help"], folder)
    (folder / "sub" / "probe.py").write_text(PROBE)
    same(["-m", "sub.probe", "-x"], folder)


def test_a_compiled_program(folder):
    compiled = folder / "probe.pyc"
    run([*PYTHON, "-c", f"import py_compile; py_compile.compile('sub/beside.py', {str(compiled)!r})"], folder)
    same(["probe.pyc"], folder)


@pytest.mark.parametrize(
    "program",
    [
        "import sys; print('out'); print('err', file=sys.stderr); sys.exit(7)",
        "import sys; sys.exit('goodbye')",
        "import sys; sys.exit(None)",
        "raise SystemExit",
        "import os; os._exit(5)",
        "def f():\n    1 / 0\nf()\n",
        "try:\n    1 / 0\nexcept Exception as e:\n    raise KeyError('k') from e\n",
        "try:\n    1 / 0\nexcept Exception:\n    undefined\n",
        "raise ExceptionGroup('several', [ValueError(1), KeyError(2)])",
        "x = = 1\n",
        "if True:\nprint()\n",
        "# -*- coding: latin-1 -*-\nprint('\\xe4')\n",
        "import sys\nsys.excepthook = lambda *e: print('hooked', e[0].__name__, e[2].tb_lineno)\n1 / 0\n",
        "import threading, time\nthreading.Thread(target=lambda: print(time.sleep(0.2), 'end')).start()\n",
        "import nonexistent_module_of_the_program",
        "from __future__ import annotations\ndef f(x: whatever): pass\nprint(f.__annotations__)",
        "raise EOFError",
        "import inspect; print(inspect.stack()[0].filename, inspect.getsource(inspect.currentframe()))",
        "def check(n):\n    return n if n < 5 else check(n - 1)\nassert check(9) == 0, 'recursion'\n",
    ],
)
def test_exit_status_and_traceback_are_the_programs_own(folder, program):
    (folder / "prog.py").write_text(program, encoding="latin-1" if "latin" in program else "utf-8")
    same(["prog.py"], folder)


def test_an_interrupted_program_ends_by_the_signal(folder):
    (folder / "prog.py").write_text("def f():\n    raise KeyboardInterrupt\nf()\n")
    assert same(["prog.py"], folder).returncode == -signal.SIGINT


def test_workers_of_multiprocessing_find_the_programs_functions(folder):
    (folder / "prog.py").write_text(
        "import multiprocessing as mp\ndef double(x): return 2 * x\n"
        "if __name__ == '__main__':\n"
        "    with mp.get_context('spawn').Pool(1) as pool: print(pool.map(double, [1, 2]))\n"
    )
    assert same(["prog.py"], folder).stdout == "[2, 4]\n"


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (["nosuch.py"], "domeshim: cannot run nosuch.py: No such file or directory\n"),
        (["sub"], "domeshim: cannot run sub: no __main__ module in it\n"),
        (["-m", "nosuch"], "cannot run -m nosuch: no such module, or a package without __main__\n"),
        (["-m", "sub.nosuch"], "cannot run -m sub.nosuch: no such module, or a package without __main__\n"),
        (["--fov", "abc", "x.py"], "domeshim: --fov=abc: not a number; accepted: degrees over 0 to 360\n"),
        (["--hud=beside", "x.py"], "--hud=beside: not known; accepted: panel, flat, side, off\n"),
        ([], "domeshim: Missing argument 'PROG'.\n"),
        (["--hub", "off", "x.py"], "--hub"),
    ],
)
def test_bad_input_is_one_line_and_status_2(folder, arguments, line):
    result = run(DOMESHIM + arguments, folder)
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith("domeshim: ")
    assert line in result.stderr
    assert result.stderr.count("\n") == 1


def test_a_dome_error_ends_the_run_in_one_line(folder):
    (folder / "prog.py").write_text("from domeshim.errors import ScreenError as E\nraise E('no screen')\n")
    result = run([*DOMESHIM, "prog.py"], folder)
    assert (result.returncode, result.stdout, result.stderr) == (1, "", "domeshim: no screen\n")


@pytest.mark.parametrize("dome", [{}, {"DOME": "0"}, {"DOME": "1"}])
def test_run_turns_the_dome_on_whatever_the_environment_says(folder, dome):
    (folder / "prog.py").write_text(
        "import sys; from domeshim.session import current; s = current()\n"
        "print(s.options.enabled, s.options.fov, s.options.tilt, s.installation is not None)\n"
        "print(sum(type(f).__name__ == 'ImportFinder' for f in sys.meta_path))\n"
    )
    variables = {**dome, "DOME_FOV": "200", "DOME_TILT": "10"}
    result = run([*DOMESHIM, "--fov", "220", "prog.py"], folder, **variables)
    assert result.stdout == "True 220.0 10.0 True\n1\n"


def test_the_environment_of_the_programs_own_children_is_left_alone(folder):
    (folder / "prog.py").write_text("import os; print([n for n in os.environ if n[:4] in ('DOME', 'PYOP')])")
    environ = {name: value for name, value in os.environ.items() if name != "PYOPENGL_PLATFORM"}
    environ["PYTHONPATH"] = str(ROOT)
    command = [*DOMESHIM, "--fov", "200", "prog.py"]
    assert subprocess.run(command, cwd=folder, env=environ, capture_output=True, text=True).stdout == "[]\n"


def test_help_and_version(folder):
    from domeshim import __version__

    command = [sys.executable, "-m", "domeshim"]
    assert run([*command, "--version"], folder).stdout == f"domeshim {__version__}\n"
    assert "run" in run(command, folder).stdout
    assert "degrees over 0 to 360" in run([*command, "run", "--help"], folder).stdout
