// Where the piece's corners, four at most, lie in the whole primitive.
in vec3 domeShare[];
patch out vec3 domeShares[4];
