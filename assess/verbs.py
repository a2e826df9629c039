"""What one can do with a project: load it, run it, and write its report."""
