"""NZSEE/MBIE Guidelines of July 2017, section C8: face-loaded walls of unreinforced masonry."""
