"""Draw the pictures of the tutorial from the run that it ends with: the house, a mechanism, page 1 of the report.

Usage: python docs/images/tutorial.py    (pdftoppm, of Debian's poppler-utils, draws the page)
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
FIGURES = {"key-plan.svg": "house-plan.svg", "01-front-sketch.svg": "house-front.svg"}


def main() -> None:
    """Follow the tutorial and take its pictures."""
    from docs.tutorial.follow import follow

    images = ROOT / "docs" / "images"
    with TemporaryDirectory() as folder:
        for output in follow(ROOT / "docs" / "tutorial" / "from_ifc.md", Path(folder)):
            print("$", output.given)
        results = Path(folder) / "house" / "tied-results"
        for figure, name in FIGURES.items():
            shutil.copyfile(results / "figures" / figure, images / name)
        page = ["pdftoppm", "-r", "80", "-png", "-f", "1", "-l", "1", "-singlefile", results / "report.pdf"]
        subprocess.run([*page, images / "house-report"], check=True)


if __name__ == "__main__":
    main()
