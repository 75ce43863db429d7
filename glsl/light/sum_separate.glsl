// GL_SEPARATE_SPECULAR_COLOR: the shiny part is added after texturing.
vec4 litColor(Surface s) {
    return vec4(s.emission.rgb + s.ambient.rgb * gl_LightModel.ambient.rgb + s.matte, s.diffuse.a);
}

vec4 litSecondaryColor(Surface s) {
    return vec4(s.shiny, 1.0);
}
