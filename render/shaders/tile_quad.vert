#version 450 core
// Blocks of the screen, one instance a tile, four vertices each.
struct Tile {
    vec4 block;             // low and high corner, normalised device coordinates
    vec4 atlas_from_axis_0; // rows of the projective map to atlas coordinates
    vec4 atlas_from_axis_1;
    vec4 atlas_from_axis_2;
};
layout(std430, binding = 0) readonly buffer Tiles { Tile tiles[]; };

flat out vec3 atlas_row_0;
flat out vec3 atlas_row_1;
flat out vec3 atlas_row_2;

void main() {
    Tile tile = tiles[gl_InstanceID];
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? tile.block.z : tile.block.x,
                       (gl_VertexID & 2) != 0 ? tile.block.w : tile.block.y);
    gl_Position = vec4(corner, 0.0, 1.0);
    atlas_row_0 = tile.atlas_from_axis_0.xyz;
    atlas_row_1 = tile.atlas_from_axis_1.xyz;
    atlas_row_2 = tile.atlas_from_axis_2.xyz;
}
