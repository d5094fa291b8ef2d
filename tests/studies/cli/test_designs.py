"""Verbs on a design: prototypes, check and parts."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
import trimesh
from command import Command
from refusals import refused
from small_run import small_design

import geometry
from geometry.design.design_file import prototype_text
from geometry.ground.refusal import Kind


def test_prototypes_are_listed_and_printed(command: Command, tmp_path: Path) -> None:
    told = command("prototypes")
    assert told.code == 0
    for name in geometry.prototype_names():
        design = geometry.prototype(name)
        line = next(line for line in told.out.splitlines() if line.split()[:1] == [name])
        assert line.split()[1:3] == [str(len(design.microphones)), str(design.point_count)]
    assert command("prototypes", "glove").out == prototype_text("glove")
    own = tmp_path / "mine.toml"
    assert command("prototypes", "glove", "--out", own).code == 0
    assert geometry.load_design(own) == geometry.prototype("glove")
    assert "exists" in command("prototypes", "glove", "--out", own).err


@pytest.mark.slow
@pytest.mark.parametrize("name", geometry.prototype_names())
def test_a_prototype_passes_the_check(command: Command, name: str, tmp_path: Path) -> None:
    told = command("check", name, "--full", "--out", tmp_path / "check.json")
    design = geometry.prototype(name)
    found = json.loads((tmp_path / "check.json").read_text(encoding="utf-8"))
    outcome = found["verdict"]["outcome"]
    assert told.code == {"works": 0, "marginal": 3, "does not work": 1}[outcome], told.err
    assert told.out.startswith(f"{name}: {outcome}\n")
    # the table of docs/verdict.md
    assert (outcome == "works") == (name == "array-2x6")
    assert (outcome == "marginal") == (name in ("glove", "line-2"))
    assert found["wiring"]["points"] == design.point_count
    assert found["printing"]["verdict"] in ("ok", "warn")
    assert found["misfits"] == []  # no two placed parts are in each other's way, every tube fits its ports
    assert sum(cell["places"] for cell in found["cells"]) == design.point_count + len(design.microphones)
    levels = [entry["second_microphone_db"] for entry in found["attenuation"]]
    assert 0 > levels[0] > levels[1] > levels[2]
    for words in ("can be built", "distinct cell", "estimated attenuation", "the models assume", "printing,"):
        assert words in told.out
    # What each fidelity costs, and how far off it is.
    out = " ".join(told.out.split())
    assert "lumped milliseconds; differs from navier-stokes by up to 0.3 % and 0.2 degrees on" in out
    assert "1.7 % and 0.6 degrees on line-3" in out
    count = len(found["cells"])
    costs = f"about 3 s of one processor per distinct cell, {3 * count} s for the {count} of this design; later from"
    assert f"navier-stokes, the default {costs}" in out


@pytest.mark.slow
def test_check_writes_the_design_with_the_changes_that_help_and_never_over_another(
    command: Command, tmp_path: Path
) -> None:
    thick = geometry.prototype("array-2x6").with_values({"membrane.thickness": 0.96, "lines.0.points": 4})
    geometry.save_design(thick, tmp_path / "thick.toml")
    fixed = tmp_path / "fixed.toml"
    told = command("check", tmp_path / "thick.toml", "--fix", fixed)
    assert told.code == 0, told.err
    assert geometry.load_design(fixed).membrane.thickness == 1.0
    assert "changed: " in told.out
    before = fixed.read_bytes()
    told = command("check", tmp_path / "thick.toml", "--fix", fixed)
    assert told.code == 1
    assert fixed.read_bytes() == before
    assert command("check", tmp_path / "thick.toml").code == 3


@pytest.mark.slow
def test_the_check_of_a_design_that_cannot_be_printed_names_the_part(command: Command, tmp_path: Path) -> None:
    thin = small_design().with_values({"printing.port_lip": 0.15, "printing.process": "sla-resin"})
    geometry.save_design(thin, tmp_path / "thin.toml")
    told = command("check", tmp_path / "thin.toml")
    assert told.code == 1
    last = told.err.splitlines()[-1]
    assert last.startswith("acoustic-fem: row-3: cannot be printed: shell-straight: thinnest wall 0.15 mm must be at")


def test_the_fields_of_a_design_file_are_listed(command: Command) -> None:
    told = command("check", "--fields")
    assert told.code == 0
    for name in ("resonator.cavity_diameter", "lines.*.points", "air.humidity", "printing.process"):
        assert name in told.out


@pytest.mark.slow
def test_parts_fill_a_folder_with_all_it_takes_to_make_the_array(command: Command, row: Path, tmp_path: Path) -> None:
    told = command("parts", row, "--out", tmp_path / "parts", "--format", "stl", "--process", "dlp-fine")
    assert told.code == 0, told.err
    files = [path for path in (tmp_path / "parts").rglob("*") if path.is_file()]
    written = {path.name: path for path in files}
    made = ["shell-straight", "membrane", "mold-base", "mold-lid", "microphone-housing"]
    for name in made:
        assert trimesh.load_mesh(written[f"{name}.stl"]).is_volume
        assert f"{name}.stl" in told.out
        for doing in ("facets of", "files of", "print rules of"):
            assert f"Parts: {doing} {name}" in told.err
    assert not [name for name in written if name.startswith(".") or name == "membrane.step"]
    report = json.loads(written["print-report.json"].read_text(encoding="utf-8"))
    assert report["process"]["name"] == "dlp-fine"
    assert {file["name"] for file in report["files"]} == {name for name in written if name.endswith(".stl")}
    assert report["acoustic_effects"]
    plate = trimesh.load(written["plate-2.3mf"])
    assert "shell-straight" in plate.geometry
    assert written["assembly.step"].read_text().startswith("ISO-10303-21")
    assert json.loads(written["bill.json"].read_text(encoding="utf-8"))["items"]
    for name in ("array.glb", "array.html", "bill.csv", "bill.txt", "print-report.html", "top-view.png",
                 "exploded-view.png", "mold-section.png"):  # fmt: skip
        assert written[name].stat().st_size > 500
    assert "to microphones of line 1" in told.out
    assert "which tube between: 5-build/assembly.txt" in told.out
    assert "manual.html" in told.out.splitlines()[-1]
    assert "point 3       shell-straight" in written["assembly.txt"].read_text(encoding="utf-8")
    listed = set(written["files.txt"].read_text(encoding="utf-8").split())
    assert listed == {path.relative_to(tmp_path / "parts").as_posix() for path in files}
    assert "resin" in told.out


def test_a_folder_of_parts_never_mixes_two_designs_and_keeps_what_others_put_there(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from studies.output.folders import replaced_files

    folder = tmp_path / "parts"

    def make(*names: str) -> None:
        with replaced_files(folder) as fresh:
            for name in names:
                if not name.startswith("no-such-folder"):
                    (fresh / name).parent.mkdir(exist_ok=True)
                (fresh / name).write_text(f"{name} of {names}")

    def names() -> set[str]:
        return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}

    make("mold-lid.stl", "plate-1.3mf", "plate-2.3mf")
    (folder / "notes.md").write_text("mine")
    make("mold-scraper.stl", "plate-1.3mf")
    assert names() == {"mold-scraper.stl", "plate-1.3mf", "notes.md", "files.txt"}
    assert "scraper" in (folder / "plate-1.3mf").read_text()
    assert (folder / "notes.md").read_text() == "mine"

    # What fails changes nothing; what is stopped while files move leaves none that the next call would not remove.
    with pytest.raises(FileNotFoundError):
        make("mold-lid.stl", "no-such-folder/plate-1.3mf")
    assert names() == {"mold-scraper.stl", "plate-1.3mf", "notes.md", "files.txt"}
    moved = os.replace

    def stopped(source: Path, target: Path) -> None:
        if Path(target).name.startswith("plate"):
            raise KeyboardInterrupt
        moved(source, target)

    monkeypatch.setattr("studies.output.folders.os.replace", stopped)
    with pytest.raises(KeyboardInterrupt):
        make("mold-lid.stl", "plate-1.3mf", "plate-9.3mf")
    monkeypatch.undo()
    make("membrane.stl")
    assert names() == {"membrane.stl", "notes.md", "files.txt"}

    # Folders go with their last file, unless somebody put something into them.
    make("print/lid.stl", "cast/membrane.stl")
    (folder / "cast" / "mine.txt").write_text("mine")
    make("membrane.stl")
    assert names() == {"membrane.stl", "notes.md", "files.txt", "cast/mine.txt"}
    assert not (folder / "print").exists()

    # Nothing is written through a link out of the folder.
    (tmp_path / "elsewhere").mkdir()
    (folder / "print").symlink_to(tmp_path / "elsewhere")
    with refused(kind=Kind.EXISTS):
        make("print/lid.stl")
    assert not list((tmp_path / "elsewhere").iterdir())

    (folder / "files.txt").write_text("membrane.stl\n../precious\n")
    (tmp_path / "precious").write_text("mine")
    told = command("parts", "array-2x6", "--out", folder)
    assert (told.code, "'../precious' must be the name of a file in" in told.err) == (1, True)
    assert (tmp_path / "precious").read_text() == "mine"


def test_parts_for_an_unknown_process_are_refused(command: Command, row: Path, tmp_path: Path) -> None:
    told = command("parts", row, "--out", tmp_path / "parts", "--process", "sls")
    assert (told.code, not (tmp_path / "parts").exists()) == (1, True)
    assert "process = 'sls' must be one of: sla-resin, dlp-fine, fdm, mjf; or a .toml file" in told.err


def test_one_point_is_enough_for_solve_and_parts(command: Command, tmp_path: Path) -> None:
    geometry.save_design(small_design().with_values({"lines.0.points": 1}), tmp_path / "one.toml")
    told = command("solve", tmp_path / "one.toml", "--out", tmp_path / "one.nc", "--fidelity", "lumped")
    assert (told.code, "1 point," in told.out) == (0, True)
    parts = geometry.build_parts(geometry.load_design(tmp_path / "one.toml"))
    assert parts.counts["shell-straight"] == parts.counts["membrane"] == 1


@pytest.mark.slow
def test_a_design_that_no_change_helps_is_not_written_again(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("studies.run.check.is_installed", lambda extra: extra == "train")  # drawing takes seconds
    geometry.save_design(small_design().with_values({"target.budget": 0.01}), tmp_path / "dear.toml")
    before = command("check", tmp_path / "dear.toml")
    monkeypatch.setattr("studies.verdict.verdict.Remedies.best", lambda *_, **__: None)
    told = command("check", tmp_path / "dear.toml", "--fix", tmp_path / "cheap.toml")
    assert (told.code, before.code) == (1, 1)
    assert "no change that was tried helps" in told.out
    assert not (tmp_path / "cheap.toml").exists()


def test_a_fix_that_exists_is_named_as_it_was_given(command: Command, tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text("mine", encoding="utf-8")
    told = command("check", "array-2x6", "--fix", tmp_path / "mine.toml")
    assert told.code == 1
    assert "--fix" in told.refusal()
    assert "--out" not in told.refusal()
