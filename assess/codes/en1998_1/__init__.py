"""EN 1998-1:2004: non-structural elements, 4.3.5."""
