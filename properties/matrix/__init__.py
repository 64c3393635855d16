"""The law matrix: which morph keeps which law, each cell backed by a run.

`morphs` has the rows, `laws` the columns, `domains` what a law may hold on short of all pairs of poses, `bank` the
pairs that are tried, from simple to complex, and `trial` what becomes of a cell.
"""
