"""Audits: is a whole motion free, and if not, where is it bad?"""
