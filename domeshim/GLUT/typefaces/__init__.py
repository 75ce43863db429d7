"""Where the letters come from: an installed freeglut's own fonts, else Hershey-Fonts and Pillow."""
