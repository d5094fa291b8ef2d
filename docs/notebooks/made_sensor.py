# ---
# jupyter:
#   jupytext:
#     formats: ipynb,py:percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # An as-built sensor and its calibration
#
# No sensor is exactly as designed, so you calibrate it. Here a virtual rig stands in for your bench. It
# generates a random sensor whose parts deviate from the design, and records three of its points with a calibration
# microphone. From a terminal, use
# `acoustic-fem rig` and `acoustic-fem calibrate`.

# %%
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt
import numpy as np

import acoustic_fem
import geometry
import studies

folder = TemporaryDirectory()
design = geometry.prototype("array-2x6")
rig = studies.Rig(design, seed=11, fidelity="lumped")
manifest = rig.record(Path(folder.name) / "bench", (2, 6, 11), studies.Recorder(seconds=20.0))
found = studies.calibrate_sensor(manifest, f"{folder.name}/made.nc", frequency="1:100:100", fidelity="lumped")

# %% [markdown]
# Point 4 was not measured. Its transfer functions are computed from dimensions of the sensor's parts that
# were fitted to the recordings of the three measured points.

# %%
frequency = np.linspace(1, 100, 100)
nominal = acoustic_fem.solve(design, frequency, fidelity="lumped").transfer_function
true = rig.transfer_function(frequency)
made = found.library.transfer_function


def ild(h):
    """Level of A over B, dB."""
    return 20 * np.log10(abs(h[0] / h[1]))


figure, axis = plt.subplots(figsize=(7, 3.6), layout="constrained")
for label, h, style in (("design", nominal, ":"), ("this sensor", true, "k-"), ("calibrated", made, "--")):
    axis.semilogx(frequency, ild(np.asarray(h)[3]), style, label=label)
axis.set(title="point 4", xlabel="frequency (Hz)", ylabel="level at A over B (dB)")
axis.legend()
plt.show()

# %%
off = {
    name: np.mean([np.abs(ild(np.asarray(h)[k]) - ild(true[k])) for k in range(12)])
    for name, h in (("design", nominal), ("calibrated", made))
}
print({name: f"{value:.2f} dB off" for name, value in off.items()})
assert off["calibrated"] < 0.5 * off["design"]
folder.cleanup()
