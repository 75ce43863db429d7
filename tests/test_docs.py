"""The docs say what is there: every variable, every option, every message. Links are make docs' matter."""

import ast
import re
from pathlib import Path

import click
import pytest

from domeshim.cli import COMMANDS, commands
from domeshim.cli.meanings import MEANINGS
from domeshim.cli.settings import FIELDS
from domeshim.settings import VARIABLES

ROOT = Path(__file__).parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
REFERENCE = (ROOT / "docs" / "reference.md").read_text()
EXAMPLES = {"DOME_FVO", "DOME_NAME"}
"""Names on the pages that no variable has, on purpose."""

SAYS = {"say", "say_once", "_say", "DriverError", "ScreenError", "ShaderError"}
"""What tells the user of something, outside of settings and files."""

FOR_BENCHMARKS = {"reference.py", "formulas.py"}
"""What only the project's own benchmarks run."""


def test_the_reference_has_every_variable():
    rows = re.findall(r"^\| (`DOME.*?) \|", REFERENCE, re.MULTILINE)
    assert set(re.findall(r"DOME\w*", " ".join(rows))) == set(VARIABLES.values())


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_no_page_names_a_variable_that_there_is_not(page):
    named = set(re.findall(r"\bDOME(?:_[A-Z]+)*\b", page.read_text()))
    assert named <= set(VARIABLES.values()) | EXAMPLES


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_files_that_a_page_links_to_are_there(page):
    targets = re.findall(r"\]\(([^)#]+)[^)]*\)", page.read_text())
    missing = [t for t in targets if "://" not in t and not (page.parent / t).exists()]
    assert not missing


def all_commands():
    group = click.Context(commands)
    for name in COMMANDS:
        command = commands.get_command(group, name)
        if isinstance(command, click.Group):
            yield from ((f"{name} {sub}", command.commands[sub]) for sub in command.commands)
        else:
            yield name, command


@pytest.mark.parametrize(("name", "command"), list(all_commands()), ids=str)
def test_the_reference_has_every_option_and_no_other(name, command):
    section = REFERENCE.partition(f"\n### domeshim {name}")[2].partition("\n##")[0]
    assert section, "no section"
    by_dome = {f"--{field.replace('_', '-')}" for field in FIELDS}
    shared = {"-m", "-h", "--help"}
    if name != "run" and re.search(r"(options|settings)\s+of\s+`run`", section):
        shared |= by_dome
    told = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", section))
    options = [{*p.opts, *p.secondary_opts} for p in command.params if isinstance(p, click.Option)]
    assert not [names for names in options if not names & (told | shared)]
    assert told <= set().union(*options) | by_dome


def fixed_words(node, constants):
    """The parts of a text that are always the same, without those of the values in it."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return [node.value]
    if isinstance(node, ast.JoinedStr):
        return [part.value for part in node.values if isinstance(part, ast.Constant)]
    if isinstance(node, ast.Name):
        return constants.get(node.id, [])
    return []


def messages():
    """(where, words): the longest fixed part of each message that the package has for its user."""
    for path in sorted((ROOT / "domeshim").rglob("*.py")):
        if path.name in FOR_BENCHMARKS:
            continue
        tree = ast.parse(path.read_text())
        constants = {
            target.id: fixed_words(node.value, {})
            for node in tree.body
            if isinstance(node, ast.Assign)
            for target in node.targets
            if isinstance(target, ast.Name)
        }
        for node in ast.walk(tree):
            if not isinstance(node, ast.Call) or not node.args:
                continue
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            words = max(fixed_words(node.args[0], constants), key=len, default="").strip(" .:;,()")
            if name in SAYS and len(words) > 6:
                yield f"{path.relative_to(ROOT)}:{node.lineno}", words


def test_troubleshooting_has_every_message():
    page = " ".join((ROOT / "docs" / "troubleshooting.md").read_text().split())
    found = list(messages())
    assert len(found) > 40
    missing = [f"{where}: {words}" for where, words in found if words not in page]
    assert not missing, "\n".join(missing)


def test_help_says_what_each_setting_is():
    assert list(MEANINGS) == list(FIELDS)
