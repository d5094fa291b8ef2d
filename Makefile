# make demo        the report of the two-microphone 2 x 6 array, in demo/report.html
# make test        the tests, without the slow ones
# make unit        those of them to run while working: neither 3-D verification nor whole runs of commands
# make slow-test   the slow ones
# make docs        the manual as a site, in docs/build/html/index.html
# make lock        a lock with hashes and an SBOM of each extra, in build/supply-chain
# make audit       the installed packages against published advisories, where an index is reached
#
# All create a virtual environment in .venv and install into it what is missing; the second time nothing is.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
DESIGN ?= array-2x6
OUT ?= demo
# Processes that run tests side by side.
WORKERS ?= auto

PIP_INSTALL = $(BIN)/python -m pip install --constraint constraints.txt

.PHONY: demo test unit slow-test docs lock audit clean help

help:
	@sed -n 's/^# //p' Makefile | head -7

demo: $(VENV)/.installed
	$(BIN)/acoustic-fem run $(DESIGN) --out $(OUT)
	@echo "The report: $(abspath $(OUT))/report.html"

test: $(VENV)/.installed-dev
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal -m "not slow"

unit: $(VENV)/.installed-dev
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal

# In order: sorted by how many tests they have, files with one long test would come last and leave workers idle.
slow-test: $(VENV)/.installed-dev
	$(BIN)/python -m pytest -n $(WORKERS) --dist loadfile --no-loadscope-reorder -m slow

docs: $(VENV)/.installed-docs
	$(BIN)/sphinx-build --quiet --fresh-env --fail-on-warning --keep-going -b html docs docs/build/html
	$(BIN)/python docs/site/built.py docs/build/html
	$(BIN)/python docs/site/in_browser.py docs/build/html
	@echo "The manual: $(abspath docs/build/html/index.html)"

lock: $(VENV)/.created
	$(BIN)/python .ci/supply_chain.py lock
	$(BIN)/python .ci/supply_chain.py sbom

audit: $(VENV)/.installed
	$(BIN)/python .ci/supply_chain.py audit

# The package is installed in place: changed code needs no new installation, changed dependencies do.
$(VENV)/.installed: pyproject.toml constraints.txt | $(VENV)/.created
	$(PIP_INSTALL) --editable ".[all]"
	touch $@

$(VENV)/.installed-dev: pyproject.toml constraints.txt | $(VENV)/.created
	$(PIP_INSTALL) --editable ".[all,dev,docs]"
	touch $@ $(VENV)/.installed $(VENV)/.installed-docs

$(VENV)/.installed-docs: pyproject.toml constraints.txt | $(VENV)/.created
	$(PIP_INSTALL) --editable ".[all,docs]"
	touch $@

$(VENV)/.created:
	$(PYTHON) .ci/system_packages.py
	$(PYTHON) -m venv $(VENV)
	touch $@

clean:
	rm -rf $(VENV) $(OUT) docs/build docs/reference/made
