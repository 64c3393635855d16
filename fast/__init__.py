"""Every map in compiled float64: the product's own implementation.

Each function takes arguments with any leading batch shape, broadcasts them, gives the same bits for one item as for
that item in a batch, and raises `affinecert.errors.InputError` naming the item that it refuses. A kernel compiles at
its first call, and numba keeps it on disk.
"""
