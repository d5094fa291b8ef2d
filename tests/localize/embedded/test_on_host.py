"""The exported C, built with every warning an error and all sanitizers on, decides what Python decides."""

import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from embedded_bench import (
    COMPILER,
    LARGEST,
    SANITIZED,
    STRICT,
    UNEVEN,
    assert_agree,
    build,
    decided_in_c,
    needs_compiler,
)
from refusals import refused
from small_run import small_design

import acoustic_fem
import localize
from benchmarks.embedded_touches import LIMIT, STATES, array_of, calibrated, decided_in_python, decided_of, touches
from geometry import Kind
from localize.embedded import embed
from localize.signals.array_response import ArrayResponse, response_of

SOURCES = Path(localize.embedded.__file__).parent / "sources"
EVERY_SOURCE = sorted(path.name for path in SOURCES.glob("touch_*.c*"))


@needs_compiler
def test_a_small_array_is_decoded_as_in_python_whatever_the_chunks(tmp_path: Path) -> None:
    response = calibrated(acoustic_fem.solve(small_design(), np.linspace(1.0, 500.0, 100), "lumped"))
    samples = touches(response, 5, 2)
    expected = decided_in_python(response, samples)
    assert set(expected.state) >= {"no touch", "touch", "unreadable"}
    bench = build(embed(response), tmp_path / "bench")
    found = decided_in_c(bench, samples, response.point_count, 37)
    assert_agree(found, expected, samples, 1e-4, 1e-3)
    for chunk in (1, 16, 4096):
        again = decided_in_c(bench, samples, response.point_count, chunk)
        assert again.state == found.state
        np.testing.assert_array_equal(again.posterior, found.posterior)


@needs_compiler
@pytest.mark.slow
def test_decisions_are_the_same_when_the_count_of_samples_begins_again(tmp_path: Path) -> None:
    """32 bits of it last 49 days; a sample that was clipped before that is not one that is clipped afterwards."""
    response = calibrated(acoustic_fem.solve(small_design(), np.linspace(1.0, 500.0, 100), "lumped"))
    samples = touches(response, 5, 4)
    decoder = embed(response)
    found = decided_in_c(build(decoder, tmp_path / "bench"), samples, response.point_count)
    assert {"touch", "unreadable"} <= set(found.state)
    assert (np.abs(samples[:, : samples.shape[1] // 2]) >= LIMIT).any()
    uneven = build(decoder, tmp_path / "uneven", UNEVEN)
    for before in (0, 2**32 - samples.shape[1] // 2, 2**32 - samples.shape[1] - 1):
        again = decided_in_c(uneven, samples, response.point_count, before)
        assert again.state == found.state
        np.testing.assert_array_equal(again.sample, found.sample)
        np.testing.assert_array_equal(again.posterior, found.posterior)


@needs_compiler
def test_a_library_without_a_design_has_no_test_of_sound(tmp_path: Path) -> None:
    response = replace(
        response_of(acoustic_fem.solve(small_design(), np.linspace(1.0, 500.0, 100), "lumped")), ambient_response=None
    )
    decoder = embed(response, "int16")
    assert "#define TOUCH_SOUND_NUMBERS 0" in decoder.files["touch_tables.h"]
    assert "sound of a room" not in decoder.files["README.md"]
    samples = touches(response, 5, 1)
    assert "touch" in decided_in_c(build(decoder, tmp_path / "bench"), samples, 3).state


def test_what_cannot_be_embedded_is_refused() -> None:
    response = array_of("array-2x6", False)
    with refused(Kind.OUT_OF_RANGE, "precision", "int8"):
        embed(response, "int8")  # type: ignore[arg-type]
    with refused(Kind.MISMATCH, "microphone_noise", "design"):
        embed(replace(response, own_noise=None))


@needs_compiler
@pytest.mark.slow
@pytest.mark.parametrize("is_calibrated", [False, True], ids=["nominal", "calibrated"])
@pytest.mark.parametrize(
    ("name", "takes", "least"), [("array-2x6", 90, 1000), ("line-2", 60, 1000), ("glove", 12, 100)]
)
def test_touches_are_decoded_as_in_python(
    tmp_path: Path, name: str, is_calibrated: bool, takes: int, least: int
) -> None:
    """Taps and sums of sines, loud, quiet and clipped: over 1,000 frames of the arrays of which that is asked name a
    point; samples 37 at a time.
    """
    samples, expected = decided_of(name, is_calibrated, takes)
    assert expected.state.count("touch") > least
    response = array_of(name, is_calibrated)
    for precision, (largest, after_clipping) in LARGEST[name].items():
        bench = build(embed(response, precision), tmp_path / precision)
        found = decided_in_c(bench, samples, response.point_count, 37)
        assert_agree(found, expected, samples, largest, after_clipping)


@needs_compiler
@pytest.mark.slow
def test_a_minute_of_touches_is_decided_as_by_the_stream_in_python(tmp_path: Path) -> None:
    """One after the other without a gap, in chunks of any length: frames that hold two touches are explained by no
    point, and differ by more than others.
    """
    samples, expected = decided_of("array-2x6", True, 30, apart=False)
    assert samples.shape[1] > 60_000
    assert set(expected.state) == set(STATES)
    response = array_of("array-2x6", True)
    found = decided_in_c(build(embed(response), tmp_path / "bench", UNEVEN), samples, response.point_count, 0)
    assert_agree(found, expected, samples, 1e-4, 1e-3)


@needs_compiler
@pytest.mark.parametrize("option", ["-ffast-math", "-Ofast", "-ffinite-math-only"])
@pytest.mark.parametrize("source", EVERY_SOURCE)
def test_options_that_assume_lost_samples_away_are_refused_by_the_compiler(option, source, tmp_path):
    for path in SOURCES.glob("touch_*.[ch]*"):
        (tmp_path / path.name).write_bytes(path.read_bytes())
    for name in ("touch_tables.h", "touch_tracker_options.h", "touch_tracker_tables.h", "touch_decimator_taps.h"):
        (tmp_path / name).touch()  # what they hold does not count: files are preprocessed alone

    def preprocessed(*options):
        command = [str(COMPILER), *options, "-E", source]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)

    assert "-ffast-math" not in preprocessed("-O2").stderr
    refused_by = preprocessed("-O2", option)
    assert refused_by.returncode != 0
    assert "compile without -ffast-math" in refused_by.stderr


@needs_compiler
@pytest.mark.slow
def test_lost_samples_are_found_by_their_bits_where_the_compiler_takes_them_for_none(tmp_path: Path) -> None:
    """With the refusal undone, 50 lost samples still make frames unreadable, and no frame after them is."""
    response = calibrated(acoustic_fem.solve(small_design(), np.linspace(1.0, 500.0, 100), "lumped"))
    samples, decoder = touches(response, 5, 2), embed(response)
    samples[:, 1000:1050] = np.nan
    bench = build(decoder, tmp_path / "bench")
    undone = ("-O2", "-ffinite-math-only", "-U__FINITE_MATH_ONLY__")
    assumed = build(decoder, tmp_path / "assumed", flags=undone)
    found, again = (decided_in_c(each, samples, response.point_count) for each in (bench, assumed))
    assert again.state == found.state
    assert {"touch", "unreadable"} <= set(found.state[found.sample.searchsorted(1050) :])
    np.testing.assert_allclose(again.posterior, found.posterior, atol=1e-5)


TWO = """
#include <stdio.h>
#include "left_decoder.h"
#include "right_decoder.h"

static left_decoder left;
static right_decoder right;

int main(void)
{
    static float sample[LEFT_MICROPHONES + RIGHT_MICROPHONES];
    left_init(&left, 0.0f);
    right_init(&right, 1.0f);
    for (int k = 0; k < 300; k++) {
        (void)left_push(&left, sample, 1);
        (void)right_push(&right, sample, 1);
    }
    printf("%d %d %d %d\\n", LEFT_POINTS, RIGHT_POINTS, (int)left.number, (int)right.decision.state);
    return 0;
}
"""


@needs_compiler
def test_two_arrays_live_in_one_program(tmp_path: Path) -> None:
    wide = np.linspace(1.0, 500.0, 20)
    small = response_of(acoustic_fem.solve(small_design(), wide, "lumped"))
    fewer = ArrayResponse(
        small.transfer_function[:2], small.frequency, small.line[:2], small.place[:2], small.microphones
    )
    sources = []
    for prefix, response in (("left", small), ("right", fewer)):
        files = embed(response, "int16" if prefix == "left" else "float32", 1e-3, prefix=prefix).files
        assert all(name == "README.md" or name.startswith(f"{prefix}_") for name in files)
        for name, text in files.items():
            (tmp_path / name).write_text(text, encoding="utf-8")
        sources += [f"{prefix}_decoder.c", f"{prefix}_tables.c"]
    (tmp_path / "main.c").write_text(TWO, encoding="utf-8")
    command = [str(COMPILER), *STRICT, *SANITIZED, "main.c", *sources, "-lm", "-o", "both"]
    made = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    told = subprocess.run([str(tmp_path / "both")], check=True, capture_output=True, text=True).stdout.split()
    assert told == ["3", "2", "300", "4"]


@pytest.mark.parametrize("prefix", ["", "Left", "2nd", "a-b", "_a", "a" * 32])
def test_a_prefix_that_is_none_in_c_is_refused(prefix: str) -> None:
    with refused(Kind.OUT_OF_RANGE, "prefix", prefix):
        embed(array_of("array-2x6", False), prefix=prefix)
