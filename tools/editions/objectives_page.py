"""Write the page that shows, objective by objective, what the book does for it."""

from __future__ import annotations

from content.coverage import read_sources
from tools.derive.objectives import make_table, read_book, read_cards


def make_objectives_page(made_by: str) -> str:
    """Return the page: the map of the objectives, and how to read it."""
    book = read_book()
    table = make_table(book, read_sources(read_cards(), book))
    return f"""(page-instructor-objectives)=
# Where is each objective taught, worked, practiced, checked?

{made_by}

Most of this table is derived, from the files of exercises, completions, predictions, questions and
open tasks. No cell is empty for whoever does what is required; the tests keep it so. What stands in
italics is optional, and fills no cell.

**Taught** names the section. **Worked** names a twin: another problem of the same kind, solved
before your eyes. Where there is no twin, the cells of a section show it from the question to a
number or a picture. **Practiced** is what learners do themselves. **Checked** is what tells them
whether they were right; a prediction tells them, too, but only once.

{table}"""
