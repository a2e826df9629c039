"""ASCE/SEI 41-13: slenderness of unreinforced masonry walls out of their plane."""
