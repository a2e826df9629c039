"""Links to pages at the root of the repository lead to the pages of the manual that include them."""

from __future__ import annotations

import pytest

links = pytest.importorskip("docs.ext.repository_links", reason="`make docs` installs Sphinx", exc_type=ImportError)


def test_a_link_to_the_root_leads_into_the_manual():
    assert links.manual_links("[a](../CHANGELOG.md#numbers)", depth=0) == "[a](changes.md#numbers)"
    assert links.manual_links("[a](../../CONTRIBUTING.md)", depth=1) == "[a](../contributing.md)"


def test_other_links_stay():
    for text in ("[a](../CHANGELOG.md)", "[a](verdict.md)", "[a](../pyproject.toml)"):
        assert links.manual_links(text, depth=1 if "CHANGELOG" in text else 0) == text
