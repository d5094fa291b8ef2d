"""The one base class of what this project refuses: what a user can mend, or be told in one line."""

from __future__ import annotations


class Refusal(ValueError):
    """Input that cannot be taken, or a result that cannot be had from it; the message is one line for a user.

    Every error that the project raises on purpose derives from it, in all four packages: the command line prints
    such an error as one line and lets everything else through as a mistake of the program, with its traceback.
    """
