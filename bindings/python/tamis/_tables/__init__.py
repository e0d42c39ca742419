"""Answers as tables of columns: contacts, near pairs, intersections."""
