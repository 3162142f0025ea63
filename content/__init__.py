"""What the book consists of, as data: concept questions and how long pages take.

Read by the book's hooks, by tools and by tests. Imports nothing of the other rooms.
"""

from pathlib import Path

#: The repository.
ROOT = Path(__file__).resolve().parents[1]
