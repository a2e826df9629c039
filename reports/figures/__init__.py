"""The report's figures, one per file: plain data from the results in, a matplotlib figure out."""
