"""How our prose reads: pages, docstrings, help and messages against the limits that we write by.

    python docs/prose.py                  # everything; exit status 1 if anything is past its limit
    python docs/prose.py docs/parts.md    # these pages alone

A row is a page: words a sentence, and for every 100 words of prose its numbers, second person, connectives, semicolons
and colons, commas. Tables, code, equations and headings are left out. Guides (README and the groups Start,
Decide, Applications, Design, Make and Use of the side bar) keep all limits, except pages that a script writes. Other
pages keep the length of their sentences.
Phrases of PRIVATE and sentences that begin with a word of BEGINNINGS are faults wherever they stand.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
PACKAGES = ("geometry", "acoustic_fem", "localize", "studies")
GUIDES = ("Start", "Decide", "Applications", "Design", "Make", "Use")
#: Mark of a page that a script writes, which is a list of figures and keeps the limits of other pages.
WRITTEN = "<!-- made by python "

CONNECTIVES = frozenset(
    re.split(" ", "although because but example however if instance since so then therefore thus when while")
)
SECOND_PERSON = frozenset(["our", "us", "we", "you", "your"])
BEGINNINGS = ("Left out are ", "Left out is ", "Lost are ", "Of ", "That ", "What ", "Which ", "Whether ", "Who ")
PRIVATE = re.compile(
    r"\b(?:named right|names? a point|mis-made|(?<![Tt]here )(?:is|are|has|have) none|(?<![Tt]here )is no "
    r"|told of|(?:is|are|not) told|heard through|read over|which who|the same, |sums of sines|goes up in"
    r"|mend(?:ed|s|ing)?|beside it stands?)\b"
)

#: The smallest and the largest value of each figure on a page of at least SHORT words.
GUIDE_LIMITS = {
    "words a sentence": (0.0, 20.0),
    "numbers": (0.0, 2.5),
    "connectives": (1.0, 100.0),
    "; and :": (0.0, 2.0),
    "commas": (0.0, 5.0),
}
OTHER_LIMITS = {"words a sentence": (0.0, 24.0)}
SHORT = 150


class Fault(NamedTuple):
    """Something that has to be rewritten, and where it stands."""

    place: str
    says: str

    def __str__(self) -> str:
        return f"{self.place}: {self.says}"


# -- a text ------------------------------------------------------------------------------------------------------------


def prose_of(markdown: str) -> str:
    """The text of a page without code, comments, tables, headings, equations and the targets of links."""
    for pattern, replacement in (
        (r"(?s)```.*?```", ""),
        (r"(?s)<!--.*?-->", ""),
        (r"(?m)^\|.*$", ""),
        (r"(?m)^#.*$", ""),
        (r"(?s)\$\$.*?\$\$", "MATH"),
        (r"!?\[([^\]]*)\]\([^)]*\)", r"\1"),
        (r"`+[^`]*`+", "CODE"),
        (r"\$[^$\n]*\$", "MATH"),
    ):
        markdown = re.sub(pattern, replacement, markdown)
    return markdown


def sentences_of(text: str) -> list[str]:
    """Sentences of more than two words."""
    paragraphs = (" ".join(part.split()) for part in re.split(r"\n\s*\n|\n\s*[-*] ", text))
    sentences = (s for part in paragraphs for s in re.split(r"(?<=[.!?:])\s+(?=[A-Z*`(])", part))
    return [s for s in sentences if len(s.split()) > 2]


def figures_of(sentences: Sequence[str]) -> dict[str, float]:
    """Words, words a sentence, and the counts of the module's first paragraph for every 100 words."""
    words = [word for sentence in sentences for word in sentence.split()]
    bare = [word.lower().strip(",.;:()*") for word in words]
    each = 100 / max(len(words), 1)
    return {
        "words": len(words),
        "words a sentence": len(words) / max(len(sentences), 1),
        "numbers": each * sum(any(letter.isdigit() for letter in word) for word in words),
        "you, we": each * sum(word in SECOND_PERSON for word in bare),
        "connectives": each * sum(word in CONNECTIVES for word in bare),
        "; and :": each * sum(word.endswith((";", ":")) for word in words),
        "commas": each * sum(word.endswith(",") for word in words),
    }


def faults_of(text: str) -> Iterator[str]:
    """Private phrases in a text, and sentences of it that begin wrongly."""
    for found in PRIVATE.finditer(text):
        yield f"says {found.group(0).strip()!r}"
    for sentence in sentences_of(text):
        if sentence.startswith(BEGINNINGS):
            yield f"begins {sentence[:60]!r}"


# -- pages -------------------------------------------------------------------------------------------------------------


def groups() -> dict[Path, str]:
    """Pages of the side bar with the group that each stands in, as docs/index.md lists them."""
    found = {ROOT / "README.md": GUIDES[0]}
    index = (ROOT / "docs/index.md").read_text(encoding="utf-8")
    for caption, pages in re.findall(r"(?s)```\{toctree\}\n:caption: (\w+)\n:hidden:\n(.*?)```", index):
        for page in pages.split():
            path = ROOT / "docs" / f"{page.split('<')[-1].rstrip('>')}.md"
            if path.is_file():
                found[path] = caption
    return found


def pages() -> list[Path]:
    """All pages that a hand wrote, README first."""
    made = {"build", "reference", "notebooks"}
    docs = (p for p in sorted((ROOT / "docs").rglob("*.md")) if not made & set(p.relative_to(ROOT / "docs").parts))
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *docs]


def page_faults(page: Path, group: str | None) -> list[Fault]:
    """Limits that a page is past, and the faults of its lines, headings and tables included."""
    text = page.read_text(encoding="utf-8")
    name = page.relative_to(ROOT).as_posix()
    figures = figures_of(sentences_of(prose_of(text)))
    limits = GUIDE_LIMITS if group in GUIDES and WRITTEN not in text else OTHER_LIMITS
    found = [
        Fault(name, f"{figures[figure]:.1f} {figure}, allowed {low:g} to {high:g}")
        for figure, (low, high) in limits.items()
        if figures["words"] >= SHORT and not low <= figures[figure] <= high
    ]
    plain = re.sub(r"(?s)```.*?```", lambda block: "\n" * block.group(0).count("\n"), text)
    for number, line in enumerate(plain.splitlines(), 1):
        found += [Fault(f"{name}:{number}", f"says {hit.group(0).strip()!r}") for hit in PRIVATE.finditer(line)]
        if line.startswith("#") and line.lstrip("# ").startswith(BEGINNINGS):
            found.append(Fault(f"{name}:{number}", f"heading {line!r}"))
    begins = (s for s in sentences_of(prose_of(text)) if s.startswith(BEGINNINGS))
    return found + [Fault(name, f"begins {sentence[:60]!r}") for sentence in begins]


# -- the program -------------------------------------------------------------------------------------------------------


def _texts(node: ast.AST) -> Iterator[tuple[int, str]]:
    """Literal texts under a node, a formatted one whole, with ``X`` where its values go."""
    if isinstance(node, ast.JoinedStr):
        parts = (str(v.value) if isinstance(v, ast.Constant) else "X" for v in node.values)
        yield node.lineno, "".join(parts)
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.lineno, node.value
    else:
        for child in ast.iter_child_nodes(node):
            yield from _texts(child)


def source_faults(path: Path) -> list[Fault]:
    """Faults in the docstrings of a module and in its texts of four words and more: help, messages, reports."""
    name = path.relative_to(ROOT).as_posix()
    texts = (pair for pair in _texts(ast.parse(path.read_text(encoding="utf-8"))) if len(pair[1].split()) > 3)
    return [
        Fault(f"{name}:{line}", says) for line, text in texts for says in faults_of(re.sub(r"`+[^`]*`+", "CODE", text))
    ]


def sources() -> list[Path]:
    """Modules of the product."""
    return [path for package in PACKAGES for path in sorted((ROOT / package).rglob("*.py"))]


def main(arguments: Sequence[str]) -> int:
    """Print a row for each page, then every fault; 1 if there is a fault."""
    group = groups()
    chosen = [Path(argument).resolve() for argument in arguments] or pages()
    faults: list[Fault] = []
    for page in chosen:
        figures = figures_of(sentences_of(prose_of(page.read_text(encoding="utf-8"))))
        row = ", ".join(f"{name} {value:.1f}" for name, value in figures.items() if name != "words")
        print(f"{page.relative_to(ROOT)} ({group.get(page, 'other')}): {figures['words']:g} words, {row}")
        faults += page_faults(page, group.get(page))
    if not arguments:
        faults += [fault for path in sources() for fault in source_faults(path)]
    print(*faults, sep="\n")
    print(f"{len(faults)} faults")
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
