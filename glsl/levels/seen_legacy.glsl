// Where the vertex is, for the fragment stage to find which way its piece faces.
varying vec3 domeSeen;
