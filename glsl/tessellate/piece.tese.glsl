// Where the piece's corners lie in the whole primitive.
patch in vec3 domeShares[3];
