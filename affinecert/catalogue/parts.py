"""The parts that entries of the catalogue have in common: which entries of an array, the time, output blocks."""

from __future__ import annotations

import numpy as np

from affinecert.map import Argument, Block, Group

WHOLE = (...,)
"""Every entry of an array."""

LINEAR = np.s_[:-1, :-1]
"""The linear part of a homogeneous matrix, of the plane or of space."""

TRANSLATION = np.s_[:-1, -1]
"""Its translation."""

ENTRIES = Group(WHOLE, "entries")
NORM = Group(WHOLE, "norm")

TIME = Argument("t", (), (ENTRIES,), "1")

LINEAR_BLOCKS = (Block("linear", 0, LINEAR), Block("translation", 0, TRANSLATION))
