"""affinecert: certifies code for affine interpolation against arbitrary-precision truth.

``certify`` runs the whole instrument on one implementation; ``truth`` tells what one map is worth at one input. Both
are imported when they are first asked for, so that ``from affinecert.fast import se3`` costs no more than it uses.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from affinecert.errors import AffinecertError, InputError, StoredFileError, SubjectError, UnknownNameError
from affinecert.subject import Subject

if TYPE_CHECKING:
    from affinecert.campaign import certify
    from affinecert.inputs import truth

__all__ = [
    "AffinecertError",
    "InputError",
    "StoredFileError",
    "Subject",
    "SubjectError",
    "UnknownNameError",
    "certify",
    "truth",
]

_LATER = {"certify": "affinecert.campaign", "truth": "affinecert.inputs"}


def __getattr__(name: str) -> Any:
    if name in _LATER:
        return getattr(import_module(_LATER[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
