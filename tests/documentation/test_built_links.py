"""Links of a built manual: broken ones are found, those outside are listed."""

from __future__ import annotations

from docs.ext.built_links import broken_links, external_links, main, read_pages


def test_broken_files_and_anchors_are_found(tmp_path, capsys):
    (tmp_path / "b.html").write_text('<h1 id="top">B</h1>', encoding="utf-8")
    links = ["b.html#top", "b.html#gone", "gone.html", "#here", "https://example.org/x", "b%2ehtml"]
    body = "".join(f'<a href="{each}"></a>' for each in links)
    (tmp_path / "a.html").write_text(f'<p id="here">{body}<img src="no.svg"></p>', encoding="utf-8")
    pages = read_pages(tmp_path)
    assert broken_links(pages) == ["a.html: b.html#gone", "a.html: gone.html", "a.html: no.svg"]
    assert external_links(pages) == {"https://example.org/x": ["a"]}
    assert main(tmp_path) == 1
    assert "outside: https://example.org/x" in capsys.readouterr().out
