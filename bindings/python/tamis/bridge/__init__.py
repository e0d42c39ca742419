"""Converts answers of Tamis for other libraries. Each module needs the library of its name."""
