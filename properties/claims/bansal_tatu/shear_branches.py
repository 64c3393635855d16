"""Closed forms on G_A as appendices A.2.3 and A.2.4 list them: conditions on (α2, α5), and a branch for each."""

from __future__ import annotations

from collections.abc import Callable

from affinecert.reference._matrices import Array, Context, Number

Parameters = tuple[Number, Number, Number, Number, Number]
Branch = Callable[..., Array]
Condition = Callable[[Number, Number], bool]
Listing = tuple[tuple[Condition, Branch], ...]


def with_condition(listing: Listing, place: int, condition: Condition) -> Listing:
    """The listing with another condition in one place."""
    return (*listing[:place], (condition, listing[place][1]), *listing[place + 1 :])


def by_cases(m: Context, listing: Listing, *alpha: Number) -> Array:
    """The value of the branch whose condition holds, of the last if none does; a division by zero if two hold."""
    *cases, (_, otherwise) = listing
    branches = [branch for condition, branch in cases if condition(alpha[1], alpha[4])] or [otherwise]
    if len(branches) > 1:
        raise ZeroDivisionError("two conditions hold")
    return branches[0](m, *alpha)


def corner(branch: Branch) -> Callable[..., Number]:
    """The entry in the last column of the first row."""
    return lambda m, *alpha: branch(m, *alpha)[0, 2]


def edge(branch: Branch) -> Callable[..., Number]:
    """The entry below the corner."""
    return lambda m, *alpha: branch(m, *alpha)[1, 2]
