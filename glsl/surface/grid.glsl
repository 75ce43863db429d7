// The place goes to the nearest of so many steps from the picture's middle to its sides, domeGrid. Every driver rounds
// places in the window to such steps; done before, a place is rounded alike in the whole picture and in a tile of it.
uniform vec2 domeGrid;

vec4 onGrid(vec4 p) {
    return p.w > 0.0 ? vec4(floor(p.xy / p.w * domeGrid + 0.5) / domeGrid * p.w, p.zw) : p;
}
