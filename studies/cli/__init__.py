"""The command line: arguments in, tables out, no workflow of its own.

Stands on: bending, findings, judging, listening, made_sensor, optimization, output, run, scatter, studio, study, sweep.
"""
