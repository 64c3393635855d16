"""The laws, one module each; `LAWS` holds them all."""

from __future__ import annotations

from affinecert.properties.law import Law
from affinecert.properties.laws import (
    canonical_tetrahedron,
    closure,
    coincidence,
    curve_length,
    decomposition,
    endpoints,
    equivariance,
    existence,
    exp_log,
    fixed_point,
    great_arcs,
    isometry,
    one_parameter,
    path_invariance,
    reversibility,
    similarity,
    steadiness,
    volume_kept,
    volume_monotone,
)

LAWS: tuple[Law, ...] = (
    *volume_monotone.LAWS,
    *volume_kept.LAWS,
    *isometry.LAWS,
    *reversibility.LAWS,
    *canonical_tetrahedron.LAWS,
    *steadiness.LAWS,
    *existence.LAWS,
    *decomposition.LAWS,
    *exp_log.LAWS,
    *one_parameter.LAWS,
    *similarity.LAWS,
    *closure.LAWS,
    *equivariance.LAWS,
    *endpoints.LAWS,
    *fixed_point.LAWS,
    *coincidence.LAWS,
    *great_arcs.LAWS,
    *curve_length.LAWS,
    *path_invariance.LAWS,
)
