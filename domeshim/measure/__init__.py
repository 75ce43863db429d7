"""Was it right, was it fast: capture and comparison."""
