"""Names of ours in running text become links: public Python names and verbs of the command line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from docutils import nodes
from public_names import PACKAGES, entry_of, faces
from reference import VERBS
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

DOTTED = re.compile(rf"(?:{'|'.join(PACKAGES)})(?:\.[A-Za-z_]\w*)+(?=$|\()")
FACES = {face.path for face in faces()}
VERB = re.compile(r"acoustic-fem ([a-z]+)\b")


class Names(SphinxPostTransform):
    """Wrap literals that name something of ours in a link to its entry."""

    default_priority = 900

    def run(self, **_: Any) -> None:
        """Go through the literals of the page."""
        for literal in list(self.document.findall(nodes.literal)):
            if any(isinstance(each, (nodes.reference, nodes.title)) for each in _around(literal)):
                continue
            link = self._link(literal.astext())
            if link is not None:
                link += literal.deepcopy()
                literal.replace_self(link)

    def _link(self, text: str) -> nodes.reference | None:
        page = self.env.current_document.docname
        if text in FACES:
            return self._to(page, f"reference/made/{text}", "")
        if found := DOTTED.match(text):
            entry = entry_of(found[0])
            known = self.env.domains["py"].objects.get(entry) if entry else None
            return None if known is None else self._to(page, known.docname, known.node_id)
        if (found := VERB.match(text)) and found[1] in VERBS:
            return self._to(page, "reference/made/verbs", f"verb-{found[1]}")
        return None

    def _to(self, page: str, target: str, anchor: str) -> nodes.reference:
        uri = self.app.builder.get_relative_uri(page, target)
        return nodes.reference("", "", internal=True, refuri=f"{uri}#{anchor}" if anchor else uri)


def _around(node: nodes.Node) -> Iterator[nodes.Node]:
    """Everything that holds a node, the nearest first."""
    while (node := node.parent) is not None:
        yield node


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the transform."""
    app.add_post_transform(Names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
