"""An author's mistake, told so that it can be mended.

One idea: a mistake is a value with a code, a place, what is wrong and what would be right;
all mistakes of a file come together, never one at a time.
"""

from __future__ import annotations

from rulelang.frozen import value

_WIDEST, _BEFORE = 200, 60
"""Of a longer line only a stretch is shown, from so much before the mistake."""


@value
class Diagnostic:
    """One mistake; `line` and `column` count from 1, `snippet` is the source line.

    `width` is how many columns the caret covers, `key` the key path in a TOML file,
    `severity` "error" or "warning".
    """

    code: str
    file: str
    line: int
    column: int
    message: str
    mend: str = ""
    snippet: str = ""
    width: int = 1
    key: str = ""
    severity: str = "error"


def render(diagnostic: Diagnostic) -> str:
    """Return the diagnostic as lines of text: place, message, source with caret, mend."""
    where = f"{diagnostic.file}:{diagnostic.line}:{diagnostic.column}"
    key = f" ({diagnostic.key})" if diagnostic.key else ""
    lines = [f"{where}: {diagnostic.severity} {diagnostic.code}: {diagnostic.message}{key}"]
    if diagnostic.snippet:
        gutter = f"{diagnostic.line:5d} | "
        start = max(0, diagnostic.column - 1 - _BEFORE) if len(diagnostic.snippet) > _WIDEST else 0
        text = diagnostic.snippet.replace("\t", " ")[start : start + _WIDEST]
        lines.append(gutter + text)
        at = diagnostic.column - 1 - start
        pad = " " * (len(gutter) - 2) + "| " + " " * at
        lines.append(pad + "^" * max(1, min(diagnostic.width, len(text) - at)))
    if diagnostic.mend:
        lines.append(f"        mend: {diagnostic.mend}")
    return "\n".join(lines)


class ScriptError(Exception):
    """A script that cannot be used; carries every diagnostic."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__("\n".join(render(one) for one in diagnostics))
        self.diagnostics = diagnostics
