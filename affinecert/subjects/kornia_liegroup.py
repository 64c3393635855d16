"""kornia's `So3` class: rotations kept as quaternions, by other code than `kornia.geometry.conversions`."""

from __future__ import annotations

from typing import Any

import kornia
from kornia.geometry.liegroup import So3

from affinecert.subject import Subject
from affinecert.subjects.on_tensors import on_tensors


@on_tensors
def so3_exp(omega: Any) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return So3.exp(omega).matrix()


@on_tensors
def so3_log(rotation: Any) -> Any:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return So3.from_matrix(rotation).log()


SNIPPETS = {
    "so3.exp": """import torch
from kornia.geometry.liegroup import So3
print(So3.exp(torch.tensor([{input0}], dtype=torch.float64)).matrix()[0].tolist())""",
    "so3.log": """import torch
from kornia.geometry.liegroup import So3
print(So3.from_matrix(torch.tensor([{input0}], dtype=torch.float64)).log()[0].tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="kornia_liegroup",
    version=kornia.__version__,
    maps={"so3.exp": so3_exp, "so3.log": so3_log},
    conventions={
        "rotations": "kept as quaternions (w, x, y, z), made from and into matrices by the conversions of kornia",
        "branch at pi": "documented: at real part exactly 0 the sign is that of the quaternion found",
    },
    policies={
        "not a rotation": "documented: by default the matrix is not checked (check_rotation=True would refuse it)",
        "off the manifold": "documented for rotation matrices; unchecked, their entries are taken as they are",
    },
    snippets=SNIPPETS,
)
