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
# # Why two microphones see 36 points
#
# Here 36 points lie on one line between two microphones. Every point divides the line into two different lengths, and
# each length filters the touch on its path to a microphone.

# %%
import matplotlib.pyplot as plt
import numpy as np

import acoustic_fem
import geometry
import studies
from studies.metrics import separability

design = geometry.prototype("line-2")
library = acoustic_fem.solve(design, np.linspace(1, 100, 100), fidelity="lumped")
ratio = library.transfer_function.sel(microphone="A") / library.transfer_function.sel(microphone="B")

# %% [markdown]
# Each row shows level and phase of the ratio of the two microphones for one point. No two rows are alike, so the ratio
# identifies the point.

# %%
figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), sharey=True, layout="constrained")
phase = np.degrees(np.unwrap(np.angle(ratio), axis=-1))
for axis, values, title in zip(axes, (20 * np.log10(abs(ratio)), phase), ("level (dB)", "phase (°)"), strict=True):
    shown = axis.pcolormesh(ratio.frequency, ratio.point, values, cmap="RdBu_r")
    axis.set(title=title, xlabel="frequency (Hz)")
    figure.colorbar(shown, ax=axis)
axes[0].set_ylabel("point")
plt.show()

# %% [markdown]
# The distance of two points is the rms of these differences over the band, in nepers and radians. Neighbours are
# nearest, and neighbours at the ends of the line are the hardest to tell apart.

# %%
apart = separability(library.transfer_function)
figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
shown = axes[0].imshow(apart.combined, origin="lower", extent=(0.5, 36.5, 0.5, 36.5))
figure.colorbar(shown, ax=axes[0])
axes[0].set(title="distance", xlabel="point", ylabel="point")
axes[1].plot(range(1, 36), [apart.between(k, k + 1)[2] for k in range(1, 36)], "o-")
axes[1].set(title="distance of neighbours", xlabel="point and the next", ylim=(0, None))
plt.show()
print("hardest:", apart.equally_hard)
assert all(second - first == 1 for first, second in apart.equally_hard)

# %% [markdown]
# More microphones join more lines. M microphones join up to M (M - 1) / 2 lines, so the number of points grows as fast.

# %%
most = [studies.wiring_table(count, 36)[-1] for count in range(2, 9)]
figure, axis = plt.subplots(figsize=(6, 3.2), layout="constrained")
axis.plot([each.microphones for each in most], [each.points for each in most], "o-")
axis.set(xlabel="microphones", ylabel="points, 36 on every line", ylim=(0, None))
plt.show()
assert most[2].points == 216
