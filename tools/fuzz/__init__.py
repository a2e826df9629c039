"""Mutated inputs through the real entry point, each compared with what the unmutated one gives: docs/robustness.md."""
