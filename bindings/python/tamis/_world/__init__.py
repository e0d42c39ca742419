"""Worlds of bodies, each with its own mesh and motion."""
