// Where the vertex is, for the fragment stage to find which way its piece faces.
out vec3 domeSeen;
