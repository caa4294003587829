// SPDX-License-Identifier: MIT
// Histories of tangles: shown to hosts.
#include <algorithm>
#include <span>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/tangle_change.h"
#include "api/tangle_requests.h"

namespace flg {

namespace {

// What an FlgTangleHistory points to. Arrays that records hold in the host's form already are shown where they are.
class ShownHistory {
public:
    ShownHistory(const Tangle& tangle, Memory* memory)
        : shown_(memory),
          steps_(memory),
          shown_steps_(memory),
          divides_(memory),
          macros_(memory),
          displaces_(memory),
          seeds_(memory),
          curves_(memory),
          stretches_(memory),
          points_(memory),
          places_(memory),
          shown_places_(memory),
          made_(memory),
          identities_(memory),
          names_(memory) {
        const size_t count = shown_count(tangle);
        for (size_t i = 0; i < count; ++i)
            if (!tangle.steps[i]->goes_on) identities_.push_back(tangle.steps[i]->identity);
        for (size_t i = 0; i < count; ++i) {
            if (!tangle.steps[i]->goes_on) begin_step(*tangle.steps[i]);
            add_record(tangle.steps[i]);
        }
        for (size_t i = 0; i < steps_.size(); ++i) {
            steps_[i].places = shown_places_[i].data();
            steps_[i].place_count = static_cast<uint32_t>(shown_places_[i].size());
            steps_[i].made = made_[i].empty() ? nullptr : made_[i][0].data();
            steps_[i].made_count = static_cast<uint32_t>(made_[i].size());
            shown_steps_.push_back(&steps_[i]);
        }
    }

    std::span<const FlgTangleStep* const> steps() const { return shown_steps_; }

private:
    // Those that are made, and those undone that stand where they can be made again: before an edit that was undone.
    static size_t shown_count(const Tangle& tangle) {
        size_t undone = 0;
        for (size_t act = tangle.done; act < tangle.acts.size() && !tangle.acts[act]; ++act) ++undone;
        size_t count = tangle.made;
        while (count < tangle.steps.size()) {
            if (!tangle.steps[count]->goes_on && undone-- == 0) break;
            ++count;
        }
        return count;
    }

    void begin_step(const TangleStep& shown) {
        const StepRecord& record = *shown.record;
        auto step = sized<FlgTangleStep>();
        step.first_region = record.first_region;
        step.state = static_cast<FlgTangleStepState>(shown.state);
        step.why = shown.why.data();
        if (record.wanted) {
            const std::pmr::vector<FlgTangleRegionName>& names = describe_names(*record.wanted);
            step.names = names.data();
            step.name_count = static_cast<uint32_t>(names.size());
        }
        wanted_ = record.wanted.get();
        if (record.macro) {
            step.kind = FLG_TANGLE_STEP_KIND_MACRO;
            step.macro = &macros_.emplace_back(describe(*record.macro));
        } else if (const auto* const divide = std::get_if<DivideRequest>(&record.request)) {
            step.kind = FLG_TANGLE_STEP_KIND_DIVIDE;
            step.divide = &divides_.emplace_back(describe(*divide));
        } else if (const auto* const displace = std::get_if<DisplaceRequest>(&record.request)) {
            step.kind = FLG_TANGLE_STEP_KIND_DISPLACE;
            step.displace = &displaces_.emplace_back(describe(*displace));
        } else if (const auto* const group = std::get_if<GroupRequest>(&record.request)) {
            step.kind = FLG_TANGLE_STEP_KIND_GROUP;
            show(wanted_ ? wanted_->regions : group->regions, step.regions, step.region_count);
        } else if (const auto* const ungroup = std::get_if<UngroupRequest>(&record.request)) {
            step.kind = FLG_TANGLE_STEP_KIND_UNGROUP;
            step.group = ungroup->group;
        } else {
            step.kind = FLG_TANGLE_STEP_KIND_JOIN;
            const std::pmr::vector<RegionId>& regions = std::get<JoinRequest>(record.request).regions;
            show(wanted_ ? wanted_->regions : regions, step.regions, step.region_count);
        }
        steps_.push_back(step);
        shown_places_.emplace_back();
        made_.emplace_back();
    }

    void add_record(const std::shared_ptr<const TangleStep>& step) {
        shown_.push_back(step);
        const StepRecord* const record = step->record.get();
        if (const auto* const divide = std::get_if<DivideRequest>(&record->request)) {
            shown_places_.back().push_back(&places_.emplace_back(describe(divide->a, record->a)));
            shown_places_.back().push_back(&places_.emplace_back(describe(divide->b, record->b)));
        }
        if (record->a.given || record->b.given) steps_.back().placed = 1;
        made_.back().insert(made_.back().end(), record->places.begin(), record->places.end());
    }

    static void show(const std::pmr::vector<RegionId>& regions, const uint32_t*& out, uint32_t& count) {
        out = regions.data();
        count = static_cast<uint32_t>(regions.size());
    }
    static const float* first_of(const Buffer<Position>& positions) {
        return positions.empty() ? nullptr : positions[0].data();
    }

    const std::pmr::vector<FlgTangleRegionName>& describe_names(const WantedRegions& wanted) {
        std::pmr::vector<FlgTangleRegionName>& names = names_.emplace_back();
        for (const WantedRegions::Name& name : wanted.names) {
            const auto step = std::find(identities_.begin(), identities_.end(), name.step);
            const bool known = step != identities_.end();
            const auto index = static_cast<uint32_t>(step - identities_.begin());
            FlgTangleRegionName& shown = names.emplace_back();
            shown = {known ? index : FLG_NO_INDEX, name.operation, name.part, name.parent, {}, name.reach};
            std::copy_n(name.place.data(), 3, shown.place);
        }
        return names;
    }

    FlgTangleSeedPlaces describe(const TangleSeeds& seeds, const SeedAnchors& anchors) {
        auto places = sized<FlgTangleSeedPlaces>();
        places.points = first_of(anchors.points);
        places.point_count = static_cast<uint32_t>(anchors.points.size());
        places.loops = first_of(anchors.loops);
        places.loop_count = static_cast<uint32_t>(anchors.loops.size());
        places.samples = first_of(anchors.samples);
        places.sample_count = static_cast<uint32_t>(anchors.samples.size());
        if (!seeds.curves) return places;
        const TracedCurves& curves = anchors.given ? *anchors.given_curves : *seeds.curves;
        const TracedCurves::Flat& flat = curves.flat;
        FlgSurfaceCurvesView& view = curves_.emplace_back(sized<FlgSurfaceCurvesView>());
        view.curve_count = curves.curves.curve_count();
        view.curve_offsets = flat.offsets.data();
        view.curve_flags = flat.flags.data();
        view.curve_values = flat.values.data();
        view.points = flat.points.data();
        places.curves = &view;
        places.curve_points = first_of(anchors.curve_points);
        return places;
    }

    const FlgTangleSeeds* describe(const TangleSeeds& seeds, const std::pmr::vector<uint32_t>* wanted) {
        FlgTangleSeeds& shown = seeds_.emplace_back(sized<FlgTangleSeeds>());
        shown.borders = seeds.borders;
        std::pmr::vector<FlgBorderStretch>& stretches = stretches_.emplace_back();
        for (const BorderStretch& stretch : seeds.stretches) {
            stretches.push_back({stretch.loop, static_cast<float>(stretch.begin), static_cast<float>(stretch.end)});
        }
        shown.stretches = stretches.data();
        shown.stretch_count = static_cast<uint32_t>(stretches.size());
        std::pmr::vector<FlgSurfacePoint>& points = points_.emplace_back();
        for (const SurfacePoint& point : seeds.points) points.push_back({point.triangle, point.u, point.v});
        shown.points = points.data();
        shown.point_count = static_cast<uint32_t>(points.size());
        shown.sample_count = seeds.sample_count;
        shown.sample_radius = seeds.sample_radius;
        shown.border_spacing = seeds.border_spacing;
        show(wanted ? *wanted : seeds.regions, shown.regions, shown.region_count);
        return &shown;
    }

    FlgTangleDivideDesc describe(const DivideRequest& request) {
        FlgTangleDivideDesc desc = request.desc;
        show(wanted_ ? wanted_->regions : request.regions, desc.regions, desc.region_count);
        desc.a = describe(request.a, wanted_ ? &wanted_->a : nullptr);
        desc.b = describe(request.b, wanted_ ? &wanted_->b : nullptr);
        return desc;
    }

    // Of macros and displacements.
    template <class Request>
    decltype(Request::desc) describe(const Request& request) const {
        decltype(Request::desc) desc = request.desc;
        show(wanted_ ? wanted_->regions : request.regions, desc.regions, desc.region_count);
        return desc;
    }

    std::pmr::vector<std::shared_ptr<const TangleStep>> shown_;
    std::pmr::deque<FlgTangleStep> steps_;
    std::pmr::vector<const FlgTangleStep*> shown_steps_;
    std::pmr::deque<FlgTangleDivideDesc> divides_;
    std::pmr::deque<FlgTangleApplyMacroDesc> macros_;
    std::pmr::deque<FlgTangleDisplaceDesc> displaces_;
    std::pmr::deque<FlgTangleSeeds> seeds_;
    std::pmr::deque<FlgSurfaceCurvesView> curves_;
    std::pmr::deque<std::pmr::vector<FlgBorderStretch>> stretches_;
    std::pmr::deque<std::pmr::vector<FlgSurfacePoint>> points_;
    std::pmr::deque<FlgTangleSeedPlaces> places_;
    std::pmr::deque<std::pmr::vector<const FlgTangleSeedPlaces*>> shown_places_;  // by step
    std::pmr::deque<std::pmr::vector<Position>> made_;                            // likewise
    std::pmr::vector<uint32_t> identities_;                                       // likewise
    std::pmr::deque<std::pmr::vector<FlgTangleRegionName>> names_;
    const WantedRegions* wanted_ = nullptr;  // of the step that is begun
};

FlgTangleHistory describe(const Tangle& tangle, const ShownHistory& shown) {
    auto history = sized<FlgTangleHistory>();
    history.steps = shown.steps().data();
    history.step_count = static_cast<uint32_t>(shown.steps().size());
    for (size_t i = 0; i < tangle.made; ++i) history.made_count += tangle.steps[i]->goes_on ? 0 : 1;
    history.base = tangle.base.number;
    std::copy_n(tangle.base.lower.data(), 3, history.box_min);
    std::copy_n(tangle.base.upper.data(), 3, history.box_max);
    return history;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgTangleHistoryInit(FlgTangleHistory* history, uint32_t struct_size) {
    return init(history, struct_size, sized<FlgTangleHistory>(), "history");
}

FlgResult flgTangleSeedPlacesInit(FlgTangleSeedPlaces* places, uint32_t struct_size) {
    return init(places, struct_size, sized<FlgTangleSeedPlaces>(), "places");
}

FlgResult flgTangleStepInit(FlgTangleStep* step, uint32_t struct_size) {
    return init(step, struct_size, sized<FlgTangleStep>(), "step");
}

FlgResult flgTangleGetHistory(FlgContext context, FlgTangle tangle, FlgTangleHistory* out_history) {
    return show(
        out_history, "out_history", sized<FlgTangleHistory>(),
        [&] { return get_context(context).tangles.get(tangle.id, "tangle"); },
        [&](Tangle& self) {
            Context& owner = get_context(context);
            Memory* const memory = owner.memory[MemoryKind::surfaces];
            const auto shown = make_object<ShownHistory>(memory, self, memory);
            self.shown_history = shown;
            return describe(self, *shown);
        });
}

}  // extern "C"
