"""The interfaces of other packages, answered by Tamis."""
