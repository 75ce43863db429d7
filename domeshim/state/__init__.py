"""3 of 7: what the program has set, asked of GL when a draw needs it."""
