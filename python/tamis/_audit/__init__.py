"""Audits of whole motions."""
