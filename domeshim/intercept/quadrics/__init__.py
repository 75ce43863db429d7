"""GLU's quadrics, which GLU draws from C where the dome cannot subdivide them, redone in Python."""
