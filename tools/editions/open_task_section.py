"""Write what instructors get of an open task: levels, and two example answers with their marks."""

from __future__ import annotations

import inspect
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from solutions._open_answers import MOST, load_marked_tasks
from tools.derive.open_tasks import get_label

if TYPE_CHECKING:
    from content.chapters import Chapter
    from solutions._open_answers import Answer, Marked

FIGURES = Path("open_tasks")  # below the pages

NAMES = {"strong": "A strong answer", "typical": "A typical answer, with gaps"}


def make_section(chapter: Chapter, marked: Marked) -> str:
    """Return the section of one chapter's page."""
    task = marked.task
    levels = "\n".join(
        f"| {name} | {' | '.join(text.strip() for text in texts)} |"
        for name, texts in marked.levels.items()
    )
    answers = "\n\n".join(make_answer(chapter, one) for one in marked.answers)
    source = inspect.getsource(sys.modules[marked.answers[0].measure.__module__]).strip()
    return f"""## Open task: {task.title}

The task and what is looked at stand {{ref}}`on the exercise page <{get_label(chapter)}>`. It is no
part of the 100 points. Each criterion earns 0, 1 or 2:

| Criterion | 0 | 1 | 2 |
|---|---|---|---|
{levels}

Both answers below were written for this page. Their numbers were measured in this scene by the code
under them, and the tests measure them again.

{answers}

:::{{admonition}} Show the code of both answers
:class: dropdown
```python
{source}
```
:::"""


def make_answer(chapter: Chapter, answer: Answer) -> str:
    """Return one answer: text, figure, marks."""
    quoted = "\n".join(f"> {line}".rstrip() for line in answer.fill(answer.text).splitlines())
    marks = "\n".join(
        f"| {name} | {one.mark} | {answer.fill(one.because)} |"
        for name, one in answer.marks.items()
    )
    return f"""### {NAMES[answer.kind]} to the open task of {chapter.name.lower()}

{quoted}

```{{figure}} {get_figure(chapter, answer.kind).as_posix()}
:alt: {answer.alt}

{answer.caption}
```

| Criterion | Marks | Why |
|---|---:|---|
{marks}
| **Sum** | **{answer.total} of {MOST * len(answer.marks)}** | |"""


def get_figure(chapter: Chapter, kind: str) -> Path:
    """Return where the figure of an answer lies, as seen from the pages."""
    return FIGURES / f"{chapter.id}_{kind}.png"


def draw_figures(pages: Path, chapters: dict[str, Chapter]) -> int:
    """Measure all answers anew and write their figures; return how many."""
    count = 0
    for page, marked in load_marked_tasks().items():
        for answer in marked.answers:
            path = pages / get_figure(chapters[page], answer.kind)
            path.parent.mkdir(parents=True, exist_ok=True)
            png = answer.measure().figure.png
            # an unchanged file keeps its time, so that Sphinx does not copy it again
            if not path.is_file() or path.read_bytes() != png:
                path.write_bytes(png)
            count += 1
    return count
