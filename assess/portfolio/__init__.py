"""Many projects at once: what is to be assessed, in which order, and what is known of each."""
