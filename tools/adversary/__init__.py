"""A reviewing authority's doubts: no value in a project file buys an outcome in silence (docs/robustness.md)."""
