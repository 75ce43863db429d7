// A vertex as GL has evaluated it, handed out before anything is done to it.
varying vec4 caughtVertex, caughtColor, caughtTexture;
varying vec3 caughtNormal;

void main() {
    caughtVertex = gl_Vertex;
    caughtNormal = gl_Normal;
    caughtColor = gl_Color;
    caughtTexture = gl_MultiTexCoord0;
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
