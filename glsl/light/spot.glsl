// A light at a place that shines into a cone.
void lightSpot(int i, vec4 eye, vec3 viewer, inout Surface s) {
    vec3 away = gl_LightSource[i].position.xyz / gl_LightSource[i].position.w - eye.xyz;
    float r = length(away);
    vec3 toLight = r > 0.0 ? away / r : away;
    float along = dot(-toLight, normalize(gl_LightSource[i].spotDirection));
    float exponent = gl_LightSource[i].spotExponent;
    float spot = 0.0;
    if (along >= gl_LightSource[i].spotCosCutoff && along > 0.0)
        spot = exponent > 0.0 ? pow(along, exponent) : 1.0;
    shine(s, gl_LightSource[i].ambient.rgb, gl_LightSource[i].diffuse.rgb, gl_LightSource[i].specular.rgb,
          toLight, viewer, attenuation(i, r), spot);
}
