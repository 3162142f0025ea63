# Camera Image Processing for Robotics. `make` alone lists the targets.

PYTHON ?= python3
VENV := .venv
ifeq ($(OS),Windows_NT)
BIN := $(VENV)/Scripts
else
BIN := $(VENV)/bin
endif
RUN := $(BIN)/python
export PYTHONHASHSEED := 0
# student (no solution in it) or instructor; `make book EDITION=instructor`
EDITION ?= student
export EDITION

.DEFAULT_GOAL := help
.PHONY: help setup book serve lab outputs exercises mutants new-chapter \
	new-exercise unfilled student test test-slow foreign matrix lint links format check bench lock clean

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "  make %-13s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

setup: ## install what is needed (every other target does it by itself)
	@$(PYTHON) -u -m tools.build.setup_env

book: setup ## execute every chapter and build the pages (EDITION=instructor: with solutions)
	@$(RUN) -m tools.build.book

serve: book ## build the pages and serve them at http://localhost:8000
	@$(RUN) -m http.server --bind 127.0.0.1 --directory _build/html 8000

lab: setup ## open the chapters as notebooks in JupyterLab
	@$(RUN) -m jupyter lab --ServerApp.default_url=/lab/tree/book

outputs: setup ## write the five files of the lab into outputs/
	@$(RUN) -m labutils --out outputs

exercises: setup ## derive starters, check tables, pages, rubric, hints, the map, numbers for JS
	@$(RUN) -m tools.derive.exercises
	@$(RUN) -m tools.derive.objectives
	@$(RUN) -m tools.derive.shared
	@$(RUN) -m tools.derive.page_mujoco

mutants: export OPENBLAS_NUM_THREADS := 1
mutants: setup ## score the cases: which share of 1600 wrong functions they refuse
	@$(RUN) -m tools.mutants.score

new-chapter: setup ## write the files of a chapter: ID=two-eyes [TITLE="What ...?"] [KIND=extension]
	@$(RUN) -m tools.scaffold.chapter --id "$(ID)" --title "$(TITLE)" --kind "$(KIND)"

new-exercise: setup ## write the files of an exercise: NAME=find_edges CHAPTER=two-eyes [KIND=lab]
	@$(RUN) -m tools.scaffold.exercise --name "$(NAME)" --chapter "$(CHAPTER)" --kind "$(KIND)" \
		--args "$(ARGS)"

unfilled: setup ## name the places that are still to be filled, by file and line
	@$(RUN) -m tools.scaffold.unfilled

student: setup ## pack the notebooks for learners: _build/student/camera-lab-student.zip
	@$(RUN) -m tools.editions.student

test: book ## run the tests, every page in a browser, every chapter as a notebook
	@$(RUN) -m pytest -n auto --dist worksteal -m "not slow"

test-slow: book ## run what is slow by nature: all seeds, scratch copies, other versions
	@echo "test-slow: needs what \`make test\` needs, and from the package index OpenCV 4.11"
	@$(RUN) -m pytest -n auto --dist worksteal -m slow --record-slow=book/_generated/slow_tests.md

foreign: setup ## look at robots of dm_control, robosuite and gymnasium; write what was found
	@$(RUN) -m tests.foreign --record-foreign=book/_generated/foreign.md

matrix: setup ## run the library's tests with the oldest and newest versions it supports
	@$(RUN) -m tools.environments.matrix

lint: setup ## check style, types and spelling
	@$(RUN) -m ruff check .
	@$(RUN) -m ruff format --check .
	@$(RUN) -m mypy
	@$(RUN) -m tools.build.javascript check
	@$(RUN) -m codespell_lib

links: book ## ask every page that the book links to, also those of others (needs a network)
	@$(RUN) -m tools.build.links

format: setup ## rewrite the source in the house style
	@$(RUN) -m ruff check --fix .
	@$(RUN) -m ruff format .
	@$(RUN) -m tools.build.javascript format

check: lint test ## what CI runs

bench: setup ## measure speed as ratios against named peers
	@$(RUN) -m tools.bench

lock: setup ## write requirements.txt anew, and the locks of tools/environments
	@$(RUN) -m uv pip compile requirements.in --universal --python-version 3.11 \
		--generate-hashes --no-annotate --no-header --quiet -o requirements.txt
	@$(RUN) -m tools.environments --lock

clean: ## remove everything `make` built, the virtual environment too
	@rm -rf _build outputs solutions/pages $(VENV) *.egg-info .pytest_cache .mypy_cache .ruff_cache
