#include "content/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>

namespace content {
namespace {

// An accessor without a view has no file size to bound it.
constexpr std::size_t most_elements = std::size_t{1} << 27U;

struct Elements {
    std::span<const std::uint8_t> bytes; // from the first element on; empty: all zero
    std::size_t stride = 0;
    std::size_t count = 0;
};

struct Layout {
    int component_type = 0;
    std::size_t component_bytes = 0;
    std::size_t components = 0;

    std::size_t element_bytes() const { return component_bytes * components; }
};

template <class Component>
Component component_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
    Component component{};
    std::memcpy(&component, bytes.data() + offset, sizeof(component));
    return component;
}

template <class Component>
float number_at(std::span<const std::uint8_t> bytes, std::size_t offset, bool normalised) {
    const auto number = static_cast<float>(component_at<Component>(bytes, offset));
    if (!normalised) {
        return number;
    }
    return std::max(number / static_cast<float>(std::numeric_limits<Component>::max()), -1.0f);
}

float number_at(const Layout& layout, std::span<const std::uint8_t> bytes, std::size_t offset, bool normalised) {
    switch (layout.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return number_at<std::int8_t>(bytes, offset, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return number_at<std::uint8_t>(bytes, offset, normalised);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return number_at<std::int16_t>(bytes, offset, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return number_at<std::uint16_t>(bytes, offset, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return number_at<std::uint32_t>(bytes, offset, normalised);
    default:
        return component_at<float>(bytes, offset);
    }
}

std::uint32_t index_at(const Layout& layout, std::span<const std::uint8_t> bytes, std::size_t offset) {
    switch (layout.component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return component_at<std::uint8_t>(bytes, offset);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return component_at<std::uint16_t>(bytes, offset);
    default:
        return component_at<std::uint32_t>(bytes, offset);
    }
}

std::size_t bytes_of_component(const GltfDocument& document, int type, const std::string& field) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    default:
        document.fail(field, std::to_string(type), "not a component type of glTF 2.0");
    }
}

std::size_t components_of_type(const GltfDocument& document, int type, const std::string& field) {
    switch (type) {
    case TINYGLTF_TYPE_SCALAR:
        return 1;
    case TINYGLTF_TYPE_VEC2:
        return 2;
    case TINYGLTF_TYPE_VEC3:
        return 3;
    case TINYGLTF_TYPE_VEC4:
        return 4;
    default:
        document.fail(field, "", "a matrix where numbers or vectors are wanted");
    }
}

Layout layout_of(const GltfDocument& document, const tinygltf::Accessor& accessor, const std::string& name) {
    return {accessor.componentType, bytes_of_component(document, accessor.componentType, name + ".componentType"),
            components_of_type(document, accessor.type, name + ".type")};
}

// `count` elements from `offset` on in a view, checked to lie within it.
Elements elements_in_view(const GltfDocument& document, int buffer_view, std::size_t offset, std::size_t count,
                          const Layout& layout, const std::string& name) {
    const auto bytes = document.view_bytes(buffer_view, name + ".bufferView");
    const std::size_t declared = document.model.bufferViews[static_cast<std::size_t>(buffer_view)].byteStride;
    const std::size_t stride = declared == 0 ? layout.element_bytes() : declared;
    if (stride < layout.element_bytes()) {
        document.fail(fmt::format("bufferViews[{}].byteStride", buffer_view), std::to_string(declared),
                      fmt::format("shorter than the {} bytes of an element of {}", layout.element_bytes(), name));
    }
    const std::size_t available = offset > bytes.size() || bytes.size() - offset < layout.element_bytes()
                                      ? 0
                                      : (bytes.size() - offset - layout.element_bytes()) / stride + 1;
    if (count > available) {
        document.fail(name + ".count", std::to_string(count), fmt::format("its view has room for {}", available));
    }
    return {count == 0 ? bytes.first(0) : bytes.subspan(offset), stride, count};
}

Elements dense_elements(const GltfDocument& document, const tinygltf::Accessor& accessor, const Layout& layout,
                        const std::string& name) {
    if (accessor.count == 0 || accessor.count > most_elements) {
        document.fail(name + ".count", std::to_string(accessor.count),
                      fmt::format("must be in 1 to {}", most_elements));
    }
    if (accessor.bufferView < 0) {
        return {{}, layout.element_bytes(), accessor.count};
    }
    return elements_in_view(document, accessor.bufferView, accessor.byteOffset, accessor.count, layout, name);
}

struct SparseElements {
    std::vector<std::uint32_t> targets;
    Elements values;
};

SparseElements sparse_elements(const GltfDocument& document, const tinygltf::Accessor& accessor, const Layout& layout,
                               const std::string& name) {
    if (!accessor.sparse.isSparse) {
        return {};
    }
    const auto count = static_cast<std::size_t>(accessor.sparse.count);
    const auto& indices = accessor.sparse.indices;
    const std::string indices_name = name + ".sparse.indices";
    const Layout index_layout{indices.componentType,
                              bytes_of_component(document, indices.componentType, indices_name + ".componentType"), 1};
    const Elements positions = elements_in_view(
        document, indices.bufferView, static_cast<std::size_t>(indices.byteOffset), count, index_layout, indices_name);
    SparseElements sparse;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t target = index_at(index_layout, positions.bytes, i * positions.stride);
        if (target >= accessor.count) {
            document.fail(fmt::format("{}[{}]", indices_name, i), std::to_string(target),
                          fmt::format("the accessor has {} elements", accessor.count));
        }
        sparse.targets.push_back(target);
    }
    const auto& values = accessor.sparse.values;
    sparse.values = elements_in_view(document, values.bufferView, static_cast<std::size_t>(values.byteOffset), count,
                                     layout, name + ".sparse.values");
    return sparse;
}

} // namespace

GltfNumbers read_numbers(const GltfDocument& document, int accessor_index, std::size_t fewest, std::size_t most,
                         const std::string& field) {
    const auto& accessors = document.model.accessors;
    const std::size_t index = document.checked_index(accessor_index, accessors.size(), field);
    const tinygltf::Accessor& accessor = accessors[index];
    const std::string name = fmt::format("accessors[{}]", index);
    const Layout layout = layout_of(document, accessor, name);
    if (layout.components < fewest || layout.components > most) {
        document.fail(field, fmt::format("{} components", layout.components),
                      fewest == most ? fmt::format("must be {}", most) : fmt::format("must be {} to {}", fewest, most));
    }
    const Elements dense = dense_elements(document, accessor, layout, name);
    const SparseElements sparse = sparse_elements(document, accessor, layout, name);

    GltfNumbers numbers{dense.count, layout.components, std::vector<float>(dense.count * layout.components, 0.0f)};
    const auto copy_element = [&](const Elements& from, std::size_t source, std::size_t target) {
        for (std::size_t c = 0; c < layout.components; ++c) {
            const float number =
                number_at(layout, from.bytes, source * from.stride + c * layout.component_bytes, accessor.normalized);
            if (!std::isfinite(number)) {
                document.fail(fmt::format("{}[{}]", field, target), fmt::format("{}", number), "not a finite number");
            }
            numbers.values[target * layout.components + c] = number;
        }
    };
    if (!dense.bytes.empty()) {
        for (std::size_t i = 0; i < dense.count; ++i) {
            copy_element(dense, i, i);
        }
    }
    for (std::size_t i = 0; i < sparse.targets.size(); ++i) {
        copy_element(sparse.values, i, sparse.targets[i]);
    }
    return numbers;
}

std::vector<std::uint32_t> read_indices(const GltfDocument& document, int accessor_index, std::size_t limit,
                                        const std::string& field) {
    const auto& accessors = document.model.accessors;
    const std::size_t index = document.checked_index(accessor_index, accessors.size(), field);
    const tinygltf::Accessor& accessor = accessors[index];
    const std::string name = fmt::format("accessors[{}]", index);
    const Layout layout = layout_of(document, accessor, name);
    const bool is_unsigned = layout.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                             layout.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                             layout.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (layout.components != 1 || !is_unsigned || accessor.sparse.isSparse) {
        document.fail(field, name, "indices must be dense unsigned integers");
    }
    const Elements elements = dense_elements(document, accessor, layout, name);
    std::vector<std::uint32_t> indices(elements.count, 0);
    if (!elements.bytes.empty()) {
        for (std::size_t i = 0; i < elements.count; ++i) {
            indices[i] = index_at(layout, elements.bytes, i * elements.stride);
            if (indices[i] >= limit) {
                document.fail(fmt::format("{}[{}]", field, i), std::to_string(indices[i]),
                              fmt::format("there are {} vertices", limit));
            }
        }
    }
    return indices;
}

} // namespace content
