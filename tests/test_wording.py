"""Numbers and their nouns in messages."""

import pytest

from domeshim.wording import counted


@pytest.mark.parametrize(
    ("number", "said"),
    [(0, "0 pictures"), (1, "1 picture"), (2, "2 pictures"), (1234567, "1234567 pictures")],
)
def test_one_is_said_in_the_singular(number, said):
    assert counted(number, "picture") == said


def test_a_plural_of_its_own():
    assert [counted(n, "vertex", "vertices") for n in (1, 2)] == ["1 vertex", "2 vertices"]


@pytest.mark.parametrize(("seconds", "said"), [(1.0, "1 second"), (0.5, "0.5 seconds"), (60.0, "60 seconds")])
def test_measures_are_said_without_idle_digits(seconds, said):
    assert counted(seconds, "second") == said
