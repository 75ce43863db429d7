"""Beside the way of a call: how far off each method is, and how long it takes."""
