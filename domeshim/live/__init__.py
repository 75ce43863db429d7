"""Beside the running program: what its audience sees is recorded, and shown on a virtual dome."""
