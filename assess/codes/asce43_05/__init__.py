"""ASCE/SEI 43-05: rocking of unanchored bodies, by spectrum and by response history."""
