"""The record of a build: read back, refused where it cannot be meant, and worth more than the tolerances."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.calibration import BuildRecord, UpdatedModel, read_manifest, read_record, update
from acoustic_fem.calibration.build_record import Batch
from acoustic_fem.membrane import design_disc
from acoustic_fem.scatter.tolerances import ScatteredDesign
from acoustic_fem.sound.estimate import TransferEstimate
from geometry.assembly import Bill
from geometry.assembly.model import array_model
from geometry.ground.refusal import Kind
from studies.kit.electronics_files import Electronics, electronics_of
from studies.kit.record_sheet import MANIFEST, RECORD, write_record
from studies.test_rig.priors import fit_priors, known_parts

DESIGN = geometry.prototype("array-2x6")
GRID = np.linspace(1.0, 100.0, 24)
ONE_BATCH = (Batch("1", tuple(range(1, 13))),)


@pytest.fixture(scope="module")
def bill() -> Bill:
    return geometry.assembly.bill_of_materials(DESIGN)


@pytest.fixture(scope="module")
def electronics() -> Electronics:
    return electronics_of(array_model(DESIGN))


def record_of(folder: Path, text: str) -> BuildRecord:
    (folder / RECORD).write_text(f'design = "array-2x6"\n{text}', encoding="utf-8")
    return read_record(folder / RECORD, DESIGN)


def test_the_empty_record_of_a_kit_is_valid_and_says_nothing(
    bill: Bill, electronics: Electronics, tmp_path: Path
) -> None:
    write_record(DESIGN, bill, electronics, tmp_path)
    manifest = read_manifest(tmp_path / MANIFEST)
    assert manifest.design.name == "array-2x6"
    assert sorted(manifest.points) == list(range(1, 13))
    record = manifest.record
    assert record is not None
    assert (record.says_something, record.thickness, record.thickness_error) == (False, {}, 0.01)
    assert [(batch.points, batch.silicone) for batch in record.batches] == [
        (tuple(range(1, 13)), "Smooth-On Mold Star 30")
    ]


def test_a_filled_in_record_is_read(bill: Bill, electronics: Electronics, tmp_path: Path) -> None:
    path = write_record(DESIGN, bill, electronics, tmp_path)
    text = path.read_text(encoding="utf-8").replace("# 3 = 0.5", "3 = 0.47").replace("# modulus = ", "modulus = ")
    path.write_text(text, encoding="utf-8")
    record = read_record(path, DESIGN)
    assert record.says_something
    assert record.thickness == {3: 0.47}
    assert record.batches[0].modulus == pytest.approx(DESIGN.material("silicone-shore-a-30").youngs_modulus, rel=5e-3)


@pytest.mark.parametrize(
    ("text", "field", "kind"),
    [
        ("[thickness]\n13 = 0.5", "thickness.13", Kind.OUT_OF_RANGE),
        ("[thickness]\n1 = 5.0", "thickness.1", Kind.OUT_OF_RANGE),
        ("[batches.1]\npoints = [1, 1]", "batches.1.points.1", Kind.OUT_OF_RANGE),
        ("[batches.1]\npoints = [1]\n[batches.2]\npoints = [1]", "batches.2.points.0", Kind.OUT_OF_RANGE),
        ("[batches.1]\npoints = [1]\nmodulus = 100.0", "batches.1.modulus", Kind.OUT_OF_RANGE),
        ("[measuring]\nthickness_error = 0.0", "measuring.thickness_error", Kind.OUT_OF_RANGE),
        ("colour = 1", "colour", Kind.UNKNOWN),
    ],
)
def test_a_record_that_cannot_be_meant_is_refused(tmp_path: Path, text: str, field: str, kind: Kind) -> None:
    with refused(kind=kind, field=field):
        record_of(tmp_path, text)


def test_a_record_of_another_design_is_refused(tmp_path: Path) -> None:
    (tmp_path / RECORD).write_text('design = "glove"\n', encoding="utf-8")
    with refused(kind=Kind.MISMATCH, field="design"):
        read_record(tmp_path / RECORD, DESIGN)


def test_a_measured_thickness_gives_the_compliance_of_that_membrane() -> None:
    record = BuildRecord("", "", {4: 0.45, 7: 0.56}, 0.01, ONE_BATCH)
    known = known_parts(DESIGN, record)
    for point, thickness in record.thickness.items():
        made = design_disc(DESIGN.with_values({"membrane.thickness": thickness}))
        compliance = [float(np.real(disc.compliance(1.0))) for disc in (made, design_disc(DESIGN))]
        assert known.compliance[point - 1] == pytest.approx(math.log(compliance[0] / compliance[1]), abs=2e-3)
    others = np.delete(np.arange(12), [3, 6])
    assert (known.compliance[others] == 0).all()
    usual = fit_priors(DESIGN).compliance
    assert (known.compliance_deviation[others] == usual).all()
    assert (known.compliance_deviation[[3, 6]] < 0.6 * usual).all()


def test_batches_have_a_modulus_each_and_a_measured_one_is_known() -> None:
    stated = DESIGN.material("silicone-shore-a-30").youngs_modulus
    batches = (Batch("a", (1, 2, 3), 1.2 * stated, 0.04), Batch("b", tuple(range(4, 13))))
    known = known_parts(DESIGN, BuildRecord("", "", {}, 0.01, batches))
    library = acoustic_fem.solve(DESIGN, GRID, "lumped")
    model = UpdatedModel(library, fit_priors(DESIGN), known)
    assert [name for name in model.names if "modulus" in name] == ["modulus of batch a", "modulus of batch b"]
    own = [number for number, group in enumerate(model.groups) if group == "modulus"]
    assert np.exp(model.mean[own]) == pytest.approx([1.2, 1.0])
    assert model.scale[own] == pytest.approx([0.04, 0.15])
    # Softer membranes of a batch are as compliant as thinner ones: the model moves the compliance of its points alone.
    stiff = np.zeros(model.count)
    stiff[own[0]] = 1.0
    expected = np.zeros(model.count)
    compliance = [number for number, group in enumerate(model.groups) if group == "compliance"][:3]
    expected[compliance] = -0.04 / model.scale[compliance]
    low = slice(0, 3)  # well below the modes, which the modulus moves too
    assert model.transfer_function(np.array([stiff, expected]))[0][..., low] == pytest.approx(
        model.transfer_function(np.array([stiff, expected]))[1][..., low], rel=2e-3
    )


@pytest.mark.slow
def test_a_record_sharpens_the_fit_of_points_that_were_not_recorded() -> None:
    """Sensors drawn from the tolerances, two points recorded, thicknesses measured to 0.01 mm."""
    library, scattered, priors = acoustic_fem.solve(DESIGN, GRID, "lumped"), ScatteredDesign(DESIGN), fit_priors(DESIGN)
    errors: dict[bool, list[float]] = {False: [], True: []}
    for seed in range(8):
        draws, random = scattered.draws(seed, 1, 5), np.random.default_rng(seed)
        truth = batch_transfer_function(scattered.parameters(draws), scattered.topology, GRID, library.medium)[0]
        noise = 0.003 * np.abs(truth) + 1e-4
        heard = truth + noise * (random.standard_normal(truth.shape) + 1j * random.standard_normal(truth.shape))
        one = np.ones(truth.shape[1:])
        estimates = {n: TransferEstimate(heard[n - 1], noise[n - 1], one, 60) for n in (2, 11)}
        made = 0.5 + 0.05 * draws["membrane_thickness"][0] + 0.01 * random.standard_normal(12)
        record = BuildRecord("", "", dict(enumerate(made.tolist(), start=1)), 0.01, ONE_BATCH)
        for known in (None, known_parts(DESIGN, record)):
            fit = update(UpdatedModel(library, priors, known), estimates)
            assert fit.objection is None
            ratio = np.abs(fit.transfer_function / truth)
            errors[known is not None].append(float(np.sqrt(np.mean((20 * np.log10(ratio)) ** 2))))
    assert np.mean(errors[True]) < 0.75 * np.mean(errors[False])
