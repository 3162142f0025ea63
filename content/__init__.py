"""What the book consists of, as data: chapters, contents, labels, questions, objectives, minutes.

Read by the book's hooks, by the cards, by tools and by tests. Imports nothing of the other rooms.
"""

from pathlib import Path

#: The repository.
ROOT = Path(__file__).resolve().parents[1]
