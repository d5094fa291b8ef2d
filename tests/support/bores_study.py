"""Studies for the tests of sweeps: 40 random bores and lengths of a small array, and 24 designs of 3-D cells."""

import json

METRICS_OF_STUDY = ("distance_smallest", "ipd_mean", "sensitivity_force", "volume")
#: The study file.
TEXT = f"""
name = "bores"
base = "array-2x6"
fidelity = "lumped"
stock = "off"
frequency = "1:100:12"
metrics = {json.dumps(METRICS_OF_STUDY)}
sampling = "random"
cases = 40
keep = "responses"

[vary]
"tube.inner_diameter" = {{from = 0.3, to = 0.8}}
"tube.length" = {{from = 8, to = 30, scale = "log"}}
"lines.0.points" = [6, 12]
"membrane.material" = ["silicone-shore-a-30", "silicone-shore-a-10"]
"""
#: A study file of 24 designs that share their 3-D cells.
CELLS = """
base = "array-2x6"
fidelity = "navier-stokes"
frequency = "1:100:4"
metrics = ["distance_smallest"]
[vary]
"resonator.cavity_height" = [2.5, 3.0]
"tube.length" = [12.5, 14, 15, 16, 18, 20]
"membrane.thickness" = [0.5, 0.6]
"""
