// Over 0.5: glShadeModel(GL_FLAT), one corner of each primitive gives its colour.
uniform float domeFlat;
