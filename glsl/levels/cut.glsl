// How many pieces the CPU has made of the edge.
attribute float domePieces;
