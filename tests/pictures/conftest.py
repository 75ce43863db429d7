"""One pair of stock GL and dome for the tests of a folder."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.pictures.beside import Beside


@pytest.fixture(scope="package")
def beside(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Beside]:
    pair = Beside(Path(tmp_path_factory.getbasetemp()) / "differences")
    yield pair
    pair.close()
