# Every target makes what it needs in .venv; PYTHON chooses the interpreter (3.11 or later).
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt

ROOMS := reference fast properties benchmarks reports

.DEFAULT_GOAL := help
.PHONY: help certify test lint bench clean

help: ## what there is to make
	@grep -hE '^[a-z]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## /\t/' | expand -t 12

certify: $(VENV)/certify ## certify the built-in implementation; writes certificates/fast/
	$(BIN)/affinecert certify

test: $(VENV)/dev ## all tests: the instrument, the laws, the docstrings' examples
	$(BIN)/python -m pytest tests --pyargs affinecert.properties --numprocesses 2 --dist loadscope

# mypy follows imports through folders: the rooms are laid out for it as they are installed.
lint: $(VENV)/dev ## ruff, and mypy in its strict mode, over all folders
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	rm -rf build/lint && mkdir -p build/lint/affinecert
	ln -s $(CURDIR)/affinecert/* $(addprefix $(CURDIR)/,$(ROOMS)) build/lint/affinecert
	ln -s $(CURDIR)/tests build/lint
	MYPYPATH=build/lint $(BIN)/mypy --cache-dir build/mypy -p affinecert -p tests

bench: $(VENV)/dev ## time every map beside scipy, the reference and a plain copy
	$(BIN)/python -m pytest --pyargs affinecert.benchmarks --benchmark-only --benchmark-json=benchmark.json
	$(BIN)/python -m affinecert.benchmarks.table benchmark.json

clean: ## remove what the other targets made
	rm -rf $(VENV) build certificates *.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis benchmark.json

$(BIN)/python:
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "affinecert needs Python 3.11 or later: make PYTHON=python3.12")'
	$(PYTHON) -m venv $(VENV)

$(VENV)/certify: $(BIN)/python pyproject.toml constraints.txt
	$(INSTALL) --editable .
	touch $@

$(VENV)/dev: $(BIN)/python pyproject.toml constraints.txt
	$(INSTALL) --editable '.[dev]'
	touch $@ $(VENV)/certify
