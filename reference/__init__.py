"""Truth: every map from its definition, in arbitrary precision over an mpmath context that the caller makes.

Each function takes the context first, then one item per argument as a NumPy object array of the context's numbers
(``()``-shaped for scalars), and returns the same: no batches here. It works at the context's precision and raises it
inside by what its own cancellation eats, so that a result is good to nearly that precision; `affinecert.truths` runs it
at two precisions and asks them to agree. The files mirror `fast`; those that start with an underscore are shared parts.
"""
