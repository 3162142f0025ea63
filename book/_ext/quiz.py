"""Draw the concept questions of a page: the directive ``quiz``.

The directive is named with a page, and draws the questions of
``exercises/concepts/<page>.yml``. Its body is shown only where nobody knows the
directive, in a notebook. Without JavaScript the questions can be read and the answers
unfolded; ``quiz.js`` turns them into a form that answers.
"""

from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.statemachine import StringList
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.domains.std import StandardDomain
from sphinx.util.docutils import SphinxDirective

from content import quiz_items

LETTERS = "ABCD"
LABEL = "quiz-{}"  # of a question: the id in the page and the name for {ref}


# docutils has no types, and names its nodes in lower case
class tag(nodes.General, nodes.TextElement):  # type: ignore[misc]  # noqa: N801
    """An HTML element that docutils has no node for; links may stand in it, as in a text."""

    @classmethod
    def make(cls, name: str, /, *children: nodes.Node, **attributes: str | bool) -> "tag":
        """Make an element; ``class_`` is written class, ``data_quiz`` data-quiz."""
        plain = {key.strip("_").replace("_", "-"): value for key, value in attributes.items()}
        return cls("", "", *children, html_name=name, html_attributes=plain)


def visit_tag(translator: Any, node: tag) -> None:
    """Open the element; an attribute that is True has no value, one that is False is left out."""
    parts = [node["html_name"]]
    for key, value in node["html_attributes"].items():
        if value is True:
            parts.append(key)
        elif value is not False:
            parts.append(f'{key}="{translator.attval(value)}"')
    translator.body.append(f"<{' '.join(parts)}>")


def depart_tag(translator: Any, node: tag) -> None:
    """Close the element, unless it is one that holds nothing."""
    if node["html_name"] != "input":
        translator.body.append(f"</{node['html_name']}>")


class QuizDirective(SphinxDirective):
    """Draw the questions of one page."""

    required_arguments = 1
    has_content = True  # for readers of notebooks, see above
    option_spec: ClassVar[dict[str, Any]] = {}

    def run(self) -> list[nodes.Node]:
        """Return the questions as one element."""
        (page,) = self.arguments
        try:
            items = quiz_items.load_page(page)
        except quiz_items.QuizError as problem:
            raise self.error(str(problem)) from problem
        # Sphinx reads the page again when a question or the reader of questions changes
        for source in (quiz_items.CONCEPTS / f"{page}.yml", Path(quiz_items.__file__)):
            self.env.note_dependency(str(source))
        questions = [self._make_question(number, item) for number, item in enumerate(items, 1)]
        return [tag.make("div", *questions, class_="quiz", data_page=page)]

    def _make_question(self, number: int, item: quiz_items.Item) -> nodes.Node:
        self._name_for_references(item)
        label = LABEL.format(item.id)
        lead, *rest = self._parse(item.question)
        legend = tag.make(
            "legend",
            tag.make("span", nodes.Text(f"Question {number}. "), class_="quiz-number"),
            *lead.children,
        )
        choices = [
            self._make_choice(label, place, choice) for place, choice in enumerate(item.choices)
        ]
        button = tag.make("button", nodes.Text("Check"), type="submit", hidden=True)
        return tag.make(
            "form",
            tag.make("fieldset", legend, *rest, *choices),
            tag.make("p", button, class_="quiz-action"),
            tag.make("div", class_="quiz-feedback", aria_live="polite"),
            self._make_answers(item),
            class_="quiz-item",
            id=label,
            data_quiz=item.id,
            data_right=str(item.right_index),
        )

    def _make_choice(self, label: str, place: int, choice: quiz_items.Choice) -> nodes.Node:
        field = tag.make("input", type="radio", name=label, value=str(place))
        letter = tag.make("span", nodes.Text(f"{LETTERS[place]} "), class_="quiz-letter")
        text = tag.make("span", *self._parse_line(choice.text), class_="quiz-text")
        return tag.make("label", field, letter, text, class_="quiz-choice")

    def _make_answers(self, item: quiz_items.Item) -> nodes.Node:
        """Everything there is to say, folded; quiz.js shows the part that is asked for."""
        said = []
        for place, choice in enumerate(item.choices):
            verdict = f"{LETTERS[place]} is right." if choice.right else f"Not {LETTERS[place]}."
            said.append(
                tag.make(
                    "p",
                    tag.make("strong", nodes.Text(verdict)),
                    nodes.Text(" "),
                    *self._parse_line(choice.feedback),
                    data_choice=str(place),
                )
            )
        again = tag.make(
            "p", nodes.Text("Read again: "), self._make_reference(item.section), class_="quiz-again"
        )
        summary = tag.make("summary", nodes.Text("Answers"))
        return tag.make("details", summary, *said, again, class_="quiz-answers")

    def _make_reference(self, label: str) -> nodes.Node:
        """Link to a section by its label, with its heading as text, as ``{ref}`` does."""
        return addnodes.pending_xref(
            "",
            nodes.inline(label, label, classes=["xref", "std", "std-ref"]),
            refdomain="std",
            reftype="ref",
            reftarget=label,
            refdoc=self.env.docname,
            refexplicit=False,
            refwarn=True,
        )

    def _name_for_references(self, item: quiz_items.Item) -> None:
        """Let pages link here: ``{ref}`quiz-2a``` ."""
        domain = self.env.get_domain("std")
        if not isinstance(domain, StandardDomain):
            raise TypeError(f"the domain std: expected a StandardDomain, got {type(domain)}")
        label = LABEL.format(item.id)
        domain.labels[label] = (self.env.docname, label, f"question {item.id}")
        domain.anonlabels[label] = (self.env.docname, label)

    def _parse(self, text: str) -> list[nodes.Node]:
        """Turn MyST into nodes; the first is a paragraph."""
        holder = nodes.Element()
        self.state.nested_parse(StringList(text.splitlines(), self.get_source_info()[0]), 0, holder)
        if not isinstance(holder.children[0], nodes.paragraph):
            raise self.error(f"a text of the quiz must begin with a sentence: {text!r}")
        return holder.children

    def _parse_line(self, text: str) -> list[nodes.Node]:
        """Turn MyST of one paragraph into the nodes inside it."""
        first, *rest = self._parse(text)
        if rest:
            raise self.error(f"expected one paragraph in the quiz: {text!r}")
        return first.children


def setup(app: Sphinx) -> dict[str, Any]:
    """Name the directive and its element to Sphinx."""
    app.add_node(tag, html=(visit_tag, depart_tag))
    app.add_directive("quiz", QuizDirective)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
