"""Collecting an author's mistakes and telling each at its place, with a mend.

One idea: every check adds to one Report and goes on; nothing stops at the first mistake.
"""

from __future__ import annotations

import re
import types
import typing
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any

from engine.variant.spec import VariantSpec

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Mapping

    from pydantic_core import ErrorDetails, ValidationError

    from engine.variant.locate import KeyPath
    from engine.variant.source import Node
    from rulelang.diagnostics import Diagnostic


MOST_TOLD = 100
"""Nobody mends more at a time; what comes after is told on the next check."""


@dataclass(slots=True)
class Report:
    """The mistakes found so far in the tree below `root`; the same is never told twice."""

    root: Node
    diagnostics: list[Diagnostic] = field(default_factory=list)
    shape: Any = VariantSpec
    """The class that has the keys of the file as its `model_fields`."""

    def add(
        self, code: str, path: KeyPath, message: str, mend: str = "", *, on_key: bool = False
    ) -> None:
        """Add a mistake at `path`, which may lead deeper than the tree does."""
        if self.is_full:
            return
        one = self.root.diagnostic(code, path, message, mend, on_key=on_key)
        same = (one.code, one.file, one.line, one.column, one.message)
        told = ((o.code, o.file, o.line, o.column, o.message) for o in self.diagnostics)
        if same not in told:
            self.diagnostics.append(one)

    def unknown(self, code: str, path: KeyPath, what: str, name: str, known: Iterable[str]) -> None:
        """Add "there is no `what` called `name`" with the nearest of the known names."""
        if not self.is_full:
            self.add(code, path, f"there is no {what} called `{name}`", nearest(name, known))

    @property
    def is_full(self) -> bool:
        """Whether as many mistakes were found as are told."""
        return len(self.diagnostics) >= MOST_TOLD

    def add_shape_errors(self, error: ValidationError, broken: Collection[str]) -> None:
        """Add every mistake of shape that was found, save what is missing in a `broken` part."""
        missing: dict[KeyPath, list[str]] = {}
        misspelt: dict[KeyPath, list[str]] = {}
        for one in error.errors(include_url=False):
            if self.is_full:
                return
            if one["type"] != "missing":
                self._add_shape_error(one)
                if one["type"] == "extra_forbidden":
                    misspelt.setdefault(one["loc"][:-1], []).append(str(one["loc"][-1]))
            elif one["loc"][0] not in broken:
                missing.setdefault(one["loc"][:-1], []).append(str(one["loc"][-1]))
        for path, lacking in missing.items():
            meant = [get_close_matches(name, lacking, 1, 0.6) for name in misspelt.get(path, ())]
            keys = [key for key in lacking if [key] not in meant]
            if not keys:
                continue
            named = ", ".join(f"`{key}`" for key in keys)
            message = f"{named} {'is' if len(keys) == 1 else 'are'} missing"
            self.add("V102", (*path, keys[0]), message, _missing_mend(path, keys))

    def _add_shape_error(self, one: ErrorDetails) -> None:
        path = tuple(key for key in one["loc"] if key != "[key]")
        context = one.get("ctx", {})
        kind = one["type"]
        if kind.startswith("V"):
            on_key = one["loc"][-1] == "[key]"
            self.add(kind, path, context["what"], context["mend"], on_key=on_key)
        elif kind == "extra_forbidden":
            known = _known_keys(self.shape, path[:-1])
            message = f"`{path[-1]}` is not known here"
            mend = _OTHER_WORDS.get(str(path[-1]), "")
            mend = mend if mend and "diameter" in known else nearest(str(path[-1]), known)
            self.add("V101", path, message, mend, on_key=True)
        elif kind == "literal_error":
            known = str(context["expected"]).replace("'", "").replace(" or ", ", ").split(", ")
            self.add(
                "V106",
                path,
                f"`{one['input']}` is no choice here",
                nearest_of(str(one["input"]), known),
            )
        else:
            code = "V105" if kind in _RANGES else "V103"
            self.add(code, path, _sentence(one["msg"]), _kind_mend(one))


_OTHER_WORDS = {"radius": "write `diameter`, twice the radius"}
_EXAMPLES = {
    "title": '"My game"',
    "rulebook": '"House rules"',
    "table": '"wpa-9ft"',
    "balls": '"pool"',
    "cloth": '"worsted-pool"',
    "cue": '{ mass = "19 oz", ... }',
    "players": 2,
    "cue_balls": '["cue"]',
}


def _missing_mend(path: KeyPath, keys: list[str]) -> str:
    examples = _EXAMPLES if not path else {}
    mend = "add " + ", ".join(f"`{key} = {examples.get(key, '...')}`" for key in keys)
    if path or len(keys) == 1:
        return mend
    return mend + '; or take them from another game: `extends = "NAME"`'


def _kind_mend(one: ErrorDetails) -> str:
    kind, written = one["type"], one["input"]
    if kind == "list_type" and isinstance(written, str):
        return f'write a list in square brackets: ["{written[:60]}"]'
    if kind in _RANGES:
        return _bound_mend(one.get("ctx", {})) if _numeric(written) else "keep to this length"
    return _KINDS.get(kind, "")


def _bound_mend(context: Mapping[str, Any]) -> str:
    words = {"ge": "{} or more", "gt": "more than {}", "le": "{} or less", "lt": "less than {}"}
    told = [words[key].format(value) for key, value in context.items() if key in words]
    return f"write {', '.join(told)}" if told else "keep to this bound"


def _numeric(written: object) -> bool:
    return isinstance(written, int | float)


_RANGES = {
    "greater_than",
    "greater_than_equal",
    "less_than",
    "less_than_equal",
    "too_short",
    "too_long",
    "string_too_short",
    "string_too_long",
}
_KINDS = {
    "string_type": 'a text stands in quotes, as in "text"',
    "int_type": "write a whole number without quotes",
    "float_type": "write a number without quotes",
    "bool_type": "write true or false without quotes",
    "list_type": "write a list in square brackets, as in [1, 2]",
    "dict_type": "write a table, as in { key = 1 }",
    "model_type": "write a table, as in { key = 1 }",
}


def _sentence(message: str) -> str:
    message = message.replace("Input should be", "this should be")
    message = message.replace("dictionary", "table").replace("valid integer", "whole number")
    message = re.sub(r"\bvalid (list|table|number|boolean)", r"\1", message)
    message = message.replace("a boolean", "true or false")
    message = re.sub(r" or instance of \w+", "", message).replace("valid string", "text")
    return message[:1].lower() + message[1:]


def nearest(name: str, known: Iterable[str]) -> str:
    """Return "did you mean ...", or the list of what is known, or nothing."""
    names = list(known)
    bare = name.removesuffix("-ball").removesuffix(".toml").removesuffix(".rules")
    if bare != name and bare in names:
        return f"write `{bare}`"
    close = get_close_matches(name, names, 1, 0.6)
    if close:
        return f"did you mean `{close[0]}`?"
    if not names:
        return ""
    shown = ", ".join(names[:12]) + (", ..." if len(names) > 12 else "")
    return f"known: {shown}"


def nearest_of(name: str, known: list[str]) -> str:
    """Return what is meant, or else all that is allowed."""
    close = get_close_matches(name, known, 1, 0.6)
    allowed = f"allowed here: {', '.join(known)}"
    return f"did you mean `{close[0]}`? {allowed}" if close else allowed


def _known_keys(shape: Any, path: KeyPath) -> list[str]:
    """Return the keys that the model at `path` below the whole file knows."""
    model: Any = shape
    for key in path:
        model = _model_in(model)
        if model is not None and key in model.model_fields:
            model = model.model_fields[str(key)].annotation
    model = _model_in(model)
    variant = shape is VariantSpec
    extra = ["use"] if variant and path in {("table",), ("balls",), ("pins",), ("cloth",)} else []
    extra += ["extends"] if variant and not path else []
    return [*model.model_fields, *extra] if model is not None else extra


def _model_in(annotation: Any) -> Any:
    """Return the model class inside an annotation such as `dict[Name, Model] | None`."""
    if isinstance(annotation, type) and not isinstance(annotation, types.GenericAlias):
        return annotation if hasattr(annotation, "model_fields") else None
    for inner in reversed(typing.get_args(annotation)):
        found = _model_in(inner)
        if found is not None:
            return found
    return None
