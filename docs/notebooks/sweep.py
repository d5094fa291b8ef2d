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
# # A sweep, read with xarray
#
# A study names a base design, the metrics, and the fields that vary. Its results are one labelled dataset.

# %%
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt

import studies

folder = TemporaryDirectory()
study = studies.Study(
    base="array-2x6",
    vary={"tube.inner_diameter": (0.3, 0.6), "resonator.cavity_height": (1.5, 5.0)},
    stock="off",  # any bore, also between the sizes of springs
    sampling="sobol",
    cases=128,
    fidelity="lumped",
    metrics=["distance_smallest", "sensitivity_force", "scatter_detection"],
)
sweep = studies.run_sweep(study, f"{folder.name}/results.zarr", workers=1)
dataset = sweep.to_xarray()
print(len(sweep), "cases;", *sweep.metrics)

# %% [markdown]
# Narrow bores separate the points but attenuate the sound, so a gain in distance costs sensitivity.

# %%
figure, axis = plt.subplots(figsize=(7, 3.8), layout="constrained")
shown = axis.scatter(dataset["distance_smallest"], dataset["sensitivity_force"], c=dataset["tube.inner_diameter"], s=18)
axis.set(xlabel="smallest distance of two points", ylabel="sensitivity (Pa/N)", yscale="log")
figure.colorbar(shown, label="bore (mm)")
plt.show()

# %% [markdown]
# The ranking score of as-built sensors (smaller is better), against the two parameters:

# %%
figure, axis = plt.subplots(figsize=(7, 3.8), layout="constrained")
shown = axis.scatter(
    dataset["tube.inner_diameter"], dataset["resonator.cavity_height"], c=dataset["scatter_detection"], s=30
)
axis.set(xlabel="bore (mm)", ylabel="height of the cavity (mm)")
figure.colorbar(shown, label="ranking score, as built")
plt.show()
table = sweep.to_dataframe()[["tube.inner_diameter", "distance_smallest"]]
assert table.corr().iloc[0, 1] < 0
folder.cleanup()
