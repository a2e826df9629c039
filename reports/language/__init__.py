"""The words, numerals and units of the report, in English and in other languages."""
