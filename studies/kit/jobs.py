"""Folders of a kit: one per job, whose names sort in the order of work."""

from __future__ import annotations

#: Orders come first, because deliveries take days.
BUY = "1-buy"
#: Plates and single parts for the printer.
PRINT = "2-print"
#: Casting of the membranes.
CAST = "3-cast"
#: Springs and sheaths, with their template.
CUT = "4-cut"
#: Manual, order of assembly, record.
BUILD = "5-build"
#: All folders, in the order of work.
JOBS = (BUY, PRINT, CAST, CUT, BUILD)
