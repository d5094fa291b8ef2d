"""The verification page, made by running it: ``python -m benchmarks.verification --help``."""
