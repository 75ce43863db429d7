// A light at a place, that grows weaker with the distance where the program says so. The vertex counts by its
// x, y and z alone: with a perspective on MODELVIEW the fixed pipeline does not divide by its w.
float attenuation(int i, float r) {
    return 1.0 / (gl_LightSource[i].constantAttenuation
        + r * (gl_LightSource[i].linearAttenuation + r * gl_LightSource[i].quadraticAttenuation));
}

void lightPositional(int i, vec4 eye, vec3 viewer, inout Surface s) {
    vec3 away = gl_LightSource[i].position.xyz / gl_LightSource[i].position.w - eye.xyz;
    float r = length(away);
    shine(s, gl_LightSource[i].ambient.rgb, gl_LightSource[i].diffuse.rgb, gl_LightSource[i].specular.rgb,
          r > 0.0 ? away / r : away, viewer, attenuation(i, r), 1.0);
}
