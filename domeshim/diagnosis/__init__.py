"""Looks on while a program runs: what its draws need, what it asks for, and what this machine can do."""
