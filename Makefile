# make demo: see the dome. make test: all checks. All make .venv on the way; PYTHON chooses its interpreter.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
DEMO := demos/teapots.py
PICTURES := pictures
DEBIAN := libegl1 libgl1-mesa-dri libglx-mesa0 libglu1-mesa libglut3.12 xvfb xdotool

.PHONY: demo test check-style docs report corpus sensitivity gallery guide figures bench-immediate stability watertight \
	endurance debian clean

demo: $(VENV)/installed
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ]; then \
		DOME=1 $(BIN)/python $(DEMO); \
	else \
		for place in far closer closest; do for mode in monitor dome; do \
			picture=$(PICTURES)/teapots-$$place-$$mode.png; \
			$(BIN)/domeshim capture --mode $$mode --output $$picture $(DEMO) $$place || exit; \
			echo "No display here; wrote $$picture"; \
		done; done; \
	fi

test: $(VENV)/developed debian check-style docs
	$(BIN)/python -m pytest

check-style: $(VENV)/developed
	$(BIN)/ruff check .
	$(BIN)/mypy

# The documentation as a site, in site/; a broken link or anchor fails.
docs: $(VENV)/developed
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --quiet

# Every program of PyOpenGL-Demo beside stock PyOpenGL: docs/corpus.md, in some ten minutes.
corpus: $(VENV)/developed debian
	$(BIN)/python benchmarks/corpus.py

# The demos' pictures, on the monitor and on the dome: docs/gallery, in a few minutes.
gallery: $(VENV)/developed
	$(BIN)/python benchmarks/gallery.py

# The curves and pictures in docs/mathematics.md and docs/methods.md.
figures: $(VENV)/developed
	$(BIN)/python benchmarks/figures.py
# The pictures of docs/dome.md, in a minute or two.
guide: $(VENV)/developed
	$(BIN)/python benchmarks/guide.py

# What the dome costs each way to draw, dome over monitor: a line for each, in a minute or two.
bench-immediate: $(VENV)/developed debian
	$(BIN)/python benchmarks/immediate.py

# How exact each method is on stiff and extreme geometry: docs/stability.md, in a quarter of an hour.
stability: $(VENV)/developed debian
	$(BIN)/python benchmarks/stability.py

# 1,000 random meshes by each method, white on black: not one pinhole. In some ten minutes.
watertight: $(VENV)/developed debian
	MESHES=1000 $(BIN)/python -m pytest tests/pictures/test_watertight.py

# Error against run time, and the shim's own cost: docs/report.md, in some five minutes; VTK's where it is installed.
report: $(VENV)/developed debian
	$(BIN)/python benchmarks/report.py

# 100,000 pictures: memory and GL's objects on the way, in some ten minutes.
endurance: $(VENV)/developed debian
	$(BIN)/python benchmarks/endurance.py

# What domeshim compare says of known faults: the table in docs/compare.md, in some minutes.
sensitivity: $(VENV)/developed debian
	$(BIN)/python benchmarks/sensitivity.py $(PICTURES)

# Installed editable, so the stamps go stale only with what an installation copies.
COPIED := pyproject.toml domeshim.pth domeshim.start _domeshim_gate.py

$(VENV)/installed: $(COPIED) | $(VENV)/bin/python
	$(BIN)/pip install --quiet --editable .
	touch $@

$(VENV)/developed: $(COPIED) | $(VENV)/bin/python
	$(BIN)/pip install --quiet --editable . --group dev
	touch $@ $(VENV)/installed

# pip knows dependency groups from 25.1 on.
$(VENV)/bin/python:
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --upgrade "pip>=25.1"

# What the tests need of the system: a GL without a display, and one with a display of its own.
debian:
	@command -v dpkg-query >/dev/null || exit 0; \
	missing=; for package in $(DEBIAN); do \
		dpkg-query -W -f '$${Status}' $$package 2>/dev/null | grep -q 'ok installed' || missing="$$missing $$package"; \
	done; \
	[ -z "$$missing" ] && exit 0; \
	if [ "$$(id -u)" = 0 ]; then \
		apt-get update -qq && apt-get install -qq -y --no-install-recommends $$missing; \
	else \
		echo "Please install what the tests need: sudo apt-get install$$missing" >&2; exit 1; \
	fi

clean:
	rm -rf $(VENV) $(PICTURES) build dist site .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
