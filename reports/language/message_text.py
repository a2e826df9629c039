"""The sentences of messages, with their numbers at full precision."""

from __future__ import annotations

from assess.messages.message import UNITS, Message, Quantity
from assess.messages.texts import TEXTS
from reports.language.customary import customary
from reports.language.measures import measure


def message_text(message: Message | str) -> str:
    """Return the English sentence of a message with its numbers whole; a text as it is."""
    if isinstance(message, str):
        return message
    template = TEXTS.get(message.key)
    if template is None or template.format(**message.values) != message.text:  # made by another version
        return message.text
    return template.format(
        **{
            name: _quantity_text(value) if isinstance(value, Quantity) else value
            for name, value in message.values.items()
        }
    )


def _quantity_text(quantity: Quantity) -> str:
    unit = UNITS[quantity.dimension]
    return str(quantity) if customary(unit) is None else measure(quantity.value, unit, figures=quantity.figures)
