# The verbs of the project. A fresh machine needs Python 3.11+ with pip, and make.
PYTHON ?= python3
export PYTHONDONTWRITEBYTECODE :=   # packages are installed uncompiled: what is imported is compiled once, not by each process
BIN := .venv/$(if $(filter Windows_NT,$(OS)),Scripts,bin)
DEMO := build/demo
KILLS ?= 120
SECONDS ?= 60
MUTANTS ?= 150
SEED ?= 1
CLASS ?=
PEERS ?=
TESTS ?=
SHARD ?= 1/1
APART := build/apart
LOWEST := build/lowest
OLD_IS_NO_FAULT := -W ignore::DeprecationWarning -W ignore::PendingDeprecationWarning -W ignore::FutureWarning
RECORDS ?= $(CURDIR)/../shared/records
NO_BROWSER := chromium and chromium-driver do not install here; tests that open the HTML report in them will be skipped

.PHONY: help demo test test-wheel check dist wheel lowest costs bench study peers fuzz adversary kill faults mutate figures pages docs docs-links same catalogue lock

help:                      ## the verbs, and what each does
	@$(PYTHON) -c 'import re; print(*(f"make {v:12} {t}" for v, t in re.findall(r"(?m)^([a-z-]+):[^#\n]*## *(.*)", open("Makefile").read())), sep="\n")'

demo: .venv/program        ## the main job on the shipped example; the last line printed is the path of the report
	rm -rf $(DEMO)
	$(BIN)/assess new $(DEMO) --example casa_grande
	$(BIN)/assess run $(DEMO) -o $(DEMO)/results || case $$? in 1|3) ;; *) exit 1 ;; esac
	@echo $(DEMO)/results/report.pdf

test: .venv/tests .venv/cad .venv/serve .venv/browser      ## every test but the benchmarks, in two processes
	$(BIN)/python -m pytest -n 2 --dist worksteal -rs $(TESTS)

test-wheel: dist .venv/browser   ## the same tests, or a SHARD of them, alone in another folder: what they import is the wheel, installed
	rm -rf $(APART)
	mkdir -p $(APART)/tests
	tar --extract --file dist/*.tar.gz --directory $(APART)/tests --strip-components 1
	cd $(APART)/tests && rm -rf assess records reports spectra
	$(PYTHON) -m venv $(APART)/env
	$(APART)/env/bin/python -m pip install --quiet --disable-pip-version-check --require-hashes --requirement requirements.lock
	-$(APART)/env/bin/python -m pip install --quiet --disable-pip-version-check --require-hashes --requirement requirements-cad.lock
	$(APART)/env/bin/python -m pip install --quiet --disable-pip-version-check --no-deps dist/*.whl
	cd $(APART)/tests && ASSESS_SHARD=$(SHARD) ASSESS_RECORDS=$(RECORDS) ../env/bin/python -m pytest -n 2 --dist worksteal -rs $(TESTS)

check: .venv/tests         ## style, types, direction of imports
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

bench: .venv/tests         ## speed, as ratios measured in one run; those to fixed work, beside the last release, into docs/speed.md
	$(BIN)/python -m tools.benchmarks.bench_drag
	$(BIN)/python tools/benchmarks/bench_dynamics.py
	$(BIN)/python -m tools.benchmarks.bench_fragility
	$(BIN)/python -m tools.benchmarks.bench_growth
	$(BIN)/python tools/benchmarks/bench_interfaces.py
	$(BIN)/python tools/benchmarks/bench_mechanisms.py
	$(BIN)/python tools/benchmarks/bench_mesh.py
	$(BIN)/python -m tools.benchmarks.bench_portfolio
	$(BIN)/python -m tools.benchmarks.bench_records
	$(BIN)/python tools/benchmarks/bench_report.py
	$(BIN)/python -m tools.benchmarks.bench_ratios

study: .venv/tests .venv/cad  ## tests too slow for every change: those marked study, and properties over many more cases
	$(BIN)/python -m pytest -n 2 --dist worksteal -rs -m study $(TESTS)
	$(if $(TESTS),,HYPOTHESIS_PROFILE=deep $(BIN)/python -m pytest -n 2 --dist worksteal tests/properties)

peers: build/peers/installed  ## speed and error beside other programs, in an environment of their own, into docs/speed.md
	build/peers/bin/python -m tools.benchmarks.peers --write $(PEERS)

fuzz: .venv/tests          ## mutated inputs for SECONDS by SEED, of CLASS if given, by JOBS processes: docs/robustness.md
	$(BIN)/python -m tools.fuzz --seconds $(SECONDS) --seed $(SEED) $(if $(CLASS),--class $(CLASS)) $(if $(JOBS),--jobs $(JOBS))

adversary: .venv/tests     ## every value at every key of projects that fail: none may buy a pass in silence: docs/robustness.md
	$(BIN)/python -m tools.adversary

kill: .venv/tests          ## KILLS runs and indexes killed at random and at aimed moments: nothing may be lost
	$(BIN)/python tools/kill/study.py $(KILLS)
	$(BIN)/python tools/kill/portfolio.py

dist: .venv/program        ## wheel and source distribution, without a network; what is in them is checked
	rm -rf dist
	$(BIN)/python -m hatchling build >/dev/null
	$(BIN)/python -m tools.distribution.contents dist

wheel: dist                ## the wheel in an empty environment, with the locked versions: `new`, `run` and `verify --quick` from another folder
	$(BIN)/python -m tools.distribution.try_wheel dist

lowest:                    ## with uv: the oldest versions that pyproject.toml allows; tests of files, numbers, projects and reports with them
	rm -rf $(LOWEST)
	uv venv --quiet --python $(PYTHON) $(LOWEST)
	uv pip compile pyproject.toml --all-extras --resolution lowest-direct --python $(LOWEST)/bin/python --quiet --output-file $(LOWEST)/lowest.txt
	uv pip install --quiet --python $(LOWEST)/bin/python --requirement $(LOWEST)/lowest.txt --constraint $(LOWEST)/lowest.txt --group dev --editable .
	$(LOWEST)/bin/python -m pytest -n 2 --dist worksteal -rs $(OLD_IS_NO_FAULT) $(or $(TESTS),tests/unit tests/end_to_end tests/validation)

costs: .venv/cad           ## what each dependency weighs, as a table in Markdown
	-$(BIN)/python -m compileall -q -j 2 .venv
	$(BIN)/python -m tools.distribution.costs

figures: .venv/tests .venv/cad .venv/serve .venv/browser       ## pictures and the notebook of docs/, with those of README.md; figures of the thesis drawn again, into build/figures
	$(BIN)/python docs/images/draw.py
	$(BIN)/python docs/images/theory.py
	$(BIN)/python docs/images/tutorial.py
	$(BIN)/python docs/images/guide.py
	$(BIN)/python docs/images/page.py
	$(BIN)/python docs/notebook/write.py
	$(BIN)/python tests/validation/thesis/draw_chapter_7.py

mutate: .venv/mutate       ## MUTANTS of physics and codes drawn by SEED, 95 % of them to be killed: docs/robustness.md
	$(BIN)/python -m tools.mutate --mutants $(MUTANTS) --seed $(SEED) $(if $(AGAIN),--again)

pages: .venv/tests         ## the pages of the manual that are made from the program and committed: docs/evidence.md, docs/reference
	$(BIN)/python -m docs.ext.pages

docs: .venv/docs           ## the manual in build/docs/html: spelling first; a warning is an error, and nothing is read from the network
	$(BIN)/codespell -D - -D docs/spelling.txt README.md CONTRIBUTING.md CHANGELOG.md docs assess spectra records reports
	$(BIN)/python -m sphinx -W --keep-going -q -j 2 -d build/docs/pages -b html docs build/docs/html
	@echo build/docs/html/index.html

docs-links: docs           ## links of the manual: within it each leads somewhere; OUTSIDE=1 asks the network for the others
	$(BIN)/python -m docs.ext.built_links build/docs/html
	$(if $(OUTSIDE),$(BIN)/python -m sphinx -q -j 2 -d build/docs/pages -b linkcheck docs build/docs/outside)

faults: .venv/tests        ## one fault at a time planted in a copy of the program: which solved cases turn red
	$(BIN)/python -m tools.faults

same: .venv/tests          ## BASE=<commit>: no number, name, outcome, order or key has changed since; texts that did are listed. CORPUS=folder: projects collected before
	$(if $(BASE),,$(error give the commit to compare with: make same BASE=<commit>))$(BIN)/python -m tools.same $(BASE) $(if $(CORPUS),--corpus $(CORPUS))

catalogue: .venv/tests     ## bring the Italian catalogue up to date with the source, and list what it lacks
	$(BIN)/python -m tools.catalogue it

lock:                      ## for developers, with uv: pin every dependency with its hashes
	uv pip compile pyproject.toml --group dev --universal --python-version 3.11 --generate-hashes --quiet --output-file requirements.lock
	uv pip compile pyproject.toml --constraint requirements.lock --universal --python-version 3.11 --generate-hashes --quiet --output-file requirements-run.lock
	uv pip compile --group build --constraint requirements.lock --universal --python-version 3.11 --generate-hashes --quiet --output-file requirements-build.lock
	uv pip compile --group docs --constraint requirements.lock --universal --python-version 3.11 --generate-hashes --quiet --output-file requirements-docs.lock
	uv pip compile pyproject.toml --extra cad --constraint requirements.lock --universal --python-version 3.11 --generate-hashes --quiet --output-file requirements-cad.lock
	uv pip compile pyproject.toml --extra serve --constraint requirements.lock --universal --python-version 3.11 --generate-hashes --quiet --output-file requirements-serve.lock

.venv/program: requirements-run.lock requirements-build.lock pyproject.toml  # the program, what it needs and what builds it
	@$(PYTHON) -c 'import sys; sys.exit(0 if sys.version_info >= (3, 11) else "Python 3.11 or newer is needed; say which with: make PYTHON=python3.12 …")'
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile --require-hashes --requirement requirements-run.lock --requirement requirements-build.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable .
	@touch $@

.venv/tests: requirements.lock .venv/program  # what tests, checks and measures it, beside that
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile --require-hashes --requirement requirements.lock
	@touch $@

.venv/docs: requirements-docs.lock .venv/tests  # Sphinx, its theme and its reader of Markdown, 60 MB
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes --requirement requirements-docs.lock
	@touch $@

.venv/cad: requirements-cad.lock .venv/tests  # readers of STEP, Rhino and IFC files, 330 MB, for their tests only
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes --requirement requirements-cad.lock \
		|| echo "the readers of STEP, Rhino and IFC files do not install here; their tests will be skipped"
	@touch $@

.venv/serve: requirements-serve.lock .venv/tests  # the server of the page in the browser, 15 MB, for its tests only
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes --requirement requirements-serve.lock \
		|| echo "viser does not install here; the tests of assess serve will be skipped"
	@touch $@

.venv/browser: .venv/program  # Debian's browser, 100 MB, in which tests open the HTML report
	@command -v chromedriver >/dev/null || tests/install_browser.sh || echo "$(NO_BROWSER)"
	@touch $@

build/peers/installed: .venv/tests pyproject.toml  # the group "peers", one by one: one that does not install is left out, and said so
	$(PYTHON) -m venv build/peers
	$(CURDIR)/$(BIN)/python -c 'import sysconfig; print(sysconfig.get_path("purelib")); print("$(CURDIR)")' \
		> $$(build/peers/bin/python -c 'import sysconfig; print(sysconfig.get_path("purelib"))')/ours.pth
	@for each in $$($(BIN)/python -c 'import tomllib; print(*tomllib.load(open("pyproject.toml", "rb"))["dependency-groups"]["peers"])'); do \
		build/peers/bin/python -m pip install --quiet --disable-pip-version-check "$$each" || echo "$$each does not install here"; done
	rm -rf build/peers/lib/python*/site-packages/tests  # eqsig installs its tests under a name that is ours
	@ldconfig -p | grep --quiet liblapack.so.3 || echo "openseespy also needs Debian's libblas3 and liblapack3"
	@touch $@

.venv/mutate: .venv/tests pyproject.toml  # the group "mutate", by a pip that may not know of groups yet
	$(BIN)/python -m pip install --quiet --disable-pip-version-check \
		$$($(BIN)/python -c 'import tomllib; print(*tomllib.load(open("pyproject.toml", "rb"))["dependency-groups"]["mutate"])')
	@touch $@
