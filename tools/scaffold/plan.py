"""Files to write together: all of them, or none where one cannot be written."""

from __future__ import annotations

import re
from pathlib import Path

TEMPLATES = Path(__file__).with_name("templates")
SLOT = re.compile(r"<<(\w+)>>")


class ScaffoldError(ValueError):
    """What was asked for cannot be made; the message is one sentence."""


def fill_template(template: str, /, **values: str) -> str:
    """Return a template with its slots filled; every value needs a slot, and every slot a value."""
    text = (TEMPLATES / f"{template}.txt").read_text(encoding="utf-8")
    return SLOT.sub(lambda slot: values[slot[1]], text)


class Plan:
    """Texts by their files, written only when all of them are known."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.texts: dict[Path, str] = {}
        self.old: dict[Path, str] = {}

    def add(self, file: str, text: str) -> None:
        """Plan a new file; one that exists is refused."""
        path = Path(file)
        if (self.root / path).exists():
            raise ScaffoldError(f"{file} exists already; choose another name")
        self.texts[path] = text

    def read(self, file: str) -> str:
        """Return a file as it will be."""
        path = Path(file)
        if path not in self.texts:
            self.texts[path] = self.old[path] = (self.root / path).read_text(encoding="utf-8")
        return self.texts[path]

    def append(self, file: str, text: str) -> None:
        """Plan to add a text at the end of a file."""
        self.texts[Path(file)] = self.read(file).rstrip("\n") + "\n" + text

    def insert(self, file: str, text: str, *, after: str = "", before: str = "") -> None:
        """Plan to add a text after or before a line that is there once."""
        line = f"{after or before}\n"
        old = self.read(file)
        if f"\n{old}".count(f"\n{line}") != 1:
            raise ScaffoldError(f"{file}: expected the line {line.strip()!r} once")
        new = f"{line}{text}" if after else f"{text}{line}"
        self.texts[Path(file)] = f"\n{old}".replace(f"\n{line}", f"\n{new}").removeprefix("\n")

    def write(self) -> list[str]:
        """Write everything and name it; where that fails, leave all files as they were."""
        done: list[Path] = []
        try:
            for path, text in self.texts.items():
                (self.root / path).parent.mkdir(parents=True, exist_ok=True)
                done.append(path)  # from here on it may be there in part
                (self.root / path).write_text(text, encoding="utf-8", newline="\n")
        except OSError as error:
            for path in done:
                if path in self.old:
                    (self.root / path).write_text(self.old[path], encoding="utf-8", newline="\n")
                else:
                    (self.root / path).unlink(missing_ok=True)
            raise ScaffoldError(f"nothing is written: {error}") from error
        return [path.as_posix() for path in self.texts]
