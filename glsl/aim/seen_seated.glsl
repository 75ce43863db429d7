// Where the seat sees what a ray of the projector carries, in the dome's space: the inverse of aimed.
uniform vec3 domeSeat;
uniform vec3 domeProjector;

vec3 seenAlong(vec3 ray) {
    float along = dot(domeProjector, ray);
    float way = sqrt(along * along + 1.0 - dot(domeProjector, domeProjector)) - along;
    return domeProjector + way * ray - domeSeat;
}
