"""The floating-point numbers that subjects compute in, and the unit in which their errors are told."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType


@dataclass(frozen=True)
class Arithmetic:
    """The floating-point numbers that a subject computes in.

    ``unit`` is half the distance from 1 to the next number, the unit in which errors are told. Below
    ``smallest_normal`` numbers keep no relative accuracy, so truths are measured as if they were at least that large;
    beyond ``largest`` they are infinite. Beyond a scaled error of ``lost_half``, half of the bits, an answer is wrong,
    not degraded.
    """

    dtype: str
    unit: float
    smallest_normal: float
    largest: float
    lost_half: float

    @property
    def bits(self) -> int:
        """The b with unit = 2^-b."""
        return 1 - math.frexp(self.unit)[1]


FLOAT64 = Arithmetic("float64", 2.0**-53, 2.0**-1022, sys.float_info.max, 2.0**26)
FLOAT32 = Arithmetic("float32", 2.0**-24, 2.0**-126, (2.0 - 2.0**-23) * 2.0**127, 2.0**12)

ARITHMETICS: Mapping[str, Arithmetic] = MappingProxyType({each.dtype: each for each in (FLOAT64, FLOAT32)})
"""The arithmetics of subjects, by NumPy's names."""
