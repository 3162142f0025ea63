"""Which check keeps which sentence of an exercise: the rows that a card holds of it.

A statement is a contract. So every sentence that a learner reads has a row: it is *asked* and
checked, or *given* and true of every case, or *told* and asks for nothing. `tools.derive.contract`
finds the sentences, and the rows and checks that miss each other.
"""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Duty", "asked", "given", "told"]


@dataclass(frozen=True)
class Duty:
    """One sentence of an exercise, and what keeps it.

    Parameters
    ----------
    id : str
        Its name in the exercise. It stays when the sentence is written anew.
    words : str
        Words that stand in this sentence and in no other of the exercise.
    kind : str
        "asked", "given" or "told".
    kept_by : tuple of str
        The checks: "mistake NAME" for a listed mistake, which is known to fail; "case LABEL" for a
        visible case, by the beginning of its label; "every case"; or a gate, such as "value", and
        of one part only: "value of K".
    """

    id: str
    words: str
    kind: str
    kept_by: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not self.id or self.id != self.id.lower() or " " in self.id:
            raise ValueError(f"contract: expected a name-like-this, got {self.id!r}")
        if not self.words.strip():
            raise ValueError(f"contract {self.id}: expected words of a sentence, got none")
        if (self.kind == "asked") != bool(self.kept_by):
            raise ValueError(f"contract {self.id}: expected checks where something is asked")


def asked(name: str, words: str, *kept_by: str) -> Duty:
    """Return the row of a sentence that asks for something, and the checks that keep it."""
    return Duty(name, words, "asked", kept_by)


def given(name: str, words: str) -> Duty:
    """Return the row of a sentence that says what comes in: true of every case."""
    return Duty(name, words, "given")


def told(name: str, words: str) -> Duty:
    """Return the row of a sentence that explains, and asks for nothing."""
    return Duty(name, words, "told")
