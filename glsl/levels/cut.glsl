// How many pieces the CPU has made of the edge.
in float domePieces;
