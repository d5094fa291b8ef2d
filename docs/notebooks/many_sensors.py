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
# # A localizer trained on many sensors
#
# No two sensors are alike. A network that has seen one sensor knows its quirks, and one that has seen hundreds knows
# what they have in common. This notebook trains the same small network both ways and tests it on sensors that neither
# has seen.

# %%
import matplotlib.pyplot as plt
import torch
from torch import nn
from torch.utils.data import DataLoader

import localize
import studies

torch.manual_seed(0)
torch.set_num_threads(1)
GRID = "1:500:500"
many = studies.as_built("array-2x6", 300, seed=1, frequency=GRID)
print(many)

# %% [markdown]
# `TouchDataset` makes touches while the network trains. Splits are by sensor, so the test sensors stay unseen.

# %%
common = {"mix": {"taps": 0.3, "slides": 0.3, "multi-sines": 0.4}, "batch_size": 128, "seed": 3}
train = localize.TouchDataset(many, touches=192, split="train", **common)
one = localize.TouchDataset(many.nominal, touches=192 * len(train.cases), split="train", **common)
test = localize.TouchDataset(many, touches=96, split="test", **common)
print(f"{len(train.cases)} sensors to train on, {len(test.cases)} to test on")


# %% [markdown]
# The network compares the two microphones at 4 to 100 Hz. Neighbouring points may differ by less than a decibel, so
# the network also gets level and phase as points on a circle, where 10 dB or a quarter turn is one full turn. This
# resolves small differences.


# %%
def maps(signals: torch.Tensor) -> torch.Tensor:
    pieces = signals.unfold(-1, 250, 50) * torch.hann_window(250)
    spectrum = torch.fft.rfft(pieces)[..., 1:26]
    power = spectrum.abs().square().mean(2) + 1e-8  # a floor near the noise of the microphones
    shared = (spectrum[:, 0] * spectrum[:, 1].conj()).mean(1)
    coherence = shared / (power[:, 0] * power[:, 1]).sqrt()
    level = 10 * torch.log10(power[:, 0] / power[:, 1])
    circle, fine = torch.polar(torch.ones_like(level), 0.2 * torch.pi * level), coherence**4
    loudness = torch.log10(power.sum(1) / 1e-8)
    parts = [level / 20, circle.real, circle.imag, coherence.real, coherence.imag, fine.real, fine.imag, loudness / 4]
    return torch.stack(parts, 1).flatten(1)


class Locator(nn.Module):
    def __init__(self) -> None:
        super().__init__()
        self.layers = nn.Sequential(
            *(nn.Linear(200, 256), nn.GELU(), nn.BatchNorm1d(256)),
            *(nn.Linear(256, 256), nn.GELU(), nn.BatchNorm1d(256)),
            nn.Linear(256, 12),
        )

    def forward(self, signals: torch.Tensor) -> torch.Tensor:
        return self.layers(maps(signals))


def trained(data: localize.TouchDataset, epochs: int) -> Locator:
    network = Locator()
    optimizer = torch.optim.AdamW(network.parameters())
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, 5e-3, epochs=epochs, steps_per_epoch=len(data))
    for epoch in range(epochs):
        data.set_epoch(epoch)
        for batch in DataLoader(data, batch_size=None):
            loss = nn.functional.cross_entropy(network(batch["signals"]), batch["point"] - 1)
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
            schedule.step()
    return network.eval()


networks = {"one sensor": trained(one, epochs=2), "many sensors": trained(train, epochs=2)}

# %% [markdown]
# Now each network locates touches on the test sensors, one sensor at a time.


# %%
@torch.no_grad()
def accuracies(network: Locator) -> torch.Tensor:
    right, case = [], []
    for batch in test:
        right.append(network(batch["signals"]).argmax(1) == batch["point"] - 1)
        case.append(batch["case"])
    right, case = torch.cat(right).double(), torch.cat(case)
    return torch.stack([right[case == number].mean() for number in test.cases.tolist()])


found = {name: accuracies(network) for name, network in networks.items()}
for name, values in found.items():
    print(f"trained on {name}: mean {100 * values.mean():.1f} %, worst sensor {100 * values.min():.1f} %")

# %%
figure, axis = plt.subplots(figsize=(7, 3.4), layout="constrained")
for name, values in found.items():
    axis.step(torch.linspace(0, 100, len(values)), 100 * values.sort().values, where="mid", label=f"trained on {name}")
axis.set(xlabel="test sensors, from the worst to the best (%)", ylabel="touches located correctly (%)")
axis.legend()
plt.show()
assert found["many sensors"].mean() > found["one sensor"].mean() + 0.02

# %% [markdown]
# All touches here are simulated, and the sensors differ as parts from a careful workshop do. See
# [libraries for training](../training-libraries.md) for data sets from sweeps and as files.
