// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.6.2.3 sparse accessors, 3.7.2.2 morph targets).
// Morph targets of one mesh, written: where few vertices move, only these.
#pragma once

#include <span>

#include "filigree/filigree_io.h"
#include "io/gltf/glb_builder.h"

namespace flg::io {

// Where vertices of one place are one, so that what turns there turns alike.
class WeldedPlaces {
public:
    WeldedPlaces(const float* positions, size_t vertex_count);
    size_t count() const { return count_; }
    uint32_t operator[](size_t vertex) const { return places_[vertex]; }

private:
    Vector<uint32_t> places_;
    size_t count_ = 0;
};

class MorphWriter {
public:
    // Vertex i that is written is vertex sources[i] of the mesh. All outlive this.
    MorphWriter(GlbBuilder& glb, std::span<const FlgMorphTarget> targets, const FlgSkinView& mesh,
                std::span<const uint32_t> sources)
        : glb_(glb), targets_(targets), mesh_(mesh), sources_(sources) {}

    // `,"targets":[...]` of all primitives; empty without targets.
    String add_targets();
    // `,"weights":[...],"extras":{...}` of the mesh, by the names of those targets; empty without targets.
    String mesh_members(std::span<const FlgMorphTarget> named) const;
    // A sampler of an animation.
    String add_sampler(const FlgMorphAnimation& animation);

private:
    Vector<float> written(const float* values) const;
    Vector<float> turned(const WeldedPlaces& places, const float* moves) const;

    GlbBuilder& glb_;
    std::span<const FlgMorphTarget> targets_;
    const FlgSkinView& mesh_;
    std::span<const uint32_t> sources_;
};

}  // namespace flg::io
