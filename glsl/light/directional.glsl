// A light infinitely far away.
void lightDirectional(int i, vec4 eye, vec3 viewer, inout Surface s) {
    shine(s, gl_LightSource[i].ambient.rgb, gl_LightSource[i].diffuse.rgb, gl_LightSource[i].specular.rgb,
          normalize(gl_LightSource[i].position.xyz), viewer, 1.0, 1.0);
}
