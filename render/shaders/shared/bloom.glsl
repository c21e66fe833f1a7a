// Light scattered in the eye, by a pyramid of ever coarser pictures. Sums of light stay: a coarse cell is the mean of
// what it covers, and hands on to every place as much as it covers. Also compiles as C++.

// How much of the cell from `low` to `high` the pixel from `pixel` to pixel + 1 covers.
float bloom_overlap(float pixel, float low, float high) {
    return max(min(pixel + 1.0f, high) - max(pixel, low), 0.0f);
}

// Where to look between the finest cells for what they give to a pixel, the pixel being at most as long as a cell: a
// place at which linear interpolation weights the two cells by how much of the pixel they cover.
float bloom_place(float pixel, float cells_per_pixel) {
    float low = pixel * cells_per_pixel;
    float cell = floor(low);
    return cell + 0.5f + max(low + cells_per_pixel - cell - 1.0f, 0.0f) / cells_per_pixel;
}
