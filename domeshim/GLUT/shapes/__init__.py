"""The solids' meshes: pure functions of their parameters, on numpy, without any GL call."""
