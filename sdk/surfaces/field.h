// SPDX-License-Identifier: MIT
// A field on a surface as hosts hold it.
#pragma once

#include <deque>

#include "surfaces/surface.h"

namespace flg {

class Field final : public Product {
public:
    // For the surface as jobs started now will see it.
    explicit Field(std::shared_ptr<Surface> of_surface)
        : surface(std::move(of_surface)), revision(surface->order.revision()) {}

    std::shared_ptr<Surface> surface;
    uint32_t revision;
    DistanceField data;
    Buffer<uint32_t> samples;  // of a sampling: its vertices

    const FlgFieldView& view() const { return view_; }

private:
    void show() noexcept override {
        view_ = {.struct_size = sizeof view_,
                 .vertex_count = static_cast<uint32_t>(data.distances.size()),
                 .values = data.distances.data(),
                 .labels = data.labels.data(),
                 .samples = samples.data(),
                 .sample_count = static_cast<uint32_t>(samples.size()),
                 .revision = revision};
    }

    FlgFieldView view_{};
};

}  // namespace flg
