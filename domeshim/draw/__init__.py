"""6 of 7: the methods that put a mesh onto the disc."""
