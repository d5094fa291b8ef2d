"""``python -m studies.cli``: the command line without its installed name."""

from studies.cli.app import main

main()
