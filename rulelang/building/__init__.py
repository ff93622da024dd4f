"""From the parser's tree to the tree of `rulelang.syntax`.

One idea: words, expressions, statements and declarations are built by a module each, and each
knows only those before it. Invariant: building never fails on a tree that the grammar accepts.
"""

from rulelang.building.declarations import script

__all__ = ["script"]
