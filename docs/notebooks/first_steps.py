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
# # First steps
#
# You solve a prototype and see how its points differ. This notebook uses the fidelity `lumped`, which takes
# milliseconds. For a design that you will build, use `navier-stokes`, because it solves each distinct cavity in 3-D.

# %%
import matplotlib.pyplot as plt
import numpy as np

import acoustic_fem
import geometry

design = geometry.prototype("array-2x6")
library = acoustic_fem.solve(design, np.linspace(1, 100, 100), fidelity="lumped")
h = library.transfer_function
print(h.sizes)

# %% [markdown]
# A touch near microphone A is loud at A and faint at B. The line is a low-pass, so a farther point loses more at
# 100 Hz.

# %%
level = 20 * np.log10(abs(h))
figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), sharey=True, layout="constrained")
for axis, microphone in zip(axes, h.microphone.values, strict=True):
    for point in h.point.values:
        axis.semilogx(
            h.frequency, level.sel(point=point, microphone=microphone), color=plt.cm.viridis(point / 13), label=point
        )
    axis.set(title=f"microphone {microphone}", xlabel="frequency (Hz)")
axes[0].set_ylabel("level (dB)")
axes[1].legend(title="point", fontsize=7, ncols=2)
plt.show()

# %% [markdown]
# Nobody knows how hard a finger taps, so only the ratio of the two microphone signals says where it tapped. The level
# difference between the microphones falls from one end of the line to the other. The higher the frequency is, the
# more it falls, because the tubes attenuate more.

# %%
ild = 20 * np.log10(abs(h.sel(microphone="A") / h.sel(microphone="B")))
figure, axis = plt.subplots(figsize=(7, 3.4), layout="constrained")
for frequency in (5, 20, 50, 100):
    axis.plot(h.point, ild.sel(frequency=frequency, method="nearest"), "o-", label=f"{frequency} Hz")
axis.set(xlabel="point", ylabel="level at A over B (dB)", xticks=h.point)
axis.legend()
plt.show()
assert (ild.sel(frequency=50, method="nearest").diff("point") < 0).all()
