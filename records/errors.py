"""The exception of this package."""


class RecordError(ValueError):
    """A record cannot be read or made; the text says which file or record, what is wrong and the remedy."""
