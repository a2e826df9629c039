"""What the ground did: accelerograms, read, scaled and synthesised, and their response spectra."""
