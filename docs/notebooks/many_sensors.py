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
torch.set_num_threads(2)
GRID = "1:500:500"
many = studies.as_built("array-2x6", 400, seed=1, frequency=GRID)
print(many)

# %% [markdown]
# `TouchDataset` makes touches while the network trains. Splits are by sensor, so the test sensors stay unseen. The
# network reads maps of level and phase instead of signals.

# %%
mix = {"taps": 0.4, "slides": 0.3, "multi-sines": 0.3}
common = {"mix": mix, "batch_size": 128, "features": "phasors", "seed": 3}
one = localize.TouchDataset(many.nominal, touches=16_384, split="train", **common)
train = localize.TouchDataset(many, touches=48, split="train", **common)
test = localize.TouchDataset(many, touches=96, split="test", **common)
print(f"{len(train.cases)} sensors to train on, {len(test.cases)} to test on")


# %% [markdown]
# The network is a few convolutions and one linear layer.


# %%
class Locator(nn.Module):
    def __init__(self, maps: int, points: int) -> None:
        super().__init__()
        self.layers = nn.Sequential(
            nn.BatchNorm2d(maps),
            nn.Conv2d(maps, 48, (4, 8), stride=(4, 8)),
            nn.GELU(),
            nn.Conv2d(48, 96, 2, stride=2),
            nn.GELU(),
            nn.Flatten(),
            nn.Linear(96 * 8 * 2, points),
        )

    def forward(self, maps: torch.Tensor) -> torch.Tensor:
        return self.layers(maps)


def trained(data: localize.TouchDataset, epochs: int) -> Locator:
    network = Locator(maps=4, points=12)
    steps = epochs * len(data)
    optimizer = torch.optim.AdamW(network.parameters(), lr=3e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, 3e-3, total_steps=steps)
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
assert found["many sensors"].mean() > found["one sensor"].mean()

# %% [markdown]
# All touches here are simulated, and the sensors differ as parts from a careful workshop do. See
# [libraries for training](../training-libraries.md) for data sets from sweeps and as files.
