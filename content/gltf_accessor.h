#pragma once

#include "content/gltf_document.h"

#include <cstdint>
#include <string>
#include <vector>

namespace content {

/// An accessor's elements as floats, `components` each; normalised integers mapped to [0, 1] or [-1, 1].
struct GltfNumbers {
    std::size_t count = 0;
    std::size_t components = 0;
    std::vector<float> values;
};

/// Reads an accessor of scalars or vectors, dense or sparse. Throws sim::BadInput naming `field` when the accessor, its
/// views or a number in it cannot be used: out of range, of a size other than `fewest` to `most` components, not
/// finite.
GltfNumbers read_numbers(const GltfDocument& document, int accessor, std::size_t fewest, std::size_t most,
                         const std::string& field);

/// Reads an accessor of 8, 16 or 32-bit indices, each below `limit`; otherwise throws sim::BadInput naming `field`.
std::vector<std::uint32_t> read_indices(const GltfDocument& document, int accessor, std::size_t limit,
                                        const std::string& field);

} // namespace content
