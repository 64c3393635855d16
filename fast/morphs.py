"""Morphs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast import affine_lie, sam, se3, so3
from affinecert.fast._kernel import checked


def _inputs(start, end, t, sizes=(3, 4)):
    n = "n" if len(sizes) > 1 else sizes[0]
    b, c, t = checked({"start": (n, n), "end": (n, n), "t": ()}, (start, end, t), sizes)[0]
    for name, x in (("start", b), ("end", c)):
        bad = (x[..., -1, :] != np.eye(x.shape[-1])[-1]).any(axis=-1) | ~(np.linalg.det(x[..., :-1, :-1]) > 0)
        if bad.any():
            raise InputError(name, "not an affine map of positive determinant", tuple(int(i) for i in np.argwhere(bad)[0]))
    return b, c, t


def _mix(x, y, t, dims):
    t = t.reshape(t.shape + (1,) * dims)
    return (1 - t) * x + t * y


def _polar(m):
    u, s, v = np.linalg.svd(m)
    return u @ v, np.swapaxes(v, -1, -2) * s[..., None, :] @ v


def _turn(m):
    if m.shape[-1] == 2:
        return np.arctan2(m[..., 1, 0], m[..., 0, 0])[..., None] 
    return so3.log(m)


def _rot(w):
    if w.shape[-1] == 1:
        c, s = np.cos(w[..., 0]), np.sin(w[..., 0])
        return np.stack([c, -s, s, c], axis=-1).reshape(*c.shape, 2, 2)
    return so3.exp(w)


def _pow(m, t):
    return _rot(_turn(m) * t[..., None])


def _sym(m, f):
    w, v = np.linalg.eigh(m)
    return v * f(w)[..., None, :] @ np.swapaxes(v, -1, -2)


def _pose(lin, tr):
    shape = np.broadcast_shapes(lin.shape[:-1], tr.shape)
    m = np.zeros(shape[:-1] + (shape[-1] + 1,) * 2)
    m[..., :-1, :-1], m[..., :-1, -1], m[..., -1, -1] = lin, tr, 1.0
    return m


def _split(x):
    return x[..., :-1, :-1], x[..., :-1, -1]


def linear(start: ArrayLike, end: ArrayLike, t: ArrayLike):
    b, c, t = _inputs(start, end, t)
    return _mix(b, c, t, 2)


def shoemake_duff(start, end, t):
    b, c, t = _inputs(start, end, t)
    (lb, tb), (lc, tc) = _split(b), _split(c)
    (rb, sb), (rc, sc) = _polar(lb), _polar(lc)
    return _pose(rb @ _pow(np.swapaxes(rb, -1, -2) @ rc, t) @ _mix(sb, sc, t, 2), _mix(tb, tc, t, 1))


def _about(b, c, t, lin):
    (lb, tb), (lc, tc) = _split(b), _split(c)
    n = lb.shape[-1]
    g = np.full(n, 1 / (n + 1))
    return _pose(lin, _mix(lb @ g + tb, lc @ g + tc, t, 1) - lin @ g)


def _arap(b, c, t):
    r, s = _polar(_split(c)[0] @ np.linalg.inv(_split(b)[0]))
    return _pow(r, t) @ _mix(np.eye(s.shape[-1]), s, t, 2) @ _split(b)[0]


def arap(start, end, t):
    b, c, t = _inputs(start, end, t)
    return _pose(_arap(b, c, t), _mix(_split(b)[1], _split(c)[1], t, 1))


def rarap(start, end, t):
    b, c, t = _inputs(start, end, t)
    return _about(b, c, t, _arap(b, c, t))


def asap(start, end, t):
    b, c, t = _inputs(start, end, t)
    r, s = _polar(_split(c)[0] @ np.linalg.inv(_split(b)[0]))
    return _about(b, c, t, _pow(r, t) @ _sym(s, lambda w: w ** t[..., None]) @ _split(b)[0])


def _expm(x):
    norm = np.max(np.sum(np.abs(x), axis=-1), initial=1e-9)
    k = max(0, int(np.ceil(np.log2(norm))) + 4)
    y = x / 2.0**k
    e = term = np.broadcast_to(np.eye(x.shape[-1]), x.shape)
    for i in range(1, 14):
        term = term @ y / i
        e = e + term
    for _ in range(k):
        e = e @ e
    return e


def alexa_2002(start, end, t):
    b, c, t = _inputs(start, end, t)
    try:
        first = sam.log(b)
    except InputError as e:
        raise InputError("start", e.reason, e.index) from e
    try:
        last = sam.log(c)
    except InputError as e:
        raise InputError("end", e.reason, e.index) from e
    return _expm(_mix(first, last, t, 2))


def sumner_2005(start, end, t):
    b, c, t = _inputs(start, end, t)
    (lb, tb), (lc, tc) = _split(b), _split(c)
    (rb, sb), (rc, sc) = _polar(lb), _polar(lc)
    return _pose(_rot(_mix(_turn(rb), _turn(rc), t, 1)) @ _mix(sb, sc, t, 2), _mix(tb, tc, t, 1))


def polar_exponential(start, end, t):
    b, c, t = _inputs(start, end, t)
    (lb, tb), (lc, tc) = _split(b), _split(c)
    (rb, sb), (rc, sc) = _polar(lb), _polar(lc)
    s = _sym(_mix(_sym(sb, np.log), _sym(sc, np.log), t, 2), np.exp)
    return _pose(_rot(_mix(_turn(rb), _turn(rc), t, 1)) @ s, _mix(tb, tc, t, 1))


def _similarity(b):
    r, s = _polar(_split(b)[0])
    k = np.linalg.det(s) ** (1 / s.shape[-1])
    z = _pose(k[..., None, None] * r, _split(b)[1])
    return z, s / k[..., None, None]


def log_spiral(start, end, t):
    b, c, t = _inputs(start, end, t)
    (zb, db), (zc, dc) = _similarity(b), _similarity(c)
    z = sam.morph(zb, zc, t)
    return z @ _pose(_mix(db, dc, t, 2), np.zeros(db.shape[-1]))


def _progress(log, t):
    with np.errstate(all="ignore"):
        return np.where(log == 0, t, np.expm1(t * log) / np.expm1(log))


def three_spiral(start, end, t):
    b, c, t = _inputs(start, end, t, (3,))

    def corners(x):
        z = x[..., 0, :] + 1j * x[..., 1, :]
        return [z[..., 2], z[..., 2] + z[..., 0], z[..., 2] + z[..., 1]]

    p, q = corners(b), corners(c)
    w = [_progress(np.log((q[j] - q[i]) / (p[j] - p[i])), t) for i, j in ((0, 1), (1, 2), (2, 0))]
    v = [p[i] + (w[i] + w[i - 1]) / 2 * (q[i] - p[i]) for i in range(3)]
    cols = np.stack([v[1] - v[0], v[2] - v[0], v[0]], axis=-1)
    m = np.zeros(cols.shape[:-1] + (3, 3))
    m[..., 0, :], m[..., 1, :], m[..., 2, 2] = cols.real, cols.imag, 1.0
    return m


def lie(start, end, t):
    b, c, t = _inputs(start, end, t)

    def solid(x):
        n = x.shape[-1] - 1
        e = np.broadcast_to(np.eye(4), x.shape[:-2] + (4, 4)).copy()
        e[..., :n, :n], e[..., :n, 3] = _split(x)
        o = e[..., :3, 3]
        return np.concatenate([o[..., None, :], np.swapaxes(e[..., :3, :3], -1, -2) + o[..., None, :]], axis=-2)

    v = affine_lie.interpolate_tetrahedra(solid(b), solid(c), t)
    n = b.shape[-1] - 1
    lin = np.swapaxes(v[..., 1:, :] - v[..., :1, :], -1, -2)
    return _pose(lin[..., :n, :n], v[..., 0, :n])


def _rigid(start, end, t):
    b, c, t = checked({"start": (4, 4), "end": (4, 4), "t": ()}, (start, end, t))[0]
    out = []
    for name, x in (("start", b), ("end", c)):
        try:
            w = se3.log(x)[..., :3]
        except InputError as e:
            raise InputError(name, e.reason, e.index) from e
        out.append(_pose(so3.exp(w), x[..., :3, 3]))
    return *out, t


def sclerp(start, end, t):
    b, c, t = _rigid(start, end, t)
    return b @ se3.exp(t[..., None] * se3.log(np.linalg.inv(b) @ c))


def _quaternion(r):
    w = so3.log(r)
    a = np.linalg.norm(w, axis=-1, keepdims=True)
    with np.errstate(all="ignore"):
        return np.concatenate([np.cos(a / 2), np.where(a > 0, w * np.sin(a / 2) / a, 0)], axis=-1)


def _product(p, q):
    s = p[..., 0] * q[..., 0] - np.sum(p[..., 1:] * q[..., 1:], axis=-1)
    v = p[..., :1] * q[..., 1:] + q[..., :1] * p[..., 1:] + np.cross(p[..., 1:], q[..., 1:])
    return np.concatenate([s[..., None], v], axis=-1)


def dual_quaternion_linear(start, end, t):
    b, c, t = _rigid(start, end, t)
    p, q = _quaternion(b[..., :3, :3]), _quaternion(c[..., :3, :3])
    d = np.sum(p * q, axis=-1, keepdims=True)
    q = np.where(d < -1e-15, -q, q)

    def moved(x, p):
        v = np.concatenate([np.zeros(x.shape[:-2] + (1,)), x[..., :3, 3]], axis=-1)
        return _product(v, p)

    real, dual = _mix(p, q, t, 1), _mix(moved(b, p), moved(c, q), t, 1)
    n = np.sum(real**2, axis=-1, keepdims=True)
    way = _product(dual, real * np.array([1, -1, -1, -1]))[..., 1:] / n
    real = real / np.sqrt(n)
    w, x, y, z = np.moveaxis(real, -1, 0)
    r = np.stack(
        [
            1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
            2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
            2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y),
        ],
        axis=-1,
    ).reshape(*w.shape, 3, 3)
    return _pose(r, way)


MORPHS: Mapping[str, Callable] = MappingProxyType(
    {
        f.__name__: f
        for f in (
            linear, shoemake_duff, arap, rarap, asap, alexa_2002, sumner_2005, log_spiral, three_spiral, lie,
            polar_exponential, sclerp, dual_quaternion_linear,
        )
    }
    | {"sam": sam.morph}
)
