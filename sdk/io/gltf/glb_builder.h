// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.6 accessors, 4 GLB).
// Builds a .glb of one mesh, at one node or at nodes of the caller's: buffer views, accessors into them, primitives of
// accessors.
#pragma once

#include <cstdint>
#include <span>

#include "core/origin.h"
#include "io/base/memory.h"

namespace flg::io {

constexpr uint32_t glb_float = 5126;  // component types
constexpr uint32_t glb_unsigned = 5125;
constexpr uint32_t glb_unsigned_short = 5123;
constexpr uint32_t glb_byte = 5120;
constexpr uint32_t glb_unsigned_byte = 5121;
constexpr int glb_line_loop = 2;  // modes of primitives
constexpr int glb_line_strip = 3;
constexpr int glb_triangles = 4;

// A .glb file of these two parts. Refuses more than max_bytes.
String glb_file(String json, const String& binary);

class GlbBuilder {
public:
    GlbBuilder() = default;
    // Of a document's list of views or accessors: its length, and the places that are left over, to be taken first.
    struct Places {
        size_t count = 0;
        Vector<size_t> free;  // rising
    };
    // Goes on in a document whose bytes, a multiple of 4, these are.
    GlbBuilder(Places views, Places accessors, String binary)
        : binary_(std::move(binary)), views_(std::move(views)), accessors_(std::move(accessors)) {}

    // Free places that nothing took get the least that there can be: what is behind them keeps its place.
    void fill_places();
    // Each as JSON; empty: as the document has it.
    const Vector<String>& views() const { return views_.texts; }
    const Vector<String>& accessors() const { return accessors_.texts; }
    const String& binary() const { return binary_; }

    // Values of `components` floats each; returns the buffer view's index.
    size_t add_view(std::span<const float> values, uint32_t components);
    size_t add_view(std::span<const uint32_t> indices);
    // In 16 bits where all of them are below 65535. Returns the accessor's index.
    size_t add_indices(std::span<const uint32_t> indices);
    // Four 16-bit numbers each.
    size_t add_view(std::span<const uint16_t> fours);
    // Four bytes each.
    size_t add_view(std::span<const uint8_t> fours);
    // Floats that are no vertices': keys of animations, matrices.
    size_t add_plain_view(std::span<const float> values);
    // A file of its own, such as a picture.
    size_t add_file(std::span<const uint8_t> bytes);
    // Four floats each, clamped to 0..1, as COLOR_0 asks for.
    size_t add_colors(Vector<float> colors);

    size_t add_accessor(size_t view, size_t byte_offset, size_t count, uint32_t component_type, const char* type,
                        const String& bounds = "");
    // Numbers with their least and largest, as times must be.
    size_t add_times(std::span<const float> times);
    // How vertices move, three floats each: sparse where that is smaller. Returns the accessor's index.
    size_t add_moves(std::span<const float> moves, bool with_bounds);
    // Points first .. first + count - 1 of a view of positions.
    size_t add_positions(size_t view, std::span<const float> positions, size_t first, size_t count,
                         const String& further = "");

    // `rest` is what follows the mode, such as `,"indices":3`.
    void add_primitive(const String& attributes, int mode, const String& rest);

    // The primitives since the last become a mesh; returns its index. `rest` is what follows them, such as
    // `,"weights":[0]`.
    size_t end_mesh(const String& rest = "");

    // `materials` is empty or ends with a comma. The mesh's node is at the origin.
    String finish(const String& materials, const Origin& origin) const;
    // The same, with nodes that show the meshes that were ended, or else mesh 0 of all primitives, if there are any:
    // `top` is JSON from `"scene":` on, and ends with a comma.
    String finish_scene(const String& top, const String& mesh_name) const;

private:
    size_t add_bytes(const void* data, size_t size, uint32_t target, const String& rest);

    struct List {
        List() = default;
        explicit List(Places places) : texts(places.count), free(std::move(places.free)) {}
        // Returns its index.
        size_t add(String text);
        void fill(const char* text);
        String joined() const;

        Vector<String> texts;
        Vector<size_t> free;
        size_t taken = 0;  // of those
    };

    String binary_;
    List views_, accessors_;
    String primitives_, meshes_;
    size_t mesh_count_ = 0;
};

}  // namespace flg::io
