"""Motion on curves: rigid bodies, splines, functions of the user."""
