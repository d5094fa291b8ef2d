"""Electronics of a kit: levels at data loggers, wires, and what is said if there is no board."""

from __future__ import annotations

import csv
import math
import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest

import geometry
from acoustic_fem.calibration import read_manifest
from geometry.assembly.bill import bill_of_materials
from geometry.assembly.model import ArrayModel, array_model, assembly_of
from geometry.layout import array_size
from geometry.stock import Logger, StockMicrophone, catalogue
from studies.kit.electronics_files import electronics_of, recorded_options, write_electronics
from studies.kit.expected_signals import microphone_loss
from studies.kit.logger_levels import FIRM_TAP, ExpectedLevels, expected_levels, gentle_touches
from studies.kit.microphone_wiring import coupling_capacitor, head_clashes, wiring_of
from studies.kit.record_sheet import write_record
from studies.verdict.tap_levels import loudest_taps


@pytest.fixture(scope="module")
def model() -> ArrayModel:
    return array_model("array-2x6")


@pytest.fixture(scope="module")
def levels() -> ExpectedLevels:
    return expected_levels(geometry.prototype("array-2x6"))


# -- levels -------------------------------------------------------------------------------------------
def test_levels_are_those_of_check_in_volts_of_the_microphone(levels: ExpectedLevels) -> None:
    design = geometry.prototype("array-2x6")
    taps = loudest_taps([design])[0]
    assert [point.touch for point in levels.points] == pytest.approx(taps.max(axis=1))
    assert [point.firm for point in levels.points] == pytest.approx(taps.max(axis=1) * FIRM_TAP / design.target.force)
    t7 = next(each for each in levels.loggers if each.logger is not None and each.logger.part_number == "T7")
    # -38 dB re 1 V/Pa: 28.3 Pa are 0.356 V, above the range of 0.1 V, so the range is 1 V.
    assert t7.volts == 1.0
    assert t7.full_scale == pytest.approx(1 / 10 ** (-38 / 20))
    assert t7.decibels(28.3) == pytest.approx(20 * math.log10(28.3 * 10 ** (-38 / 20)))
    assert t7.step * 2**15 == pytest.approx(t7.full_scale)
    # 96 dB below a sine of 1 V peak
    assert t7.logger_noise * 10 ** (-38 / 20) == pytest.approx(1 / math.sqrt(2) / 10 ** (96 / 20))


def test_the_range_is_above_the_overload_of_the_microphone(levels: ExpectedLevels) -> None:
    assert levels.sensitivity is not None
    assert len(levels.loggers) == 2
    for each in levels.loggers:
        assert each.volts is not None
        assert each.full_scale >= levels.overload
        assert each.noise_steps > 1 / 3
    assert not levels.loggers[0].problems
    assert "not specified below 20 Hz" in " ".join(levels.loggers[1].problems)


def test_touches_above_the_overload_are_told_with_the_force_that_is_not_clipped(levels: ExpectedLevels) -> None:
    loudest = max(point.touch for point in levels.points)
    assert loudest > levels.overload  # 0.1 N on the prototype
    assert levels.largest_force == pytest.approx(0.1 * levels.overload / loudest)
    assert "clipped from 28.3 Pa" in levels.verdict[0]
    assert f"{levels.largest_force:.2g} N" in levels.verdict[0]
    soft = geometry.prototype("array-2x6").with_values({"target.force": 0.5 * levels.largest_force})
    (line,) = expected_levels(soft).verdict
    assert "stay below" in line


def test_a_digital_microphone_is_its_own_logger() -> None:
    part = catalogue().microphone("ICS-43434")
    assert isinstance(part, StockMicrophone)
    design = geometry.prototype("array-2x6").with_values(dict(part.values))
    (only,) = expected_levels(design).loggers
    assert only.logger is None
    # -26 dB of full scale at 94 dB: 0 dB is a sine of 120 dB, whose peak is 28.2 Pa.
    assert only.full_scale == pytest.approx(math.sqrt(2) * 20e-6 * 10 ** (120 / 20), rel=0.01)


def test_loggers_with_too_few_inputs_are_left_out() -> None:
    names = [f"M{k}" for k in range(9)]
    lines = [{"between": [one, other], "points": 2} for one, other in pairwise(names)]
    nine = geometry.prototype("array-2x6").with_values(
        {"microphones": names, "lines": lines, "layout": {"kind": "ring"}}
    )
    assert [each.logger.part_number for each in expected_levels(nine).loggers if each.logger] == ["T7"]


# -- wires --------------------------------------------------------------------------------------------
def test_every_pin_of_every_microphone_has_a_wire_and_a_terminal() -> None:
    design = geometry.prototype("array-2x6")
    wiring = wiring_of(design)
    loggers = {each.part_number.split()[0]: each for each in catalogue().of(Logger)}
    wires = wiring.wires(design, loggers["T7"])
    assert [(wire.microphone, wire.pin, wire.signal) for wire in wires] == [
        (name, pin, signal) for name in "AB" for pin, signal in enumerate(("VDD", "OUT", "GND"), start=1)
    ]
    out = [wire for wire in wires if wire.signal == "OUT"]
    assert [wire.channel for wire in out] == [1, 2]
    assert [wire.goes_to.split(",")[0] for wire in out] == ["AIN0", "AIN1"]
    assert "100 kOhm" in out[0].goes_to
    first = wiring.wires(design, loggers["Scarlett"])[1]
    assert first.goes_to.startswith("LINE 1 tip, through 10 uF")
    for each in loggers.values():  # 3 Hz passes: the corner is a tenth of it at most
        assert 1 / (2 * math.pi * each.input_resistance * 1e-6 * coupling_capacitor(each)) <= 0.3


def test_two_digital_microphones_share_a_line_and_differ_in_their_select() -> None:
    part = catalogue().microphone("IM69D130V01")
    assert isinstance(part, StockMicrophone)
    design = geometry.prototype("array-2x6").with_values(dict(part.values))
    wires = wiring_of(design).wires(design, None)
    select = [wire.goes_to for wire in wires if wire.signal == "SELECT"]
    data = {wire.goes_to for wire in wires if wire.signal == "DATA"}
    assert select == ["GND", "VDD"]
    assert data == {"data input 1 of the controller"}


# -- files --------------------------------------------------------------------------------------------
def test_the_files_say_where_each_wire_goes_and_each_level(model: ArrayModel, tmp_path: Path) -> None:
    electronics = electronics_of(model)
    write_electronics(electronics, tmp_path)
    board = {path.name for path in (tmp_path / "1-buy" / "electronics").iterdir()}
    assert {"microphone-board.kicad_pcb", "microphone-board-gerber.zip", "order-board.txt", "gerber"} <= board
    order = (tmp_path / "1-buy" / "electronics" / "order-board.txt").read_text(encoding="utf-8")
    assert "0.4 mm thick" in order
    assert "assumed" in order
    rows = list(csv.DictReader((tmp_path / "5-build" / "levels.csv").open(encoding="utf-8")))
    assert len(rows) == 12 * len(electronics.levels.loggers)
    clipped = 28.3 * 12.589
    for row in rows:
        for force in ("0.1 N", "1 N"):
            pressure, volts = float(row[f"{force} (Pa)"]), float(row[f"{force} (mV)"])
            assert volts == pytest.approx(min(pressure * 12.589, clipped), rel=1e-3)
            assert (row[f"{force} clipped"] == "yes") == (pressure > 28.3)
            assert float(row[f"{force} (dBFS)"]) < 0
        assert float(row["largest tap (N)"]) == pytest.approx(0.1 * 28.3 / float(row["0.1 N (Pa)"]), rel=0.05)
    row = rows[0]
    headroom = 20 * math.log10(28.3 / float(row["0.1 N (Pa)"]))
    assert float(row["headroom to overload (dB)"]) == pytest.approx(headroom, abs=0.1)
    wires = list(csv.DictReader((tmp_path / "5-build" / "wiring.csv").open(encoding="utf-8")))
    assert len(wires) == 7
    assert (wires[-1]["microphone"], wires[-1]["channel"], wires[-1]["pin of the board"]) == ("reference", "3", "")
    sheet = (tmp_path / "5-build" / "wiring.txt").read_text(encoding="utf-8")
    assert "AIN0" in sheet
    assert "clipped from 28.3 Pa" in " ".join(sheet.split())
    assert max(map(len, sheet.splitlines())) <= 110


def test_the_manifest_has_the_channels_of_the_wiring_and_the_full_scale_of_the_logger(
    model: ArrayModel, tmp_path: Path
) -> None:
    electronics = electronics_of(model)
    write_electronics(electronics, tmp_path)
    write_record(model.design, bill_of_materials(model.design, model.parts, model.layout), electronics, tmp_path)
    manifest = read_manifest(tmp_path / "calibration.toml")
    wires = csv.DictReader((tmp_path / "5-build" / "wiring.csv").open(encoding="utf-8"))
    assert {wire["microphone"]: int(wire["channel"]) for wire in wires} == dict(manifest.channels)
    assert manifest.output == "voltage"  # nobody equalises what a logger records
    scale = electronics.levels.loggers[0].full_scale
    assert [manifest.pascals[name] for name in "AB"] == pytest.approx([scale, scale], rel=1e-3)
    options = recorded_options(electronics).split()
    assert float(options[options.index("--full-scale") + 1]) == pytest.approx(scale, rel=1e-3)


def test_slow_touches_may_be_harder_before_they_are_clipped(model: ArrayModel) -> None:
    electronics = electronics_of(model)
    forces = [touch.force for touch in electronics.gentle]
    assert forces == sorted(forces)
    assert forces[0] == pytest.approx(electronics.levels.largest_force)
    # A press of half a second is far below the corner of 20 Hz. It is loudest where its force changes fastest, by
    # pi / T, so the microphone gives pi / T / (2 pi 20 Hz) of its pressure.
    tap, press = electronics.gentle[0], electronics.gentle[-1]
    pressure = electronics.levels.overload / press.force * (2 * 20 * press.seconds)
    nominal = electronics.levels.overload / tap.force
    assert pressure == pytest.approx(nominal, rel=0.3)
    assert electronics.levels.survived_force > electronics.first_touch.force


def test_a_touch_that_only_the_logger_clips_is_clipped_too(levels: ExpectedLevels) -> None:
    design = geometry.prototype("array-2x6")
    narrow = replace(levels.loggers[0], full_scale=levels.overload / 2)
    point = levels.points[0]
    assert levels.is_clipped(0.6 * levels.overload, narrow)
    assert not levels.is_clipped(0.6 * levels.overload, levels.loggers[0])
    halved = gentle_touches(design, replace(levels, loggers=(narrow,)))
    for half, whole in zip(halved, gentle_touches(design, levels), strict=True):
        assert half.force == pytest.approx(whole.force / 2)
    assert levels.recorded(point.firm, narrow) == narrow.full_scale


def test_the_output_at_10_hz_has_the_high_pass_of_the_microphone(model: ArrayModel) -> None:
    assert microphone_loss(model.design) == pytest.approx(-10 * math.log10(1 + (20 / 10) ** 2), abs=0.2)


def test_an_unknown_microphone_has_a_wiring_sheet_that_says_why_there_is_no_board(tmp_path: Path) -> None:
    model = array_model(geometry.prototype("line-2").with_values({"lines.0.points": 2, "microphone.model": "my own"}))
    electronics = electronics_of(model)
    assert electronics.wiring.board is None
    write_electronics(electronics, tmp_path)
    assert not (tmp_path / "1-buy").exists()
    sheet = " ".join((tmp_path / "5-build" / "wiring.txt").read_text(encoding="utf-8").split())
    assert "No board is drawn: microphone.model = 'my own' is not in the catalogue" in sheet
    assert "OUT" in sheet


def test_the_size_with_the_heads_of_the_boards_is_that_of_the_drawn_array(model: ArrayModel) -> None:
    electronics = electronics_of(model)
    box = assembly_of(model).toCompound().BoundingBox()
    assert electronics.size == pytest.approx((box.xlen, box.ylen, box.zlen), abs=4e-3)
    board = electronics.wiring.board
    assert board is not None
    assert box.xlen - array_size(model.design)[0] == pytest.approx(7.07, abs=0.01)  # both heads lie on one side
    assert any(f"{box.xlen:.1f} x {box.ylen:.1f}" in note for note in electronics.notes)
    assert f"stays {board.in_chamber:.2f} mm from the wall" in " ".join(electronics.notes)


def test_a_board_whose_sound_hole_is_near_the_wall_names_the_length_it_needs() -> None:
    digital = catalogue().microphone("ICS-43434")
    assert isinstance(digital, StockMicrophone)
    design = geometry.prototype("array-2x6").with_values(dict(digital.values))
    (note,) = [note for note in wiring_of(design).notes if "microphone.board_length =" in note]
    length = re.search(r"board_length = ([\d.]+)", note)
    assert length is not None
    longer = wiring_of(design.with_values({"microphone.board_length": float(length[1])}))
    assert longer.board is not None
    assert longer.board.in_chamber == pytest.approx(0.3, abs=0.01)


def test_a_board_on_a_body_is_ordered_flexible() -> None:
    palm = geometry.load_design(Path(__file__).parents[3] / "docs" / "examples" / "robot" / "palm.toml")
    assert any("flexible board" in note for note in wiring_of(palm).notes)
    assert not any("flexible board" in note for note in wiring_of(geometry.prototype("array-2x6")).notes)


def test_the_head_of_a_board_that_meets_a_neighbour_is_told(model: ArrayModel) -> None:
    board = wiring_of(model.design).board
    assert board is not None
    assert head_clashes(model, board) == ()  # the slots of the prototype point away from the points
    # A housing turned by 180 degrees has its slot, and so the head, towards the first point; a head that is 4 mm longer
    # reaches its shell, which begins 11.45 mm from the axis of the chamber.
    placed = tuple(
        replace(each, rotation=each.rotation + 180) if each.kind == "housing" else each for each in model.placed
    )
    (left, low), corner = board.head
    assert 16.45 - 5 - 4 < -left < 16.45 - 5
    longer = replace(board, head=((left - 4, low), corner))
    assert head_clashes(model, longer) == ()
    turned = replace(model, placed=placed)
    assert head_clashes(turned, board) == ()
    assert [line.partition(",")[0] for line in head_clashes(turned, longer)] == [
        "microphone A: point 1",
        "microphone B: point 12",
    ]
