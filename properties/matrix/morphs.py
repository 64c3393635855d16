"""The rows of the law matrix: the morphs, and the poses that each is made for."""

from __future__ import annotations

from dataclasses import dataclass

from affinecert.properties.matrix import domains
from affinecert.properties.matrix.domains import Domain


@dataclass(frozen=True)
class Morph:
    """A morph, the map of the catalogue that it is, the pairs of poses it takes, and in how many dimensions."""

    name: str
    map: str
    domain: Domain = domains.ALL
    dimensions: tuple[int, ...] = (2, 3)

    @property
    def takes(self) -> str:
        """The pairs that it takes, in words."""
        where = {2: ", in the plane", 3: ", in space"}
        return self.domain.words + (where[self.dimensions[0]] if len(self.dimensions) == 1 else "")


MORPHS = (
    Morph("sam", "sam.morph"),
    Morph("lie", "morphs.lie"),
    Morph("polar_exponential", "morphs.polar_exponential"),
    Morph("sim", "morphs.sim", domains.SIMILARITIES, (3,)),
    Morph("linear", "morphs.linear"),
    Morph("shoemake_duff", "morphs.shoemake_duff"),
    Morph("arap", "morphs.arap"),
    Morph("rarap", "morphs.rarap"),
    Morph("asap", "morphs.asap"),
    Morph("alexa_2002", "morphs.alexa_2002"),
    Morph("sumner_2005", "morphs.sumner_2005"),
    Morph("log_spiral", "morphs.log_spiral"),
    Morph("three_spiral", "morphs.three_spiral", dimensions=(2,)),
    Morph("sclerp", "morphs.sclerp", domains.RIGID_POSES, (3,)),
    Morph("dual_quaternion_linear", "morphs.dual_quaternion_linear", domains.RIGID_POSES, (3,)),
)
