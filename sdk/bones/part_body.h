// SPDX-License-Identifier: MIT
// Bodies of parts: inflated, and their surfaces as hosts hold them.
#pragma once

#include "bones/part.h"
#include "inflation/inflate_part.h"

namespace flg {

class HeldPartMesh final : public Product {
public:
    explicit HeldPartMesh(Memory* memory) : positions_(memory) {}

    std::shared_ptr<const HeldPart> part;
    InflationOptions options;
    PartSurface surface;

    // The surface as hosts see it, vertex by vertex.
    void show_vertex(const Vec3& at);
    const float* positions() const { return positions_.data(); }
    const FlgPartMeshView& view() const { return view_; }

private:
    void show() noexcept override;

    std::pmr::vector<float> positions_;
    FlgPartMeshView view_{};
};

// A part with its body, moved and scaled so that coordinates are around 1, whatever they are in the drawing: (x, y)
// there is (x, y) * scale + origin in the drawing.
struct PartBody {
    explicit PartBody(Memory* memory) : inflated(memory) {}

    InflatedPart inflated;
    Point2 origin{};
    double scale = 1;
};

// Makes the body. Where the even line crosses itself (which an outline never does) it is the outline's body.
// `out` outlives the task.
Task<void> inflate(Pace& pace, const HeldPart& part, InflationOptions options, PartBody& out);

// The whole of flgPartMeshCreate.
Task<void> make_part_mesh(Pace& pace, std::shared_ptr<HeldPartMesh> mesh);

}  // namespace flg
