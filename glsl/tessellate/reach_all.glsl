// Nothing is out of reach as a whole: what viewport or rim cut off is left to the clip distances.
float reach(vec4 p) {
    return 1.0;
}
