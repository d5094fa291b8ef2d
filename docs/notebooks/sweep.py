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
# A study file states a base design, metrics and parameters. Its results are one labelled dataset.

# %%
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt

import studies

folder = TemporaryDirectory()
study = Path(folder.name) / "study.toml"
study.write_text("""
base = "array-2x6"
fidelity = "lumped"
sampling = "sobol"
cases = 128
metrics = ["distance_smallest", "sensitivity_force", "scatter_detection"]
[vary]
"tube.inner_diameter" = {from = 0.3, to = 0.6}
"resonator.cavity_height" = {from = 1.5, to = 5}
""")
summary = studies.run_sweep(studies.load_study(study), f"{folder.name}/results.zarr", workers=1).summary
dataset = studies.open_sweep(f"{folder.name}/results.zarr").to_xarray()
print(summary.cases, "cases;", *dataset.data_vars)

# %% [markdown]
# Narrow bores separate the points but attenuate the sound, so a gain in distance costs sensitivity.

# %%
figure, axis = plt.subplots(figsize=(7, 3.8), layout="constrained")
shown = axis.scatter(dataset["distance_smallest"], dataset["sensitivity_force"], c=dataset["tube.inner_diameter"], s=18)
axis.set(xlabel="smallest distance of two points", ylabel="sensitivity (Pa/N)", yscale="log")
figure.colorbar(shown, label="bore (mm)")
plt.show()

# %% [markdown]
# The predicted error of as-built sensors, against the two parameters:

# %%
figure, axis = plt.subplots(figsize=(7, 3.8), layout="constrained")
shown = axis.scatter(
    dataset["tube.inner_diameter"], dataset["resonator.cavity_height"], c=dataset["scatter_detection"], s=30
)
axis.set(xlabel="bore (mm)", ylabel="height of the cavity (mm)")
figure.colorbar(shown, label="predicted error, as built")
plt.show()
table = dataset[["tube.inner_diameter", "distance_smallest"]].to_dataframe()
assert table.corr().iloc[0, 1] < 0
folder.cleanup()
