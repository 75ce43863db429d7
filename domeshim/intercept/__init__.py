"""1 of 7: the program's calls arrive here and are passed on: finder, overlay, and the names of gl and glu."""
