// One colour of a lit surface: matte and shiny parts together.
vec4 litColor(Surface s) {
    return vec4(s.emission.rgb + s.ambient.rgb * gl_LightModel.ambient.rgb + s.matte + s.shiny, s.diffuse.a);
}
