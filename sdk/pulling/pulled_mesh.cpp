// SPDX-License-Identifier: MIT
#include "pulling/pulled_mesh.h"

#include <algorithm>

#include "runtime/each.h"

namespace flg {

void HeldPulled::show() noexcept {
    view_ = {.struct_size = sizeof view_,
             .vertex_count = pull->vertex_count,
             .positions = positions.data(),
             .energy = state.energy,
             .origin = {}};
    write_origin(pull->origin, view_.origin);
}

Task<void> make_pull(Pace& pace, std::shared_ptr<HeldPull> pull) {
    const FlgMeshView& input = pull->mesh->view;
    co_await repair_mesh(pace, input, pull->repair, pull->repaired);
    const float* positions = nullptr;
    for (const FlgColumn& column : pull->mesh->columns)
        if (column.attribute == FLG_ATTRIBUTE_POSITION) positions = column.data;
    pull->rest.reserve(size_t{3} * input.vertex_count);
    co_await each(pace, size_t{3} * input.vertex_count, Cost::some_ns,
                  [&](uint32_t i) { pull->rest.push_back(positions[i]); });
    pull->system = co_await make_pull_system(pace, pull->repaired.mesh);
    pull->mesh = nullptr;
}

Task<void> make_pulled(Pace& pace, std::shared_ptr<HeldPulled> pulled) {
    const HeldPull& pull = *pulled->pull;
    Memory* const memory = pace.memory();
    const uint32_t vertices = pull.vertex_count;
    const float* const pose = pulled->pose.empty() ? pull.rest.data() : pulled->pose.data();
    // Of welded vertices the first one's position counts.
    Buffer<float> rest(size_t{3} * pull.repaired.mesh.vertex_count(), memory);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t step) {
        const uint32_t v = vertices - 1 - step, welded = pull.welded(v);
        if (welded != no_index) std::copy_n(pose + size_t{3} * v, 3, rest.data() + size_t{3} * welded);
    });
    // Vertices that a repair split stand where the first copy does.
    const GrowingBuffer<uint32_t>& sources = pull.repaired.vertices.to_input;
    co_await each(pace, sources.size(), Cost::some_ns,
                  [&](uint32_t v) { std::copy_n(pose + size_t{3} * sources[v], 3, rest.data() + size_t{3} * v); });

    std::pmr::vector<PullHandle> handles(memory);
    for (uint32_t h = 0; h < pulled->handles.size(); ++h) {
        const FlgPullHandle& from = pulled->handles[h];
        PullHandle handle;
        handle.at = load_vec3(from.position);
        handle.compliance = static_cast<double>(from.compliance);
        handle.radius = static_cast<double>(from.radius);
        double sum = 0;
        for (const float share : from.shares) sum += static_cast<double>(share);
        for (uint32_t c = 0; c < 3; ++c) {
            if (from.vertices[c] >= vertices)
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "desc.handles[%u].vertices[%u] is vertex %u, but there are %u vertices", h, c,
                              from.vertices[c], vertices);
            handle.vertices[c] = pull.welded(from.vertices[c]);
            handle.shares[c] = static_cast<double>(from.shares[c]) / sum;
            if (handle.vertices[c] == no_index)
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.handles[%u].vertices[%u] is vertex %u, of no triangle",
                              h, c, from.vertices[c]);
        }
        // What has no share may be any vertex; so the same point is held the same.
        const auto most =
            static_cast<size_t>(std::max_element(handle.shares.begin(), handle.shares.end()) - handle.shares.begin());
        for (uint32_t c = 0; c < 3; ++c)
            if (handle.shares[c] == 0) handle.vertices[c] = handle.vertices[most];
        const bool is_first = std::none_of(handles.begin(), handles.end(),
                                           [&](const PullHandle& other) { return other.holds_as(handle); });
        if (is_first) handles.push_back(handle);
        co_await pace;
    }
    const PulledState* const previous = pulled->previous ? &pulled->previous->state : nullptr;
    co_await flg::pull(pace, pull.system, {rest.data(), rest.size()}, handles, previous, pulled->rounds, pulled->state);

    pulled->positions = Buffer<float>(size_t{3} * vertices, memory);
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
        const uint32_t welded = pull.welded(v);
        for (uint32_t k = 0; k < 3; ++k) {
            const size_t i = size_t{3} * v + k;
            const double moved =
                welded == no_index ? 0 : pulled->state.moved[size_t{4} * pull.system.place_of[welded] + k];
            pulled->positions[i] = static_cast<float>(static_cast<double>(pose[i]) + moved);
        }
    });
    pulled->pose = {};
    pulled->previous = nullptr;
}

}  // namespace flg
