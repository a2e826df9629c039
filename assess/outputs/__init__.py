"""Files that the program writes: whole or not at all, and never over files of others (docs/outputs.md)."""
