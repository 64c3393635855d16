"""The laws that every implementation has to keep, and the Hypothesis strategies that try them."""
