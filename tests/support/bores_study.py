"""A study of 40 random bores and lengths of a small array, for the tests of sweeps."""

import json

METRICS_OF_STUDY = ("distance_smallest", "ipd_mean", "sensitivity_force", "volume")
#: The study file.
TEXT = f"""
name = "bores"
base = "array-2x6"
fidelity = "lumped"
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
