"""What builds, derives, measures and draws the book: ``python -m tools.ROOM.NAME`` runs a tool.

| room | what it does |
|---|---|
| ``build`` | sets up the environment and builds the pages |
| ``vendor`` | fetches front-end files, packs Python for the pages |
| ``derive`` | writes what follows from the cards and the chapters |
| ``scaffold`` | writes the files of a new chapter or exercise, names what is unfilled |
| ``editions`` | the instructor's pages, the learner's zip |
| ``bench`` | measures speed against named peers |
| ``mutants`` | makes wrong functions from the references, scores the cases by them |
| ``environments`` | makes environments of their own: peers, other versions; tests in them |
| ``draw`` | first screen, figures, cover, textures, screenshots, places of explorers |
"""

from pathlib import Path

#: The repository.
ROOT = Path(__file__).resolve().parents[1]
