// Where the piece's corners lie in the whole primitive.
in vec3 domeShare[];
