from __future__ import annotations

import pytest

from domeshim.window.clock import PATIENCE, RealClock, VirtualClock


def test_virtual_clock_reads_zero_in_the_first_picture_and_counts_frames_exactly() -> None:
    clock = VirtualClock(fps=60)
    moments = []
    for _ in range(100):
        moments.append(clock.now())
        clock.frame_finished()
    assert moments == [n / 60 for n in range(100)]


def test_a_jump_within_a_frame_counts_towards_it() -> None:
    clock = VirtualClock(fps=60)
    clock.advance_to(0.016)
    assert clock.now() == pytest.approx(0.016)
    clock.frame_finished()
    assert clock.now() == 1 / 60


def test_a_long_jump_puts_later_frames_off_and_time_goes_on_from_there() -> None:
    clock = VirtualClock(fps=10)
    clock.frame_finished()
    clock.advance_to(1.0)
    clock.frame_finished()
    assert clock.now() == pytest.approx(1.0)
    clock.frame_finished()
    assert clock.now() == pytest.approx(1.1)


def test_virtual_clock_never_goes_back() -> None:
    clock = VirtualClock()
    clock.advance_to(2.0)
    clock.advance_to(1.0)
    assert clock.now() == 2.0


def test_reading_without_end_moves_the_virtual_clock_until_the_next_frame() -> None:
    clock = VirtualClock(fps=1)
    assert {clock.read() for _ in range(PATIENCE)} == {0.0}
    assert [clock.read() for _ in range(3)] == pytest.approx([0.001, 0.002, 0.003])
    clock.frame_finished()
    assert {clock.read() for _ in range(100)} == {1.0}


@pytest.mark.parametrize("fps", [0, -1, float("nan")])
def test_fps_must_be_positive(fps: float) -> None:
    with pytest.raises(ValueError, match="fps must be greater than 0"):
        VirtualClock(fps)


def test_real_clock_goes_by_itself_and_cannot_be_moved() -> None:
    clock = RealClock()
    clock.advance_to(1e6)
    clock.frame_finished()
    first = clock.now()
    assert 0 <= first < 60
    while clock.now() == first:
        pass
    assert clock.now() > first
