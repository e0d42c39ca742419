"""The detector: questions about motion, step lengths, and meshes at rest."""
