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
# # A wristband, from an idea to its parts
#
# You design sixteen points around a wrist, 15 mm apart, with two microphones. `acoustic-fem new wristband --around 188
# --points 16` would find the parts for you. Here you choose them yourself, to see what matters.

# %%
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt

import geometry
from studies.run import design_quality, draw_quality

folder = TemporaryDirectory()
design = geometry.prototype("array-2x6").with_values(
    {
        "name": "wristband",
        "description": "16 points around a wrist, 15 mm apart",
        "lines.0.points": 16,
        "layout": {"kind": "cylinder", "columns": 8, "diameter": 60.0},
        "resonator.cavity_diameter": 4.865,
        "resonator.cavity_height": 2.027,
        "resonator.wall_thickness": 1.622,
        "membrane.thickness": 0.405,
        "membrane.rim_width": 1.216,
        "tube.length": 10.135,
    }
)
print(design.description, "-", design.layout.kind, "of", design.layout.diameter, "mm")

# %% [markdown]
# How good is it? `acoustic-fem check --full` prints these figures too.

# %%
quality = design_quality(design)
for row in quality.lines:
    print(*row, sep=" | ")
picture = plt.imread(draw_quality(design, quality, f"{folder.name}/wristband.png"))
figure, axis = plt.subplots(figsize=(9, 4.4), layout="constrained")
axis.imshow(picture)
axis.set_axis_off()
plt.show()

# %% [markdown]
# The nominal sensor is good, but as-built sensors are worse. Which bore tolerates deviations best? Springs are sold in
# a few sizes, so we try several of them.

# %%
springs = [(0.5, 0.08), (0.6, 0.08), (0.7, 0.08), (0.8, 0.1), (0.9, 0.1)]  # outer diameter, wire, mm
tried = {}
for outer, wire in springs:
    other = design.with_values(
        {
            "tube.inner_diameter": round(outer - 2 * wire, 3),
            "tube.wire_diameter": wire,
            "tube.outer_diameter": round(outer + 0.3, 3),
        }
    )
    tried[outer] = design_quality(other)
figure, axis = plt.subplots(figsize=(6, 3.4), layout="constrained")
axis.plot(list(tried), [100 * found.nominal for found in tried.values()], "o-", label="nominal")
axis.plot(list(tried), [100 * found.as_built for found in tried.values()], "s-", label="as built, mean")
axis.set(xlabel="outer diameter of the spring (mm)", ylabel="top-1 accuracy (%)")
axis.legend()
plt.show()
best = max(tried, key=lambda outer: tried[outer].as_built)
print(f"spring of {best} mm: {100 * tried[best].as_built:.1f} % on as-built sensors")
assert tried[best].as_built > quality.as_built

# %% [markdown]
# Finally, list the parts and their cost. `geometry.export` and `acoustic-fem parts` write the files.

# %%
bill = geometry.bill_of_materials(design)
print(f"about {bill.cost:.2f} {bill.currency} an array, {bill.tube_m:.2f} m of tube")
folder.cleanup()
