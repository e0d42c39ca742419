"""The detector: questions of steps, step lengths, poses at rest."""
