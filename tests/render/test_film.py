"""Pictures become a video of the right length and rate."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

from domeshim.errors import OptionError
from domeshim.render.show import Alone, render

av = pytest.importorskip("av")
from domeshim.render.film import Films  # noqa: E402 - not without PyAV


@pytest.mark.parametrize("suffix", ["mp4", "webm"])
def test_video_holds_every_picture_in_order(make_plan, progress, tmp_path, suffix):
    plan = make_plan(1, 5)
    films = Films(tmp_path / f"show.{suffix}", plan)
    render(plan, Alone(), progress, films)
    assert films.close()
    with av.open(str(tmp_path / f"show.{suffix}")) as video:
        pictures = [frame.to_ndarray(format="rgb24").astype(int) for frame in video.decode(video=0)]
        assert video.streams.video[0].average_rate == 60
    assert len(pictures) == 5
    for number, picture in enumerate(pictures, 1):
        assert abs(picture - np.asarray(Image.open(plan.path(number)))).mean() < 12


def test_video_without_all_pictures_is_thrown_away(make_plan, tmp_path):
    films = Films(tmp_path / "show.mp4", make_plan(1, 5))
    assert not films.close()
    assert not list(tmp_path.glob("*show*"))


def test_unknown_kind_of_video_is_refused(make_plan, tmp_path):
    with pytest.raises(OptionError, match="accepted"):
        Films(tmp_path / "show.gif", make_plan(1, 5))
