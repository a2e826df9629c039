"""Sphinx: how the manual in docs/ becomes build/docs/html (`make docs`). Nothing is read from the network."""

from __future__ import annotations

import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))  # the local extensions, and the program whose reference is made

project = "assess"
author = "The rocking-assess authors"
copyright = author
release = version = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
language = "en"

extensions = ["myst_parser", "docs.ext.mathml", "docs.ext.gallery", "docs.ext.repository_links"]
myst_enable_extensions = ["amsmath", "attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 4
exclude_patterns = ["ext", "notebook"]
nitpicky = True

html_theme = "furo"
html_title = f"assess {release}"
html_static_path = ["static"]
html_css_files = ["manual.css"]
html_math_renderer = "mathml"
html_copy_source = False
html_show_sphinx = False
smartquotes = False  # quotes of a project file are copied as they stand
pygments_style = "friendly"
