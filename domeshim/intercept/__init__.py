"""1 of 7: the program's calls arrive here and are passed on."""
