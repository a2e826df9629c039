"""The report's figures, one subject a file: plain data from the results in, a matplotlib figure out."""
