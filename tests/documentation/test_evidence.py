"""The page on what each key rests on is that of the keys as they are declared."""

from docs.ext.evidence_page import PAGE, text


def test_the_page_of_evidence_is_up_to_date() -> None:
    assert PAGE.read_text(encoding="utf-8") == text(), f"{PAGE} is out of date; run `make pages` and commit it"
