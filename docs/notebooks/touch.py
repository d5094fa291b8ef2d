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
# # A touch decoded, step by step
#
# A recording of an as-built (simulated) sensor comes with the checkout: two microphones and twelve touches.

# %%
from importlib.util import find_spec
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import acoustic_fem
import localize
import studies

recordings = Path(find_spec("geometry").origin).parents[1] / "docs" / "examples" / "recordings"
library = acoustic_fem.load(recordings / "library.nc")
decoder = localize.BayesDecoder(library, microphone_noise=1e-3)
signals = localize.read_recording(recordings / "touches.wav", decoder.microphones, 20.0).signals
time = np.arange(signals.shape[1]) / 1000

figure, axis = plt.subplots(figsize=(9, 3), layout="constrained")
for name, signal in zip(decoder.microphones, signals, strict=True):
    axis.plot(time, signal, label=f"microphone {name}", linewidth=0.8)
axis.set(xlabel="time (s)", ylabel="pressure (Pa)")
axis.legend()
plt.show()

# %% [markdown]
# A frame is a quarter of a second. For each point the decoder computes how likely these two signals are if that point
# was touched. It does not know the force of the touch, so the ratio of the microphones decides.

# %%
loudest = int(np.argmax(np.abs(signals).sum(axis=0)[:1500]))
frame = signals[:, loudest - 60 : loudest + 190]
frame = frame - frame.mean(axis=1, keepdims=True)
probability = decoder.locate(frame)
figure, axes = plt.subplots(1, 2, figsize=(9, 3), layout="constrained")
axes[0].plot(np.arange(250), frame.T, label=decoder.microphones)
axes[0].set(title="one frame", xlabel="sample (ms)", ylabel="pressure (Pa)")
axes[0].legend()
axes[1].bar(np.arange(1, 13), probability)
axes[1].set(title="probability", xlabel="point", xticks=range(1, 13))
plt.show()

# %% [markdown]
# In a stream the frames overlap. Quiet frames are skipped, and each touch is reported once.

# %%
found = studies.locate_recording(recordings / "library.nc", recordings / "touches.wav", full_scale=20.0)
truth = np.genfromtxt(recordings / "touches.csv", delimiter=",", names=True)
figure, axis = plt.subplots(figsize=(9, 3), layout="constrained")
axis.plot(
    truth["time_s"], np.where(truth["point"] > 0, truth["point"], np.nan), "k-", linewidth=6, alpha=0.25, label="true"
)
for touch in found.touches:
    axis.plot([touch.start, touch.end], [touch.point, touch.point], "o-", color="#c0392b")
axis.set(xlabel="time (s)", ylabel="point", yticks=range(1, 13))
axis.legend()
plt.show()
pressed = truth["point"][truth["point"] > 0].astype(int)
order = pressed[np.insert(np.diff(pressed) != 0, 0, True)]
assert [touch.point for touch in found.touches] == order.tolist()
