// SPDX-License-Identifier: MIT
// The patch graph of a large style: its time, whether that depends on the size of a patch, and its memory.
#include "stylization/patch_graph.h"

#include <algorithm>
#include <array>

#include "bench/groups.h"
#include "bench/stage_inputs.h"
#include "runtime/run_now.h"

namespace flg::bench {
namespace {

constexpr uint32_t kPoints = 4096;
constexpr uint32_t kPatches[] = {1, 10, 100};
constexpr double kBarMs = 150.0, kPatchShareBar = 1.25, kMemoryGrowthBar = 2.2;
constexpr int kGraphRuns = 5;

// Passes on to the default resource, and remembers the most that was held.
class CountingMemory : public std::pmr::memory_resource {
public:
    size_t peak() const { return peak_; }

private:
    void* do_allocate(size_t size, size_t alignment) override {
        held_ += size;
        peak_ = std::max(peak_, held_);
        return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* memory, size_t size, size_t alignment) override {
        held_ -= size;
        std::pmr::new_delete_resource()->deallocate(memory, size, alignment);
    }
    bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

    size_t held_ = 0, peak_ = 0;
};

// What a style of this many points swings by: the braid, off the straight line of its axis.
Displacement swing(uint32_t count, Memory* memory) {
    const EvenStyle style = even_style("braid", count);
    Displacement displacement(count, memory);
    for (uint32_t i = 0; i < count; ++i) {
        displacement.along_tangent[i] = style.points[i].x() - i / (count - 1.0);
        displacement.along_normal[i] = style.points[i].y();
        displacement.along_binormal[i] = style.points[i].z();
    }
    return displacement;
}

double build_ms(const Displacement& displacement, uint32_t patch, Memory* memory) {
    const std::array<uint32_t, 2> boundaries = {0, displacement.size()};
    const StyleScene scene{&displacement, boundaries, patch};
    return time_ms([&] { run_now(memory, [&](Pace& pace) { return patch_graph(pace, scene); }); });
}

size_t peak_bytes(uint32_t count) {
    CountingMemory memory;
    const Displacement displacement = swing(count, std::pmr::new_delete_resource());
    build_ms(displacement, kPatches[1], &memory);
    return memory.peak();
}

}  // namespace

std::vector<Row> run_patch_graph() {
    Memory* memory = std::pmr::new_delete_resource();
    const Displacement displacement = swing(kPoints, memory);
    std::vector<double> times;
    std::string note;
    for (uint32_t patch : kPatches) {
        times.push_back(median_ms(kGraphRuns, [&] { return build_ms(displacement, patch, memory); }));
        char text[48];
        std::snprintf(text, sizeof text, "%sp = %u: %.1f ms", note.empty() ? "" : ", ", patch, times.back());
        note += text;
    }
    const auto [least, most] = std::minmax_element(times.begin(), times.end());
    const double growth = static_cast<double>(peak_bytes(kPoints)) / static_cast<double>(peak_bytes(kPoints / 2));
    char bytes[64];
    std::snprintf(bytes, sizeof bytes, "%.0f bytes a point", static_cast<double>(peak_bytes(kPoints)) / kPoints);
    return {below("patch graph 4096 points", *most, "ms", kBarMs, note),
            below("patch graph: slowest over fastest patch size", *most / *least, "x", kPatchShareBar),
            below("patch graph: memory when the style doubles", growth, "x", kMemoryGrowthBar, bytes)};
}

}  // namespace flg::bench
