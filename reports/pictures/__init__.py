"""The pictures of the documents, drawn from computations made anew: ``python -m affinecert.reports.pictures``."""
