// What light falls on, and what it has gathered: OpenGL 2.1, section 2.14.1.
struct Surface {
    vec4 emission;
    vec4 ambient;
    vec4 diffuse;
    vec4 specular;
    float shininess;
    vec3 normal;
    vec3 matte; // gathered: emission, ambient and diffuse
    vec3 shiny; // gathered: specular
};

Surface surfaceOf(gl_MaterialParameters material, vec3 normal) {
    return Surface(material.emission, material.ambient, material.diffuse, material.specular, material.shininess,
                   normal, vec3(0.0), vec3(0.0));
}

void shine(inout Surface s, vec3 ambient, vec3 diffuse, vec3 specular, vec3 toLight, vec3 viewer, float strength,
           float spot) {
    float lit = max(dot(s.normal, toLight), 0.0);
    vec3 gathered = s.ambient.rgb * ambient + lit * s.diffuse.rgb * diffuse;
    s.matte += strength * spot * gathered;
    if (lit > 0.0) {
        float glance = max(dot(s.normal, normalize(toLight + viewer)), 0.0);
        float power = s.shininess > 0.0 ? pow(glance, s.shininess) : 1.0;
        s.shiny += strength * spot * power * s.specular.rgb * specular;
    }
}
