"""What the engineer signs: a document as data, and the renderers that turn it into files."""
