"""Locate touches with a decoder in ONNX, as in: python locate.py decoder.onnx touches.csv.

Needs onnxruntime, NumPy and SciPy, and nothing of acoustic-fem. The recording is a CSV file at 1 kHz with a column of
pressure in Pa for each microphone. Prints the time and the point of each decision, from point 1.
"""

import json
import sys

import numpy as np
import onnxruntime
import scipy.signal

if len(sys.argv) != 3:
    sys.exit("usage: python locate.py decoder.onnx touches.csv")
session = onnxruntime.InferenceSession(sys.argv[1], providers=["CPUExecutionProvider"])
described = session.get_modelmeta().custom_metadata_map
if "acoustic-fem" not in described:
    sys.exit(f"{sys.argv[1]}: is not a decoder that acoustic-fem exported")
about = json.loads(described["acoustic-fem"])
stream, frame = about["stream"], about["frame"]
try:
    recording = np.genfromtxt(sys.argv[2], delimiter=",", names=True)
    samples = np.stack([recording[name] for name in about["microphones"]])
except (OSError, ValueError, IndexError, TypeError) as error:
    sys.exit(f"{sys.argv[2]}: must be a CSV file with the columns {', '.join(about['microphones'])}: {error}")
samples = scipy.signal.sosfilt(np.array(stream["high_pass_sections"]), samples)

for end in range(frame, samples.shape[1] + 1, stream["hop"]):
    heard = samples[:, end - frame : end].astype(np.float32)
    if np.sqrt(np.mean(heard**2)) < stream["silence"]:
        continue
    (probability,) = session.run(["probability"], {"frames": heard[None]})
    print(end / about["sample_rate"], probability.argmax() + 1)
