"""The command line: arguments in, tables out, no workflow of its own.

Stands on: bending, comparison, datasets, evaluation, findings, inference, kit, optimization, output, proposals, run,
scatter, studio, study, sweep, test_rig, verdict.
"""
