"""Answers as tables of columns: contacts, near pairs, and what they share."""
