"""The few errors that affinecert raises; each message names what is wrong and where."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class AffinecertError(Exception):
    """Base of every error that affinecert raises on purpose."""


class InputError(AffinecertError, ValueError):
    """An argument of a map has a wrong shape or dtype, is not finite, or lies outside the map's domain.

    ``argument`` is the argument's name; ``index`` its offending batch index, ``()`` when the item stands alone or the
    argument as a whole is wrong.
    """

    def __init__(self, argument: str, reason: str, index: tuple[int, ...] = ()) -> None:
        self.argument = argument
        self.reason = reason
        self.index = index
        where = f"{argument}[{', '.join(map(str, index))}]" if index else argument
        super().__init__(f"{where}: {reason}")


class PrecisionError(AffinecertError, ArithmeticError):
    """The reference cannot settle a value at the highest precision that it goes to."""


class SubjectError(AffinecertError):
    """An adapter cannot be loaded, or is not a Subject."""


class StoredFileError(AffinecertError):
    """A file that affinecert keeps (store, corpus, certificate, report) cannot be read or written."""


class UnknownNameError(AffinecertError, LookupError):
    """No map, subject or law has that name; the message offers the nearest ones."""

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        known = sorted(known)
        folded = {candidate.casefold(): candidate for candidate in known}
        near = [folded[each] for each in difflib.get_close_matches(name.casefold(), folded, n=3, cutoff=0.4)]
        hint = f"did you mean {' or '.join(near)}?" if near else f"known: {', '.join(known)}"
        super().__init__(f"no {kind} is named {name!r}; {hint}")
