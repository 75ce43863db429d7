"""5 of 7: state and lens become a recipe, the recipe GLSL text, the text a program."""
