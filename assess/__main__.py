"""`python -m assess`: the same as the command `assess`."""

from assess.cli import main

main()
