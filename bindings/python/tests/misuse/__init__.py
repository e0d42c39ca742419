"""Generates, from the signatures, calls of every public function with arguments of wrong type, size or meaning."""
