"""Audits: whether a whole motion is free, and if not, where it is bad."""
