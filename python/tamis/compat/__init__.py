"""Calls of other packages by their own names, answered by Tamis."""
