"""Curved motion: rigid bodies, splines, functions."""
