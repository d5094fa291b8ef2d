"""The command line, for which a worker or a scheduler is lost after seconds.

Usage: python impatient_sweep.py WORKER SCHEDULER VERB ..., both in s
"""

from __future__ import annotations

import sys

from studies.cli.app import main
from studies.sweep import cluster

if __name__ == "__main__":
    cluster.SILENCE, cluster.SCHEDULER_SILENCE = float(sys.argv[1]), float(sys.argv[2])
    cluster.PATIENCE, cluster.WATCH = 600.0, 0.2
    sys.argv = ["acoustic-fem", *sys.argv[3:]]
    main()
