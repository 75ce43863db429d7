// The program gives the fog coordinate itself (GL_FOG_COORD).
float fogCoordinate(vec4 eye) {
    return gl_FogCoord;
}
