"""What each setting is, in a few words for --help; what it accepts stands in settings.py."""

from __future__ import annotations

MEANINGS = {
    "config": "Settings from a file",
    "preset": "Several settings at once",
    "fov": "Full angle of the lens",
    "tilt": "How far the dome's axis is raised above the program's forward direction",
    "heading": "How far the dome is turned to the right",
    "roll": "How far the picture is turned clockwise",
    "seat": "Where the viewer is",
    "projector": "Where the projector is",
    "radius": "The dome's, in the unit of seat and projector",
    "lens": "Where on the disc an angle lands",
    "method": "How draws get onto the dome",
    "tolerance": "How far a straight edge may land from its curve",
    "hud": "What becomes of flat drawing over a scene",
    "panel": "Height of the flat screen of a program without a perspective",
    "fill": "What the program's own vertical view shall span",
    "stereo": "Which eye's picture, or how both are shown",
    "eyes": "Their distance, in the program's units",
    "surface": "What the projector shines on",
    "disc": "Where the picture lies in the frame",
    "mirror": "Turn the picture over",
    "fade": "Width of the fade to black at the rim",
    "brightness": "A factor of the light",
    "gamma": "Of the projector's light",
    "max_turn": "How fast the view may turn",
    "frame": "The real window's size, whatever the program asks for",
    "display": "Which display to cover",
    "vsync": "Pictures in step with the display, or at once",
}
