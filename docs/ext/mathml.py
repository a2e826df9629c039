"""Equations as MathML, which browsers draw themselves: no network, no script, no LaTeX.

The converter is that of docutils; TeX that it does not know is a warning, hence an error of `make docs`.
"""

from __future__ import annotations

from html import escape
from typing import Any

from docutils import nodes
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.util import logging

LOG = logging.getLogger(__name__)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the renderer, named "mathml" in `html_math_renderer`."""
    app.add_html_math_renderer("mathml", (visit_inline, depart), (visit_block, depart))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def visit_inline(translator: Any, node: nodes.math) -> None:
    """Write an equation within a line."""
    translator.body.append(f'<span class="math">{mathml(node.astext(), node, block=False)}</span>')
    raise nodes.SkipNode


def visit_block(translator: Any, node: nodes.math_block) -> None:
    """Write an equation on its own, with its number if it has a label."""
    translator.body.append(f'<div class="math"{anchor(node)}>{mathml(node.astext(), node, block=True)}')
    if node.get("number"):
        translator.body.append(f'<span class="eqno">({node["number"]})</span>')
    translator.body.append("</div>\n")
    raise nodes.SkipNode


def depart(translator: Any, node: nodes.Node) -> None:
    """Do nothing: the visitors skip this."""


def anchor(node: nodes.Element) -> str:
    """Return the attribute by which links find a labelled equation."""
    names = node.get("ids") or ([f"equation-{nodes.make_id(node['label'])}"] if node.get("label") else [])
    return f' id="{escape(names[0])}"' if names else ""


def mathml(tex: str, node: nodes.Node | None = None, *, block: bool) -> str:
    """Return the MathML of an equation written in TeX; what cannot be converted is shown as written, with a warning."""
    try:
        return str(tex2mathml(tex, as_block=block))
    except (MathError, SyntaxError) as error:
        LOG.warning("equation %r: %s", tex, error, location=node)
        return f"<code>{escape(tex)}</code>"
