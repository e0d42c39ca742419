"""Audits of whole motions: is it free, and if not, where?"""
