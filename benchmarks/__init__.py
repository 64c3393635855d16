"""Timings beside accuracy: of every map, of peers, of the instrument, and of two versions of the project."""
