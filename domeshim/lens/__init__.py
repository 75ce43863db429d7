"""4 of 7: where a direction lands on the disc: lens models, tilt; numpy twins of glsl."""
