"""Solved cases that a user runs again: their files in `cases`, what solves them in `solvers`.

A case is data. Its file says what is solved, from which input, which values a source gives for it, and how far ours may
be from them, with the reason.
"""
