"""The wording of what decoders, streams and models refuse, in one place."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from rc_line import rc_line
from refusals import check_messages
from shared import solved

import localize
from localize.recordings.channel_choice import chosen_channels


@pytest.mark.slow
def test_the_messages_of_decoders_streams_and_models(tmp_path: Path) -> None:
    array, graph = rc_line(4), tmp_path / "decoder.onnx"
    decoder, library = localize.BayesDecoder(array, 1e-3), solved("array-2x6", np.arange(1.0, 101.0, 3.0))
    test, stream = localize.ResidualTest(array, 1e-3), localize.TouchStream(decoder)
    localize.export_onnx(decoder, graph)
    frames = np.random.default_rng(0).standard_normal((1, 2, 250))
    (tmp_path / "nothing").write_bytes(b"")
    cases = {
        "noise": lambda: localize.BayesDecoder(array, 0.0),
        "sound": lambda: localize.BayesDecoder(library, 1e-3, 200.0),
        "no levels": lambda: localize.BayesDecoder(library, 1e-3, ()),
        "no design": lambda: localize.BayesDecoder(array, 1e-3, 60.0),
        "tolerances": lambda: localize.TolerantDecoder(array),  # type: ignore[arg-type]
        "drift": lambda: localize.DriftDecoder(library),
        "two touches": lambda: localize.TwoTouchDecoder(array, 1e-3),
        "top": lambda: localize.judge(decoder, test, frames, top=9),
        "point": lambda: test.p_value(frames, [0]),
        "too loud": lambda: localize.ResidualTest(array, 1e-9, 1e3),
        "sound test": lambda: localize.SoundTest(library, 1e-9, 140.0),
        "waveform": lambda: localize.Reconstructor(array, 1e-3).waveform(frames, 5),
        "microphones": lambda: decoder.heard_by(("left", "Z")),
        "high-pass": lambda: localize.StreamOptions(high_pass=50.0),
        "rejected fraction": lambda: localize.StreamOptions(rejected_fraction=2.0),
        "chunk": lambda: stream.push(np.zeros((3, 10))),
        "another test": lambda: localize.TouchStream(decoder, sound_test=localize.SoundTest(library, 1e-3)),
        "filter": lambda: localize.TouchFilter([0, 0], [0, 1], stay=0.99, jump=0.02),
        "channels": lambda: chosen_channels(("A", "B"), {"A": 1}, 2, "USB array"),
        "a channel": lambda: chosen_channels(("A", "B"), {"A": 1, "B": 9}, 4, "USB array"),
        "folder": lambda: localize.open_model(tmp_path),
        "nothing": lambda: localize.open_model(tmp_path / "nothing"),
        "nowhere": lambda: localize.open_model(tmp_path / "nowhere"),
        "graph with noise": lambda: localize.open_model(graph, microphone_noise=1e-3),
        "graph with a drift": lambda: localize.open_model(graph, follow_drift=True),
        "graph alone": lambda: localize.open_model(graph, ambient=60.0),
        "computed with a drift": lambda: localize.open_model(library, follow_drift=True),
        "paths of a graph": lambda: localize.open_model(graph).tracker(4.0),
    }
    check_messages(Path(__file__).with_name("messages.txt"), cases, {str(tmp_path): "<folder>"})
