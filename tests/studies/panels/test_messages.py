"""The wording of what the panels and the studio do not accept: the one place where it is pinned."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np
from refusals import check_messages

from geometry import prototype
from studies.panels.curves import curves_of, quick_library
from studies.panels.dragging import dragged, resized
from studies.panels.exploring import study_file
from studies.panels.export_files import make_export
from studies.panels.recognizing import store_recognizer
from studies.panels.touching import simulate_slide, simulate_touch
from studies.studio.exploration import file_of
from studies.studio.messages import place_of, read_message, text_of
from studies.studio.serving import serve_studio

ARRAY = prototype("array-2x6")


def test_messages_of_panels_and_studio() -> None:
    metrics, ranges = ["volume"], {"tube.length": [9.0, 10.0]}
    check_messages(
        Path(__file__).with_name("messages.txt"),
        {
            "quantity": lambda: curves_of(quick_library(ARRAY)[0].transfer_function, "loudness"),
            "export": partial(make_export, ARRAY, "a.exe", "folder", "lumped"),
            "metrics": partial(study_file, ARRAY, ranges, []),
            "designs": partial(study_file, ARRAY, ranges, metrics, designs=0),
            "range": partial(study_file, ARRAY, {"tube.length": [9.0]}, metrics),
            "ranges": partial(file_of, ARRAY, {}),
            "recognizer": partial(store_recognizer, b"[]", "folder"),
            "recognizer file": partial(store_recognizer, b'{"a.exe": ""}', "folder"),
            "point": partial(simulate_touch, ARRAY, 0, "tap", 1),
            "kind of touch": partial(simulate_touch, ARRAY, 1, "hit", 1),
            "slide": partial(simulate_slide, ARRAY, [0.0, 0.0], [0.0, 0.0], 1),
            "part": partial(dragged, ARRAY, "shell 1", np.zeros(3), np.zeros(3)),
            "part of another design": partial(dragged, ARRAY, "point 99", np.zeros(3), np.zeros(3)),
            "size": partial(resized, ARRAY, "depth", 1.0),
            "place": partial(place_of, {}, "start"),
            "text": partial(text_of, {}, "name"),
            "not JSON": partial(read_message, "{"),
            "no table": partial(read_message, "[]"),
            "host": partial(serve_studio, ARRAY, host="here"),
            "host of another machine": partial(serve_studio, ARRAY, host="192.0.2.1"),
            "all hosts": partial(serve_studio, ARRAY, host="0.0.0.0"),
            "port": partial(serve_studio, ARRAY, port=70000),
        },
    )
