"""Mutants of physics and codes, and whether the tests kill them: `make mutate`, docs/robustness.md.

The operators are Cosmic Ray's, with one of ours for text. Its runner is not used: it has one command for all mutants,
where ours are given the tests that reach their line. mutmut 3 was tried on paper and left: it calls its mutants through
trampolines that numba cannot compile, and leaves decorated functions and constants of modules alone.
"""
