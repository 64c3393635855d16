"""The laws, one module each; `LAWS` holds them all."""

from __future__ import annotations

from affinecert.properties.law import Law
from affinecert.properties.laws import (
    canonical_tetrahedron,
    closure,
    decomposition,
    determinant,
    endpoints,
    equivariance,
    existence,
    exp_log,
    fixed_point,
    isometry,
    one_parameter,
    parametrisation,
    reversibility,
    steadiness,
    subclasses,
    volume_kept,
    volume_monotone,
)

LAWS: tuple[Law, ...] = (
    *volume_monotone.LAWS,
    *determinant.LAWS,
    *volume_kept.LAWS,
    *isometry.LAWS,
    *reversibility.LAWS,
    *canonical_tetrahedron.LAWS,
    *steadiness.LAWS,
    *existence.LAWS,
    *decomposition.LAWS,
    *exp_log.LAWS,
    *one_parameter.LAWS,
    *closure.LAWS,
    *equivariance.LAWS,
    *endpoints.LAWS,
    *fixed_point.LAWS,
    *parametrisation.LAWS,
    *subclasses.LAWS,
)
