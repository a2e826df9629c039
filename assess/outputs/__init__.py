"""What the program writes into folders: whole or not at all, and nothing of others is lost (docs/outputs.md)."""
