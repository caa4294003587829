// SPDX-License-Identifier: MIT
#include "stylization/style_file_checks.h"

#include <cmath>
#include <vector>

#include "core/failure.h"
#include "stylization/prepare_style.h"

namespace flg {

namespace {

constexpr uint32_t patch_max = 1024;
constexpr uint32_t successors_bound = PatchGraphKernel::successors_kept;
// Coordinates of curve sets are at most 1e30; displacements are differences of them.
constexpr double coordinate_max = 1e30;
constexpr double displacement_max = 1e31;
constexpr double unit_tolerance = 1e-3;

[[noreturn]] void refuse(const char* what) {
    throw Failure(FLG_ERROR_FORMAT, "data holds no usable style: %s", what);
}

void require_that(bool holds, const char* what) {
    if (!holds) refuse(what);
}

template <class Values>
bool all_at_most(const Values& values, double bound) {
    for (const auto value : values) {
        if (!(std::abs(static_cast<double>(value)) <= bound)) return false;
    }
    return true;
}

bool all_units(const Buffer<float>& vectors) {
    for (size_t i = 0; i < vectors.size(); i += 3) {
        if (!(std::abs(load_vec3(vectors.data() + i).norm() - 1) <= unit_tolerance)) return false;
    }
    return true;
}

uint32_t components_of(FlgAttribute attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_COLOR: return 4;
        case FLG_ATTRIBUTE_RADII: return 3;
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_ANGLE:
        case FLG_ATTRIBUTE_WIDTH:
        case FLG_ATTRIBUTE_SPEED: return 1;
        default: return 0;
    }
}

bool finite_and_not_below(double value, double least) {
    return std::isfinite(value) && value >= least;
}

// What a node is to the graph.
enum class Role : uint8_t { none, centre, last_centre };

}  // namespace

void check_counts(const StyleCounts& counts) {
    require_that(counts.curves >= 1 && counts.curves <= style_curves_max, "its number of curves is out of range");
    require_that(counts.nodes >= 2 * counts.curves && counts.nodes <= style_points_max,
                 "its number of points is out of range");
    require_that(counts.patch >= 1 && counts.patch <= patch_max, "its patch size is out of range");
    require_that(counts.jumps <= counts.nodes * (successors_bound + counts.curves), "it has too many jumps");
    require_that(counts.attributes <= style_attributes_max, "it has too many attributes");
}

void check_offsets(const Buffer<uint32_t>& offsets, uint32_t nodes) {
    bool good = offsets[0] == 0 && offsets[offsets.size() - 1] == nodes;
    for (size_t c = 0; good && c + 1 < offsets.size(); ++c) {
        good = offsets[c] <= nodes && offsets[c + 1] <= nodes && offsets[c + 1] >= offsets[c] + 2;
    }
    require_that(good, "its curves do not follow one another");
}

void check_values(const PreparedStyle& style) {
    require_that(std::isfinite(style.guide_length) && style.guide_length > 0, "its guide has no length");
    require_that(std::isfinite(style.style_length) && style.style_length > 0, "its style curve has no length");
    require_that(finite_and_not_below(style.displacement_rms, 0) && finite_and_not_below(style.matching_energy, 0),
                 "its displacement or energy is no size");
    require_that(finite_and_not_below(style.graph.temperature_unit, 0), "its temperature unit is no size");
    const auto& columns = style.guide->columns();
    require_that(all_at_most(columns[0].values, coordinate_max), "a position is out of range");
    require_that(all_units(columns[1].values) && all_units(columns[2].values), "a frame is not of unit vectors");
    const Displacement& d = style.displacement;
    require_that(all_at_most(d.along_tangent, displacement_max) && all_at_most(d.along_normal, displacement_max) &&
                     all_at_most(d.along_binormal, displacement_max),
                 "a displacement is out of range");
    const Buffer<uint32_t>& offsets = style.guide->offsets();
    for (uint32_t c = 0; c < style.guide->curve_count(); ++c) {
        double before = 0;
        for (uint32_t i = offsets[c]; i < offsets[c + 1]; ++i) {
            require_that(finite_and_not_below(style.matching[i], before), "its matching runs backwards");
            before = style.matching[i];
        }
    }
}

void check_attribute(const PreparedStyle& style, size_t index) {
    const StyleAttribute& attribute = style.attributes[index];
    const FlgAttribute kind = attribute.attribute;
    const uint32_t components = components_of(kind);
    require_that(attribute.components >= 1 && attribute.components <= attribute_components_max &&
                     (components == 0 || attribute.components == components),
                 "an attribute has a wrong number of components");
    require_that(metric_fits(kind, attribute.components, attribute.metric), "an attribute's metric does not fit it");
    require_that(finite_and_not_below(attribute.weight, 0), "an attribute's weight is out of range");
    for (size_t before = 0; before < index; ++before) {
        require_that(style.attributes[before].attribute != kind, "an attribute occurs twice");
    }
    for (size_t i = 0; i < attribute.values.size(); ++i) {
        const float value = attribute.values[i];
        const bool size = kind == FLG_ATTRIBUTE_RADIUS || kind == FLG_ATTRIBUTE_WIDTH ||
                          (kind == FLG_ATTRIBUTE_RADII && i % attribute.components < 2);
        require_that(std::isfinite(value) && (!size || value >= 0) && (kind != FLG_ATTRIBUTE_SPEED || value > 0),
                     "an attribute's value is out of range");
    }
}

void complete_graph(PatchGraph& graph, const Buffer<uint32_t>& offsets, Memory* memory) {
    const uint32_t nodes = graph.node_count;
    const StyleScene scene{.displacement = nullptr,
                           .boundaries = {offsets.data(), offsets.size()},
                           .patch = graph.patch,
                           .sizes = {},
                           .channels = {}};
    std::pmr::vector<Role> roles(nodes, Role::none, memory);
    uint32_t last_centres = 0, destinations = 0;
    for (uint32_t c = 0; c < scene.curve_count(); ++c) {
        const uint32_t first = scene.first_patch(c), end = scene.end_patch(c);
        if (end == first) continue;
        for (uint32_t i = first; i < end; ++i) roles[i] = Role::centre;
        roles[end - 1] = Role::last_centre;
        ++last_centres;
        destinations += end - first - 1;
    }
    require_that(destinations > 0, "no curve is long enough for its patch size");
    graph.curve_end = Buffer<uint32_t>(nodes, memory);
    graph.destinations = Buffer<uint16_t>(destinations, memory);
    destinations = 0;
    require_that(graph.in_begin[0] == 0 && graph.in_begin[nodes] == graph.jump_count(), "its jumps are not in order");
    for (uint32_t c = 0, j = 0; j < nodes; ++j) {
        if (j == offsets[c + 1]) ++c;
        graph.curve_end[j] = offsets[c + 1];
        const uint32_t begin = graph.in_begin[j], end = graph.in_begin[j + 1];
        require_that(begin <= end && end <= graph.jump_count(), "its jumps are not in order");
        const bool destination = j > scene.first_patch(c) && j < scene.end_patch(c);
        if (destination) graph.destinations[destinations++] = static_cast<uint16_t>(j);
        uint32_t from_last = 0;
        for (uint32_t k = begin; k < end; ++k) {
            const uint32_t source = graph.in_source[k];
            require_that(destination && source < nodes && roles[source] != Role::none && source + 1 != j &&
                             (k == begin || source > graph.in_source[k - 1]),
                         "a jump leads where none may");
            require_that(graph.in_cost[k] >= 0 && graph.in_cost[k] <= PatchGraph::cost_max,
                         "a jump's cost is out of range");
            if (roles[source] == Role::last_centre) ++from_last;
        }
        require_that(!destination || from_last == last_centres, "a destination is out of reach");
    }
}

}  // namespace flg
