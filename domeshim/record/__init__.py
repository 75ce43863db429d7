"""2 of 7: glBegin..glEnd, arrays and display lists become meshes and command lists."""
