// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "stylization/prepare_style.h"
#include "stylization/style_file.h"

namespace flg {

namespace {

constexpr uint32_t min_points = 16;
constexpr uint32_t max_patch = 1024;

FlgStyleDesc default_style_desc() {
    auto desc = sized<FlgStyleDesc>();
    desc.alpha = 0.5f;
    desc.smoothing = 1;
    desc.beta = 0.2f;
    desc.patch = 10;
    return desc;
}

void check(const FlgStyleDesc& desc) {
    check_range(desc.point_count == 0 || (desc.point_count >= min_points && desc.point_count <= style_points_max),
                "desc.point_count", desc.point_count, "0 or 16 to 16384");
    check_range(desc.alpha >= 0 && desc.alpha <= 1, "desc.alpha", desc.alpha, "0 to 1");
    check_range(desc.smoothing > 0 && std::isfinite(desc.smoothing), "desc.smoothing", desc.smoothing,
                "finite and above 0");
    check_range(desc.beta > 0 && desc.beta < 1, "desc.beta", desc.beta, "above 0 and below 1");
    check_range(desc.patch >= 1 && desc.patch <= max_patch, "desc.patch", desc.patch, "1 to 1024");
    check_range(std::isfinite(desc.start_cap), "desc.start_cap", desc.start_cap, "finite");
    check_range(std::isfinite(desc.end_cap), "desc.end_cap", desc.end_cap, "finite");
}

void check_patch_size(const FlgPatchSize& size, uint32_t index) {
    if (size.patch < 1 || size.patch > max_patch) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.patch_sizes[%u].patch is %u, must be 1 to %u", index,
                      size.patch, max_patch);
    }
    if (!(size.weight > 0 && std::isfinite(size.weight))) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.patch_sizes[%u].weight is %g, must be finite and above 0",
                      index, static_cast<double>(size.weight));
    }
}

void check_attribute(const FlgStyleAttribute& wanted, uint32_t index) {
    const int32_t attribute = number_of(wanted.attribute);
    if (!can_transfer(attribute)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.attributes[%u].attribute is %d, must be RADIUS, COLOR, RADII, ANGLE, WIDTH, SPEED or USER "
                      "and above",
                      index, attribute);
    }
    char argument[48];
    std::snprintf(argument, sizeof argument, "desc.attributes[%u].metric", index);
    check_enum(wanted.metric, FLG_METRIC_AUTO, FLG_METRIC_PROJECTIVE, argument, "FLG_METRIC_");
    const bool circular = wanted.metric == FLG_METRIC_CIRCLE || wanted.metric == FLG_METRIC_PROJECTIVE;
    if (circular && !metric_fits(wanted.attribute, 1, wanted.metric)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %d, which is for angles: ANGLE, RADII and USER columns",
                      argument, number_of(wanted.metric));
    }
    if (!(wanted.weight >= 0 && std::isfinite(wanted.weight))) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.attributes[%u].weight is %g, must be finite and >= 0", index,
                      static_cast<double>(wanted.weight));
    }
}

// The descriptor's arrays, checked and copied.
void read_arrays(const FlgStyleDesc& desc, StyleRequest& request) {
    check_range(desc.patch_size_count <= patch_sizes_max, "desc.patch_size_count", desc.patch_size_count, "at most 8");
    if (desc.patch_size_count > 0) require(desc.patch_sizes, "desc.patch_sizes");
    for (uint32_t k = 0; k < desc.patch_size_count; ++k) {
        check_patch_size(desc.patch_sizes[k], k);
        request.patch_sizes[k] = desc.patch_sizes[k];
    }
    check_range(desc.attribute_count <= style_attributes_max, "desc.attribute_count", desc.attribute_count,
                "at most 8");
    if (desc.attribute_count > 0) require(desc.attributes, "desc.attributes");
    for (uint32_t k = 0; k < desc.attribute_count; ++k) {
        check_attribute(desc.attributes[k], k);
        request.attributes[k] = desc.attributes[k];
        for (uint32_t before = 0; before < k; ++before) {
            if (desc.attributes[before].attribute != desc.attributes[k].attribute) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.attributes[%u].attribute is %d, as is that of %u", k,
                          number_of(desc.attributes[k].attribute), before);
        }
    }
    check_range(desc.point_count == 0 || 2 * request.largest_patch() + 1 < desc.point_count,
                desc.patch_size_count > 0 ? "the largest patch in desc.patch_sizes" : "desc.patch",
                request.largest_patch(), "so small that its 2p + 1 points are fewer than point_count");
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgStyleDescInit(FlgStyleDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_style_desc());
}

FlgResult flgStyleCreate(FlgContext context, const FlgStyleDesc* desc, FlgStyle* out_style, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_style, "out_style", out_job);
        Memory* const memory = self.memory[MemoryKind::styles];
        const FlgStyleDesc read = read_struct(desc, default_style_desc(), "desc");
        check(read);
        StyleRequest request{};
        request.desc = read;
        read_arrays(read, request);
        Submission submission(self, read.job);
        request.example = self.curve_sets.get(read.style.id, "desc.style");
        submission.read(*request.example, "desc.style");
        // If the curves are there already: else the job finds out.
        if (request.example->visible_result() == FLG_OK) {
            for (uint32_t k = 0; k < read.attribute_count; ++k) {
                check_attribute_column(*request.example, request.attributes[k], k);
            }
        }
        if (read.guide.id != 0) {
            request.guide = self.curve_sets.get(read.guide.id, "desc.guide");
            submission.read(*request.guide, "desc.guide");
        }
        request.style = make_object<Style>(memory, memory, self.memory[MemoryKind::caches]);
        const std::shared_ptr<Style> style = request.style;
        submission.job().strand.start(prepare_style(submission.pace(), std::move(request)));
        *out_style = {submission.commit(self.styles, style, out_job)};
    });
}

FlgResult flgStyleInfoInit(FlgStyleInfo* info, uint32_t struct_size) {
    return init(info, struct_size, sized<FlgStyleInfo>(), "info");
}

FlgResult flgStyleGetInfo(FlgContext context, FlgStyle style, FlgStyleInfo* out_info) {
    return show(
        out_info, "out_info", sized<FlgStyleInfo>(), [&] { return get_context(context).styles.get(style.id, "style"); },
        [](const Style& self) { return self.info(); });
}

FlgResult flgStyleGetGuide(FlgContext context, FlgStyle style, FlgCurveSet* out_guide) {
    return guarded([&] {
        require(out_guide, "out_guide") = {};
        Context& self = get_context(context);
        const std::shared_ptr<Style> found = self.styles.get(style.id, "style");
        const FlgResult result = visible_result_now(*found);
        if (result == FLG_OK) *out_guide = {self.curve_sets.add(found->prepared.guide)};
        return result;
    });
}

FlgResult flgStyleGetData(FlgContext context, FlgStyle style, void* out_data, size_t capacity, size_t* out_size) {
    return guarded([&] {
        require(out_size, "out_size") = 0;
        if (!out_data && capacity > 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "out_data is null, but capacity is %zu", capacity);
        }
        const std::shared_ptr<Style> self = get_context(context).styles.get(style.id, "style");
        const FlgResult result = visible_result_now(*self);
        if (result != FLG_OK) return result;
        const size_t size = style_file_size(self->prepared);
        *out_size = size;
        if (!out_data) return FLG_OK;
        if (capacity < size) throw Failure(FLG_ERROR_LIMIT, "capacity is %zu, the style has %zu bytes", capacity, size);
        write_style_file(self->prepared, {static_cast<std::byte*>(out_data), size});
        return FLG_OK;
    });
}

FlgResult flgStyleCreateFromData(FlgContext context, const void* data, size_t size, FlgStyle* out_style) {
    return guarded([&] {
        require(out_style, "out_style") = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::styles];
        if (!data) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "data is null");
        auto style = make_object<Style>(memory, memory, self.memory[MemoryKind::caches]);
        read_style_file({static_cast<const std::byte*>(data), size}, style->prepared, memory);
        style->publish_complete();
        *out_style = {self.styles.add(std::move(style))};
    });
}

FlgResult flgStyleRelease(FlgContext context, FlgStyle style) {
    return release(context, &Context::styles, style, "style");
}

}  // extern "C"
