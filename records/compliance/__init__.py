"""What codes ask of a suite of records beside its target spectrum: one module for each code, one function for each set.

A rocking body has no period T_1: its place is taken by the least and the largest equivalent period of the mechanisms.
None of these clauses was compared with its printed standard; what the modules say of them is from memory.
"""
