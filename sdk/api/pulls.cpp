// SPDX-License-Identifier: MIT
// Meshes that are pulled at: made, shown, released.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/mesh_inputs.h"
#include "pulling/handle_keys.h"
#include "pulling/pulled_mesh.h"

namespace flg {

namespace {

constexpr uint32_t most_vertices = 1u << 20, most_rounds = 1000;
constexpr float share_error = 0.001f;

FlgPulledDesc default_pulled_desc() {
    auto desc = sized<FlgPulledDesc>();
    desc.rounds = 2;
    return desc;
}

FlgPullHandle default_handle() {
    auto handle = sized<FlgPullHandle>();
    handle.shares[0] = 1;
    handle.radius = -1;
    return handle;
}

void check_handle(const FlgPullHandle& handle, uint32_t number) {
    char field[64];
    const auto check = [&](bool holds, const char* member, float value, const char* rule) {
        std::snprintf(field, sizeof field, "desc.handles[%u].%s", number, member);
        check_range(holds, field, value, rule);
    };
    float sum = 0;
    for (const float share : handle.shares) {
        check(share >= 0 && share <= 1, "shares", share, "0 to 1");
        sum += share;
    }
    check(std::abs(sum - 1) <= share_error, "shares", sum, "a sum of 1");
    for (const float value : handle.position)
        check(is_coordinate(value), "position", value, "finite and at most 1e30 in size");
    check(handle.compliance >= 0 && std::isfinite(handle.compliance), "compliance", handle.compliance,
          "0, or above and finite");
    check(std::isfinite(handle.radius), "radius", handle.radius, "finite");
}

void check_keys(const FlgPullKeys& keys) {
    check_range(keys.handle_count >= 1 && keys.handle_count <= FLG_PULL_MAX_HANDLES, "keys.handle_count",
                keys.handle_count, "1 to 256");
    require(keys.offsets, "keys.offsets");
    check_range(keys.offsets[0] == 0, "keys.offsets[0]", keys.offsets[0], "0");
    for (uint32_t h = 0; h < keys.handle_count; ++h) {
        if (keys.offsets[h + 1] > keys.offsets[h]) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "keys.offsets[%u] is %u after %u: handle %u needs a key", h + 1,
                      keys.offsets[h + 1], keys.offsets[h], h);
    }
    require(keys.times, "keys.times");
    require(keys.positions, "keys.positions");
    for (uint32_t h = 0; h < keys.handle_count; ++h) {
        for (uint32_t key = keys.offsets[h]; key < keys.offsets[h + 1]; ++key) {
            const bool rises = key == keys.offsets[h] || keys.times[key] > keys.times[key - 1];
            if (!std::isfinite(keys.times[key]) || !rises)
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "keys.times[%u] is %g, must be finite and after the one before of its handle", key,
                              keys.times[key]);
            for (size_t i = 3 * size_t{key}; i < 3 * size_t{key} + 3; ++i) {
                if (is_coordinate(keys.positions[i])) continue;
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "keys.positions[%zu] is %g, must be finite and at most 1e30 in size", i,
                              double{keys.positions[i]});
            }
        }
    }
}

// Exact handles of one point can't hold it in two places.
void check_apart(std::span<const FlgPullHandle> handles, const FlgPullHandle& handle) {
    if (handle.compliance > 0) return;
    const auto is_other = [&](const FlgPullHandle& other) {
        return other.compliance == 0 && std::equal(other.vertices, other.vertices + 3, handle.vertices) &&
               std::equal(other.shares, other.shares + 3, handle.shares) &&
               !std::equal(other.position, other.position + 3, handle.position);
    };
    const auto found = std::find_if(handles.begin(), handles.end(), is_other);
    if (found == handles.end()) return;
    throw Failure(
        FLG_ERROR_INVALID_ARGUMENT,
        "desc.handles[%zu] and desc.handles[%zu] hold one point in two places: leave one of them, or give one "
        "a compliance above 0",
        static_cast<size_t>(found - handles.begin()), handles.size());
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgPullDescInit(FlgPullDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgPullDesc>());
}

FlgResult flgPullCreate(FlgContext context, const FlgPullDesc* desc, FlgPull* out_pull, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_pull, "out_pull", out_job);
        const FlgPullDesc read = read_struct(desc, sized<FlgPullDesc>(), "desc");
        check_range(std::isfinite(read.weld_distance), "desc.weld_distance", read.weld_distance, "finite");
        const FlgMeshView mesh = read_struct(read.mesh, sized<FlgMeshView>(), "desc.mesh");
        if (mesh.vertex_count > most_vertices)
            throw Failure(FLG_ERROR_LIMIT, "desc.mesh.vertex_count is %u, more than the limit of %u", mesh.vertex_count,
                          most_vertices);
        Submission submission(self, read.job);
        const auto out = self.make(self.pulls);
        out->vertex_count = mesh.vertex_count;
        out->mesh = copy_described_mesh(self.memory[MemoryKind::models], mesh);
        out->origin = read_origin(mesh.origin, "desc.mesh.origin");
        if (read.weld_distance >= 0) out->repair.weld_distance = read.weld_distance;
        submission.job().strand.start(make_pull(submission.pace(), out));
        *out_pull = {submission.commit(self.pulls, out, out_job)};
    });
}

FlgResult flgPullRelease(FlgContext context, FlgPull pull) {
    return release(context, &Context::pulls, pull, "pull");
}

FlgResult flgPullHandleInit(FlgPullHandle* handle, uint32_t struct_size) {
    return init(handle, struct_size, default_handle(), "handle");
}

FlgResult flgPulledDescInit(FlgPulledDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_pulled_desc());
}

FlgResult flgPulledCreate(FlgContext context, const FlgPulledDesc* desc, FlgPulled* out_pulled, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_pulled, "out_pulled", out_job);
        const FlgPulledDesc read = read_struct(desc, default_pulled_desc(), "desc");
        check_range(read.rounds >= 1 && read.rounds <= most_rounds, "desc.rounds", read.rounds, "1 to 1000");
        check_range(read.handle_count <= FLG_PULL_MAX_HANDLES, "desc.handle_count", read.handle_count, "at most 256");
        if (read.handle_count > 0) require(read.handles, "desc.handles");
        const auto out = self.make(self.pulled);
        const std::shared_ptr<HeldPull>& pull = self.pulls.get(read.pull.id, "desc.pull");
        out->pull = pull;
        out->rounds = read.rounds;
        Submission submission(self, read.job);
        submission.read(*pull, "desc.pull");
        for (uint32_t h = 0; h < read.handle_count; ++h) {
            char place[32];
            std::snprintf(place, sizeof place, "desc.handles[%u]", h);
            const FlgPullHandle handle = read_element(read.handles, h, default_handle(), place);
            check_handle(handle, h);
            check_apart(out->handles, handle);
            out->handles.push_back(handle);
        }
        if (read.positions) {
            const size_t count = pull->rest_count();
            out->pose = Buffer<float>(count, self.memory[MemoryKind::models]);
            for (size_t i = 0; i < count; ++i) {
                check_range(is_coordinate(read.positions[i]), "desc.positions", read.positions[i],
                            "finite and at most 1e30 in size");
                out->pose[i] = read.positions[i];
            }
        }
        if (read.previous.id != 0) {
            const std::shared_ptr<HeldPulled>& previous = self.pulled.get(read.previous.id, "desc.previous");
            if (previous->pull != pull)
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.previous belongs to another pull");
            out->previous = previous;
            submission.read(*previous, "desc.previous");
        }
        submission.job().strand.start(make_pulled(submission.pace(), out));
        *out_pulled = {submission.commit(self.pulled, out, out_job)};
    });
}

FlgResult flgPulledViewInit(FlgPulledView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgPulledGetView(FlgContext context, FlgPulled pulled, FlgPulledView* out_view) {
    return get_view(out_view, [&] { return get_context(context).pulled.get(pulled.id, "pulled"); });
}

FlgResult flgPulledRelease(FlgContext context, FlgPulled pulled) {
    return release(context, &Context::pulled, pulled, "pulled");
}

FlgResult flgPullKeysInit(FlgPullKeys* keys, uint32_t struct_size) {
    return init(keys, struct_size, sized<FlgPullKeys>(), "keys");
}

FlgResult flgPullKeysSample(const FlgPullKeys* keys, double time, float* out_positions) {
    return guarded([&] {
        const FlgPullKeys read = read_struct(keys, sized<FlgPullKeys>(), "keys");
        check_keys(read);
        check_range(std::isfinite(time), "time", time, "finite");
        require(out_positions, "out_positions");
        for (uint32_t h = 0; h < read.handle_count; ++h) {
            const uint32_t first = read.offsets[h], count = read.offsets[h + 1] - first;
            const std::array<float, 3> at =
                handle_at({read.times + first, count}, read.positions + 3 * size_t{first}, time);
            std::copy(at.begin(), at.end(), out_positions + 3 * size_t{h});
        }
    });
}

}  // extern "C"
