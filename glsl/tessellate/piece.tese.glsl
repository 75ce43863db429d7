// Where the piece's corners, four at most, lie in the whole primitive.
patch in vec3 domeShares[4];
