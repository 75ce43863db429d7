"""A virtual dome on the desk: pictures on a hemisphere, and a viewer in it."""
