"""Adapters that misbehave, each in its own way; loaded by name, as a user's would be."""
