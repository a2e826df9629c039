"""For developers: the sentences of reports that a language has no entry for, one a line.

Give the language and results: python tests/languages/list_untranslated.py it RESULTS.json …
"""

from __future__ import annotations

import sys
from pathlib import Path

from reports.missing_translations import missing_sentences

from assess.results.files import read


def main(language: str, *paths: str) -> None:
    """Print what is missing for the results at `paths`."""
    missing = dict.fromkeys(text for path in paths for text in missing_sentences(read(Path(path)), language=language))
    sys.stdout.writelines(f"{text!r}\n" for text in missing)


if __name__ == "__main__":
    main(*sys.argv[1:])
