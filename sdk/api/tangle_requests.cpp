// SPDX-License-Identifier: MIT
#include "api/tangle_requests.h"

#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"

namespace flg {

namespace {

constexpr uint32_t max_cycle = 65536;

bool is_positive(float value) {
    return value > 0 && std::isfinite(value);
}

TangleSeeds read_seeds(const FlgTangleSeeds* given, uint64_t seed, const char* name, Memory* memory) {
    if (!given) return TangleSeeds(memory);
    const FlgTangleSeeds from = read_struct(given, sized<FlgTangleSeeds>(), name);
    char argument[32];
    const auto member = [&](const char* member_name) {
        std::snprintf(argument, sizeof argument, "%s.%s", name, member_name);
        return argument;
    };
    TangleSeeds seeds(memory);
    check_enum(from.borders, FLG_TANGLE_BORDERS_NONE, FLG_TANGLE_BORDERS_EACH, member("borders"),
               "FLG_TANGLE_BORDERS_");
    seeds.borders = from.borders;
    if (from.stretch_count > 0) require(from.stretches, member("stretches"));
    for (uint32_t i = 0; i < from.stretch_count; ++i) {
        const FlgBorderStretch& stretch = from.stretches[i];
        const bool holds =
            stretch.begin >= 0 && stretch.begin < 1 && stretch.end > stretch.begin && stretch.end <= stretch.begin + 1;
        if (!holds) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "%s[%u] is from %g to %g, must begin in [0, 1) and end within 1 beyond", member("stretches"),
                          i, double{stretch.begin}, double{stretch.end});
        }
        seeds.stretches.push_back({stretch.loop, stretch.begin, stretch.end});
    }
    seeds.points = read_points(from.points, from.point_count, member("points"), memory);
    check_range(from.sample_radius == 0 || is_positive(from.sample_radius), member("sample_radius"), from.sample_radius,
                "0 or finite and above 0");
    check_range(from.border_spacing == 0 || is_positive(from.border_spacing), member("border_spacing"),
                from.border_spacing, "0 or finite and above 0");
    seeds.sample_radius = from.sample_radius;
    seeds.sample_count = from.sample_count;
    seeds.border_spacing = from.border_spacing;
    seeds.seed = seed;
    seeds.regions = read_region_ids(from.regions, from.region_count, member("regions"), memory);
    return seeds;
}

void check_divide(const FlgTangleDivideDesc& desc) {
    check_enum(desc.kind, FLG_TANGLE_OPERATOR_CONTOUR, FLG_TANGLE_OPERATOR_POLYLINE, "desc.kind", "FLG_TANGLE_");
    check_enum(desc.grouping, FLG_TANGLE_GROUPING_TWO, FLG_TANGLE_GROUPING_CYCLE, "desc.grouping", "FLG_TANGLE_GROUP_");
    check_range(desc.region_count >= 1, "desc.region_count", desc.region_count, "at least 1");
    check_range(desc.count <= 256, "desc.count", desc.count, "at most 256");
    check_range(is_positive(desc.delta), "desc.delta", desc.delta, "finite and above 0");
    check_range(desc.cycle >= 1 && desc.cycle <= max_cycle, "desc.cycle", desc.cycle, "1 to 65536");
    check_range(desc.perturbation >= 0 && std::isfinite(desc.perturbation), "desc.perturbation", desc.perturbation,
                "finite and at least 0");
    check_range(is_positive(desc.frequency), "desc.frequency", desc.frequency, "finite and above 0");
}

// What a history keeps of a descriptor: neither whose step it is nor what it points to.
template <class Desc>
Desc numbers_of(Desc desc) {
    desc.tangle = {};
    desc.job = nullptr;
    desc.regions = nullptr;
    desc.region_count = 0;
    return desc;
}

}  // namespace

FlgTangleDivideDesc default_divide_desc() {
    auto desc = sized<FlgTangleDivideDesc>();
    desc.count = 1;
    desc.delta = 0.1f;
    desc.cycle = 3;
    desc.frequency = 1;
    desc.seed = 1;
    return desc;
}

FlgTangleDisplaceDesc default_displace_desc() {
    auto desc = sized<FlgTangleDisplaceDesc>();
    desc.amount = 0.1f;
    desc.bias = desc.gain = 0.5f;
    return desc;
}

FlgTangleApplyMacroDesc default_macro_desc() {
    auto desc = sized<FlgTangleApplyMacroDesc>();
    desc.count = 4;
    desc.size = 0.1f;
    desc.spacing = 0.3f;
    desc.seed = 1;
    desc.border = FLG_NO_INDEX;
    return desc;
}

std::pmr::vector<RegionId> read_region_ids(const uint32_t* regions, uint32_t count, const char* argument,
                                           Memory* memory) {
    std::pmr::vector<RegionId> list(memory);
    if (count > 0) list.assign(&require(regions, argument), regions + count);
    return list;
}

DivideRequest read_divide(const FlgTangleDivideDesc& desc, Memory* memory) {
    check_divide(desc);
    DivideRequest request(memory);
    request.desc = numbers_of(desc);
    request.desc.a = request.desc.b = nullptr;
    request.regions = read_region_ids(desc.regions, desc.region_count, "desc.regions", memory);
    request.a = read_seeds(desc.a, desc.seed, "desc.a", memory);
    request.b = read_seeds(desc.b, desc.seed, "desc.b", memory);
    return request;
}

void check_seeds_of(const DivideRequest& request) {
    const TangleSeeds& a = request.a;
    if (a.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.a is empty, the operator has nothing to begin at");
    if (request.desc.kind == FLG_TANGLE_OPERATOR_POLYLINE &&
        (a.points.size() == 1 || (a.points.empty() && !a.curves))) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.a.point_count is %zu, a polyline needs 2 points at least, or curves and none",
                      a.points.size());
    }
    const bool has_cells = !a.points.empty() || a.sample_radius > 0 || a.border_spacing > 0;
    if (request.desc.kind == FLG_TANGLE_OPERATOR_VORONOI && !has_cells) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.a has neither points nor samples for cells to form around");
    }
    if (request.desc.kind == FLG_TANGLE_OPERATOR_CONTOUR && !request.b.empty() && !(request.desc.delta < 1)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.delta is %g, of a blended field it must be below 1",
                      double{request.desc.delta});
    }
}

MacroRequest read_macro(const FlgTangleApplyMacroDesc& desc, Memory* memory) {
    check_enum(desc.kind, FLG_TANGLE_MACRO_SUNBURST, FLG_TANGLE_MACRO_CELLS, "desc.kind", "FLG_TANGLE_");
    check_range(desc.region_count >= 1, "desc.region_count", desc.region_count, "at least 1");
    check_range(desc.count >= 1 && desc.count <= 256, "desc.count", desc.count, "1 to 256");
    check_range(is_positive(desc.size), "desc.size", desc.size, "finite and above 0");
    check_range(is_positive(desc.spacing), "desc.spacing", desc.spacing, "finite and above 0");
    MacroRequest macro(memory);
    macro.desc = numbers_of(desc);
    macro.regions = read_region_ids(desc.regions, desc.region_count, "desc.regions", memory);
    return macro;
}

DisplaceRequest read_displace(const FlgTangleDisplaceDesc& desc, Memory* memory) {
    check_range(desc.region_count >= 1, "desc.region_count", desc.region_count, "at least 1");
    check_range(std::isfinite(desc.amount), "desc.amount", desc.amount, "finite");
    check_range(desc.bias > 0 && desc.bias < 1, "desc.bias", desc.bias, "between 0 and 1");
    check_range(desc.gain > 0 && desc.gain < 1, "desc.gain", desc.gain, "between 0 and 1");
    check_range(desc.reach >= 0 && std::isfinite(desc.reach), "desc.reach", desc.reach, "finite and at least 0");
    DisplaceRequest request(memory);
    request.desc = numbers_of(desc);
    request.regions = read_region_ids(desc.regions, desc.region_count, "desc.regions", memory);
    return request;
}

}  // namespace flg
