// SPDX-License-Identifier: MIT
// Curve sets: checked and copied at the door, shown, released, resampled, simplified.
#include <cmath>
#include <cstring>

#include "api/columns.h"
#include "api/descriptors.h"
#include "api/inputs.h"
#include "curves/sampling_job.h"
#include "curves/simplify.h"

namespace flg {

namespace {

void check_structure(const FlgCurveSetView& view) {
    if (view.curve_count == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.curve_count is 0, must be at least 1");
    const uint32_t* offsets = &require(view.curve_offsets, "view.curve_offsets");
    if (offsets[0] != 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets[0] is %u, must be 0", offsets[0]);
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        if (offsets[c + 1] <= offsets[c]) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "view.curve_offsets[%u] is %u after %u; every curve needs at least one point", c + 1,
                          offsets[c + 1], offsets[c]);
        }
        if (view.curve_flags && (view.curve_flags[c] & ~FLG_CURVE_CLOSED) != 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.curve_flags[%u] is %u, must be 0 or FLG_CURVE_CLOSED", c,
                          view.curve_flags[c]);
        }
    }
}

[[noreturn]] void refuse_value(const FlgCurveSetView& view, uint32_t column, const BadValue& bad) {
    uint32_t curve = 0;
    while (view.curve_offsets[curve + 1] <= bad.row) ++curve;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.columns[%u] holds %g at point %u of curve %u, %s", column,
                  static_cast<double>(bad.value), bad.row - view.curve_offsets[curve], curve, bad.rule);
}

// The columns in our order: POSITION first, the others as given.
std::pmr::vector<uint32_t> column_order(const FlgCurveSetView& view, Memory* memory) {
    std::pmr::vector<uint32_t> order(memory);
    for (uint32_t i = 0; i < view.column_count; ++i) {
        const bool first = view.columns[i].attribute == FLG_ATTRIBUTE_POSITION;
        order.insert(first ? order.begin() : order.end(), i);
    }
    return order;
}

FlgCurveSetSimplifyDesc default_simplify_desc() {
    auto desc = sized<FlgCurveSetSimplifyDesc>();
    desc.level_count = 1;
    desc.color_tolerance = 0.01f;
    return desc;
}

SimplifyInput read_simplify_input(const FlgCurveSetSimplifyDesc& desc, std::shared_ptr<const CurveSet> curves) {
    SimplifyInput input{std::move(curves), {}, desc.level_count, desc.color_tolerance, desc.ribbons != 0};
    for (uint32_t l = 0; l < desc.level_count; ++l) {
        char name[32];
        std::snprintf(name, sizeof name, "desc.tolerances[%u]", l);
        check_range(desc.tolerances[l] >= 0 && is_coordinate(desc.tolerances[l]), name, desc.tolerances[l],
                    "0 to 1e30");
        input.tolerances[l] = desc.tolerances[l];
    }
    return input;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgCurveSetViewInit(FlgCurveSetView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgCurveSetCreate(FlgContext context, const FlgCurveSetView* view, FlgCurveSet* out_set) {
    return guarded([&] {
        require(out_set, "out_set") = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::curves];
        const FlgCurveSetView read = read_struct(view, sized<FlgCurveSetView>(), "view");
        check_structure(read);
        check_columns(read.columns, read.column_count, "view");

        const auto set = make_object<CurveSet>(memory, memory);
        set->origin = read_origin(read.origin, "view.origin");
        set->allocate_curves(read.curve_count);
        std::memcpy(set->offsets().data(), read.curve_offsets, (size_t{read.curve_count} + 1) * sizeof(uint32_t));
        for (uint32_t c = 0; c < read.curve_count; ++c) set->begin_curve(c, read.curve_flags ? read.curve_flags[c] : 0);

        const auto order = column_order(read, memory);
        std::pmr::vector<CurveSet::ColumnLayout> layout(memory);
        for (uint32_t i : order) layout.push_back({read.columns[i].attribute, read.columns[i].components});
        set->allocate_columns(layout);
        for (size_t i = 0; i < order.size(); ++i) {
            const BadValue bad =
                copy_column(read.columns[order[i]], 0, set->point_count(), set->columns()[i].values.data());
            if (bad.rule) refuse_value(read, order[i], bad);
        }
        set->publish_complete();
        *out_set = {self.curve_sets.add(set)};
    });
}

FlgResult flgCurveSetCreateFromPoints(FlgContext context, const float* points, uint32_t count, uint8_t flags,
                                      FlgCurveSet* out_set) {
    return guarded([&] {
        require(out_set, "out_set") = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::curves];
        require(points, "points");
        if (count == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "count is 0, must be at least 1");
        if (count > sampled_points_max)
            throw Failure(FLG_ERROR_LIMIT, "count is %u, more than the limit of 2^31 points", count);
        if ((flags & ~FLG_CURVE_CLOSED) != 0)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "flags is %u, must be 0 or FLG_CURVE_CLOSED", flags);

        const auto set = make_object<CurveSet>(memory, memory);
        set->allocate_curves(1);
        set->offsets()[0] = 0;
        set->offsets()[1] = count;
        set->begin_curve(0, flags);
        const std::pmr::vector<CurveSet::ColumnLayout> layout({{FLG_ATTRIBUTE_POSITION, 3}}, memory);
        set->allocate_columns(layout);
        const BadValue bad =
            copy_column({FLG_ATTRIBUTE_POSITION, 3, points, 0, 0}, 0, count, set->columns()[0].values.data());
        if (bad.rule) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "points holds %g at point %u, %s", static_cast<double>(bad.value),
                          bad.row, bad.rule);
        }
        set->publish_complete();
        *out_set = {self.curve_sets.add(set)};
    });
}

const FlgColumn* flgCurveSetViewGetColumn(const FlgCurveSetView* view, FlgAttribute attribute) {
    return view ? find_column(view->columns, view->column_count, attribute) : nullptr;
}

FlgResult flgCurveSetGetView(FlgContext context, FlgCurveSet set, FlgCurveSetView* out_view) {
    return get_view(out_view, [&] { return get_context(context).curve_sets.get(set.id, "set"); });
}

FlgResult flgCurveSetScalesInit(FlgCurveSetScales* scales, uint32_t struct_size) {
    return init(scales, struct_size, sized<FlgCurveSetScales>(), "scales");
}

FlgResult flgCurveSetGetScales(FlgContext context, FlgCurveSet set, FlgCurveSetScales* out_scales) {
    return show(
        out_scales, "out_scales", sized<FlgCurveSetScales>(),
        [&] { return get_context(context).curve_sets.get(set.id, "set"); },
        [](const CurveSet& self) { return self.scales(); });
}

FlgResult flgCurveSetRelease(FlgContext context, FlgCurveSet set) {
    return release(context, &Context::curve_sets, set, "set");
}

FlgResult flgCurveSetResampleDescInit(FlgCurveSetResampleDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgCurveSetResampleDesc>());
}

FlgResult flgCurveSetResample(FlgContext context, const FlgCurveSetResampleDesc* desc, FlgCurveSet* out_set,
                              FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_set, "out_set", out_job);
        const FlgCurveSetResampleDesc read = read_struct(desc, sized<FlgCurveSetResampleDesc>(), "desc");
        check_range(read.spacing > 0 && std::isfinite(read.spacing), "desc.spacing", read.spacing,
                    "finite and above 0");
        check_frame(read.frame, "desc.frame");
        Submission submission(self, read.job);
        const auto in = self.curve_sets.get(read.curves.id, "desc.curves");
        const auto out = self.make(self.curve_sets);
        out->origin = in->origin;
        submission.read(*in, "desc.curves");
        submission.job().strand.start(resample_curves(submission.pace(), in, read.spacing, read.frame, out));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
    });
}

FlgResult flgCurveSetSimplifyDescInit(FlgCurveSetSimplifyDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_simplify_desc());
}

FlgResult flgCurveSetSimplify(FlgContext context, const FlgCurveSetSimplifyDesc* desc, FlgCurveSet* out_set,
                              FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_set, "out_set", out_job);
        const FlgCurveSetSimplifyDesc read = read_struct(desc, default_simplify_desc(), "desc");
        check_range(read.level_count >= 1 && read.level_count <= max_levels, "desc.level_count", read.level_count,
                    "1 to 16");
        require(read.tolerances, "desc.tolerances");
        check_range(read.color_tolerance >= 0 && is_coordinate(read.color_tolerance), "desc.color_tolerance",
                    read.color_tolerance, "0 to 1e30");
        Submission submission(self, read.job);
        const auto in = self.curve_sets.get(read.curves.id, "desc.curves");
        const SimplifyInput input = read_simplify_input(read, in);
        const auto out = self.make(self.curve_sets);
        out->origin = in->origin;
        submission.read(*in, "desc.curves");
        submission.job().strand.start(simplify_curves(submission.pace(), input, out));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
    });
}

}  // extern "C"
