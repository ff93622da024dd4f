"""Where variant files, their shared parts and their scripts are found, and how they are joined.

One idea: a name is looked for beside the file that says it, then among the shipped files.
Invariant: a name from a file never leads outside these folders.
"""

from __future__ import annotations

import re
from pathlib import Path
from types import MappingProxyType

import engine
from engine.variant.report import nearest
from engine.variant.source import Node, merge, read_source, read_text
from rulelang.diagnostics import Diagnostic, render
from rulelang.frozen import value

PARTS = MappingProxyType({"table": "tables", "balls": "balls", "pins": "pins", "cloth": "cloths"})
"""The parts that several variants may share, and the folder each lives in."""

_STEM = re.compile(r"(?=.{1,60}$)[a-z0-9]+([-_][a-z0-9]+)*")
_LONGEST_CHAIN = 16


class VariantError(Exception):
    """A variant that cannot be loaded; carries every diagnostic."""

    def __init__(self, diagnostics: list[Diagnostic]) -> None:
        super().__init__("\n".join(render(one) for one in diagnostics))
        self.diagnostics = tuple(diagnostics)


def shipped_folder() -> Path:
    """Return the folder of variants that stands beside the package."""
    return Path(engine.__file__).parent.parent / "variants"


def resolve(name_or_path: str | Path) -> Path:
    """Return the file of a variant named by path, or by the stem of a shipped or a near file.

    Raises VariantError, with near names, where there is none.
    """
    written = str(name_or_path)
    path = Path(written)
    named = isinstance(name_or_path, str) and _STEM.fullmatch(written) is not None
    if named:
        path = shipped_folder() / f"{written}.toml"
        path = path if path.is_file() else Path(f"{written}.toml")
    try:
        if path.is_file():
            return path
        there = "it is no plain file" if path.exists() else "there is no such file"
        reason = "it is a folder" if path.is_dir() else there
    except (OSError, ValueError):
        reason = "this is no path of a file"
    near = sorted(Path().glob("*.toml"))
    known = [one.stem for one in (*sorted(shipped_folder().glob("*.toml")), *near)]
    message = f"no variant `{written[:80]}`: {reason}"
    mend = nearest(path.stem[:80], known)
    raise VariantError([Diagnostic("V001", written[:80], 1, 1, message, mend)])


@value
class Opened:
    """A joined tree, if there is one, and what was wrong on the way.

    `broken` names the parts that could not be had, so that nobody asks for what they would hold.
    """

    node: Node | None
    diagnostics: list[Diagnostic]
    broken: frozenset[str]


def open_variant(path: Path) -> Opened:
    """Return the whole tree of a variant, what it extends and its parts put in place."""
    joiner = _Joiner()
    node = joiner.variant(path, ())
    if node is not None:
        node = joiner.with_parts(node)
    return Opened(node, joiner.diagnostics, frozenset(joiner.broken))


def find_script(stem: str, home: Path) -> Path | None:
    """Return the rule script of that stem, in `home` or among the shipped ones."""
    for folder in (home, shipped_folder()):
        path = folder / f"{stem}.rules"
        if path.is_file():
            return path
    return None


def read_library(name: str, home: Path) -> tuple[str, str] | None:
    """Return text and file name of the script that another `uses` by name, or None.

    Shared rules lie in `rules/`; another game's whole script lies beside its variant.
    """
    if not _STEM.fullmatch(name):
        return None
    for folder in (home / "rules", home, shipped_folder() / "rules", shipped_folder()):
        path = folder / f"{name}.rules"
        if path.is_file():
            text = read_text(path)
            return (text, str(path)) if isinstance(text, str) else None
    return None


def script_names(home: Path) -> list[str]:
    """Return the names of all scripts that one in `home` may use."""
    folders = (home / "rules", home, shipped_folder() / "rules", shipped_folder())
    return sorted({path.stem for folder in folders for path in folder.glob("*.rules")})


class _Joiner:
    """Joins files; collects what is wrong on the way."""

    def __init__(self) -> None:
        self.diagnostics: list[Diagnostic] = []
        self.broken: set[str] = set()

    def read(self, path: Path, home: Path) -> Node | None:
        found = read_source(path, home)
        if isinstance(found, Node):
            return found
        self.diagnostics += found
        return None

    def variant(self, path: Path, chain: tuple[Path, ...]) -> Node | None:
        node = self.read(path, path.parent)
        if node is None:
            return None
        base = node.table.get("extends")
        rest = _without(node, "extends")
        if base is None:
            return rest
        place = self.follow(base, "", (*chain, path.resolve()))
        parent = self.variant(place, (*chain, path.resolve())) if place else None
        if place is None or parent is None:
            return None
        joined = _lay_over(parent, rest)
        return joined if "rules" in rest.table else _with_script(joined, path, place)

    def follow(self, said: Node, folder: str, chain: tuple[Path, ...]) -> Path | None:
        """Return the file that `said` names; None, and a mistake, where there is none."""
        what = f"part in {folder}/" if folder else "variant"
        code = "V201" if folder else "V203"
        name = said.value
        if not isinstance(name, str) or not _STEM.fullmatch(name):
            message, mend = f"expected the name of a {what}", "the stem of a file, without folder"
            stem = Path(name).name.removesuffix(".toml") if isinstance(name, str) else ""
            mend = f'write "{stem}"' if _STEM.fullmatch(stem) else mend
            self.diagnostics.append(said.diagnostic("V103", (), message, mend))
            return None
        folders = [said.source.home / folder, shipped_folder() / folder]
        paths = [place / f"{name}.toml" for place in folders]
        paths = [path for path in paths if path.is_file()]
        if paths and chain and paths[0].resolve() == chain[-1]:
            paths = [path for path in paths if path.resolve() != chain[-1]] or paths
        if paths and (paths[0].resolve() in chain or len(chain) > _LONGEST_CHAIN):
            message, mend = f"`{name}` leads back to this file", "break the circle"
            if paths[0].resolve() not in chain:
                message = f"more than {_LONGEST_CHAIN} files extend or use each other"
                mend = "write the differences into fewer files"
            self.diagnostics.append(said.diagnostic("V202", (), message, mend))
            return None
        if paths:
            return paths[0]
        known = sorted({one.stem for place in folders for one in place.glob("*.toml")})
        message = f"there is no {what} called `{name}`"
        self.diagnostics.append(said.diagnostic(code, (), message, nearest(name, known)))
        return None

    def with_parts(self, node: Node) -> Node:
        table = dict(node.table)
        for key, folder in PARTS.items():
            if key in table:
                before = len(self.diagnostics)
                table[key] = self.part(_as_table(table[key]), folder, ())
                if len(self.diagnostics) > before:
                    self.broken.add(key)
        return Node(table, node.source, node.path)

    def part(self, node: Node, folder: str, chain: tuple[Path, ...]) -> Node:
        """Return a part with the file that it uses laid under it."""
        use = node.table.get("use")
        rest = _without(node, "use")
        place = self.follow(use, folder, chain) if use is not None else None
        if use is None or place is None:
            return rest
        below = self.read(place, use.source.home)
        if below is None:
            return rest
        return merge(self.part(below, folder, (*chain, place.resolve())), rest)


def _without(node: Node, key: str) -> Node:
    if key not in node.table:
        return node
    table = {name: child for name, child in node.table.items() if name != key}
    return Node(table, node.source, node.path)


def _with_script(node: Node, path: Path, parent: Path) -> Node:
    """Return a variant with its own script where it has one, else with its parent's."""
    own = _without(node, "rules")
    if path.with_suffix(".rules").is_file():
        return own
    inherited = node.table.get("rules", Node(parent.stem, node.source, ("extends",)))
    return Node({**own.table, "rules": inherited}, node.source, node.path)


def _as_table(node: Node) -> Node:
    """Return `table = "name"` as `table = { use = "name" }`."""
    return Node({"use": node}, node.source, node.path) if isinstance(node.value, str) else node


def _lay_over(base: Node, top: Node) -> Node:
    """Merge as merge does, but a part named by a bare text replaces the other part whole."""
    table = {
        key: _as_table(child) if key in PARTS and key in top.table else child
        for key, child in base.table.items()
    }
    return merge(Node(table, base.source, base.path), top)


__all__ = ["PARTS", "VariantError", "open_variant", "resolve", "shipped_folder"]
