"""What the ground demands: design spectra of the codes, and how they change with damping."""
