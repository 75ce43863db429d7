// A corner of a piece of a split primitive: gl_Vertex and all else are the whole primitive's corner of that
// number, domePlace is the piece's own, domeWeights says where that lies in the whole.
in vec4 domePlace;
in vec3 domeWeights;
out vec3 domeShare;
