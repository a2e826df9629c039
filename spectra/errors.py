"""The exception of this package."""


class SpectrumError(ValueError):
    """A design spectrum cannot be made from what was given; the text says what, where and the remedy."""
