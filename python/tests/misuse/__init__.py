"""Calls of every public function with arguments that are wrong in type, size or meaning, made from the signatures."""
