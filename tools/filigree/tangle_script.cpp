// SPDX-License-Identifier: MIT
#include "tangle_script.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "failure.h"
#include "mesh_places.h"

namespace flg::cli {

namespace {

constexpr double kLargest = 1e30;
constexpr size_t kFirstMacro = 7;  // among the names of operations
constexpr uint32_t kAnyCount = std::numeric_limits<uint32_t>::max();

// A vertex by its number, or three coordinates.
Place read_place(const JsonPlace& item) {
    Place place = {.text = item.path(), .vertex = std::nullopt, .position = {}};
    if (!item.is_array()) {
        place.vertex = item.count(0, kAnyCount);
        place.text = std::to_string(*place.vertex);
        return place;
    }
    const std::vector<JsonPlace> numbers = item.items();
    if (numbers.size() != 3) item.fail("must be a vertex or three numbers");
    for (size_t k = 0; k < 3; ++k) place.position[k] = numbers[k].number(-kLargest, kLargest);
    return place;
}

}  // namespace

TangleScript::TangleScript(Session& session, const MeshSurface& surface, Report& report)
    : session_(session), surface_(surface), report_(report) {
    FlgJob job = {};
    check(flgTangleCreate(session.context(), surface.handle(), &tangle_, &job), surface.name());
    session.finish({{{job, surface.name()}}}, report);
}

FlgTangleInfo TangleScript::info() const {
    FlgTangleInfo info = {};
    info.struct_size = sizeof info;
    check(flgTangleGetInfo(session_.context(), tangle_, &info), surface_.name());
    return info;
}

FlgTangleRegion TangleScript::region(uint32_t region) const {
    FlgTangleRegion out = {};
    out.struct_size = sizeof out;
    check(flgTangleGetRegion(session_.context(), tangle_, region, &out), surface_.name());
    return out;
}

void TangleScript::finish(FlgJob job, const JsonPlace& subject) {
    session_.finish({{{job, subject.path()}}}, report_);
}

void TangleScript::run(const nlohmann::json& script, const std::string& name) {
    const JsonPlace whole(script, name + ": script");
    whole.allow({"unit", "operations"});
    if (const auto unit = whole.find("unit"); unit && unit->word({"metres", "size"}) == 1) {
        const FlgSurfaceReport& report = surface_.report();
        unit_ = std::hypot(report.box_max[0] - report.box_min[0], report.box_max[1] - report.box_min[1],
                           report.box_max[2] - report.box_min[2]);
    }
    for (const JsonPlace& operation : whole.at("operations").items()) run_operation(operation);
}

float TangleScript::length(const JsonPlace& place) const {
    return static_cast<float>(unit_ * double{place.number(0, kLargest)});
}

void TangleScript::run_operation(const JsonPlace& operation) {
    operation.allow({"op",     "name",   "on",       "from",   "to",    "delta",        "count",
                     "groups", "cycle",  "scaffold", "closed", "each",  "perturbation", "frequency",
                     "seed",   "amount", "bias",     "gain",   "reach", "size",         "spacing"});
    const size_t op =
        operation.at("op").word({"contour", "stream", "voronoi", "polyline", "displace", "group", "join", "sunburst",
                                 "polka_dots", "frames", "flower", "grid", "outline", "lace", "cells"});
    Result result;
    result.applied = select(operation.at("on"));
    if (result.applied.empty()) operation.at("on").fail("selects no region");
    const uint32_t before = info().region_count;
    const bool each = operation.find("each") && operation.at("each").flag();
    const auto divide_all = [&](const std::vector<uint32_t>& regions) {
        if (op <= FLG_TANGLE_POLYLINE) return divide(operation, static_cast<FlgTangleOperator>(op), regions);
        apply_macro(operation, static_cast<FlgTangleMacro>(op - kFirstMacro), regions);
    };
    if ((op <= FLG_TANGLE_POLYLINE || op >= kFirstMacro) && each) {
        for (const uint32_t region : result.applied) divide_all({region});
    } else if (op <= FLG_TANGLE_POLYLINE || op >= kFirstMacro) {
        divide_all(result.applied);
    } else if (op == 4) {
        displace(operation, result.applied);
    } else {
        FlgJob job = {};
        const auto change = op == 5 ? flgTangleGroup : flgTangleJoin;
        check(change(session_.context(), tangle_, result.applied.data(), static_cast<uint32_t>(result.applied.size()),
                     &job),
              operation.path());
        finish(job, operation);
    }
    for (uint32_t r = before; r < info().region_count; ++r) result.made.push_back(r);
    if (const auto name = operation.find("name")) {
        if (name->text() == "root") name->fail("is taken by the whole surface");
        if (!results_.emplace(name->text(), std::move(result)).second) name->fail("was given before");
    }
}

void TangleScript::divide(const JsonPlace& operation, FlgTangleOperator kind, const std::vector<uint32_t>& regions) {
    FlgTangleDivideDesc desc;
    flgTangleDivideDescInit(&desc, sizeof desc);
    desc.kind = kind;
    desc.tangle = tangle_;
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    SeedArrays from, to;
    desc.a = read_seeds(operation.at("from"), from);
    if (const auto seeds = operation.find("to")) desc.b = read_seeds(*seeds, to);
    if (const auto delta = operation.find("delta")) {
        // A share of the blend has no unit.
        const bool is_share = kind == FLG_TANGLE_CONTOUR && operation.find("to");
        desc.delta = is_share ? delta->number(0, 1) : length(*delta);
    }
    if (const auto count = operation.find("count")) desc.count = count->count(0, 256);
    if (const auto groups = operation.find("groups")) {
        desc.grouping = static_cast<FlgTangleGrouping>(groups->word({"two", "one", "each", "cycle"}));
    }
    if (const auto cycle = operation.find("cycle")) desc.cycle = cycle->count(1, 65536);
    if (const auto scaffold = operation.find("scaffold")) desc.scaffold = scaffold->flag() ? 1 : 0;
    if (const auto closed = operation.find("closed")) desc.closed = closed->flag() ? 1 : 0;
    if (const auto perturbation = operation.find("perturbation")) desc.perturbation = length(*perturbation);
    if (const auto frequency = operation.find("frequency")) {
        desc.frequency = static_cast<float>(double{frequency->number(0, kLargest)} / unit_);
    }
    if (const auto seed = operation.find("seed")) desc.seed = seed->count(0, kAnyCount);
    FlgJob job = {};
    check(flgTangleDivide(session_.context(), &desc, &job), operation.path());
    finish(job, operation);
}

void TangleScript::apply_macro(const JsonPlace& operation, FlgTangleMacro kind, const std::vector<uint32_t>& regions) {
    FlgTangleMacroDesc desc;
    flgTangleMacroDescInit(&desc, sizeof desc);
    desc.kind = kind;
    desc.tangle = tangle_;
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    if (const auto count = operation.find("count")) desc.count = count->count(1, 256);
    if (const auto size = operation.find("size")) desc.size = length(*size);
    if (const auto spacing = operation.find("spacing")) desc.spacing = length(*spacing);
    if (const auto seed = operation.find("seed")) desc.seed = seed->count(0, kAnyCount);
    FlgJob job = {};
    check(flgTangleApplyMacro(session_.context(), &desc, &job), operation.path());
    finish(job, operation);
}

void TangleScript::displace(const JsonPlace& operation, const std::vector<uint32_t>& regions) {
    FlgTangleDisplaceDesc desc;
    flgTangleDisplaceDescInit(&desc, sizeof desc);
    desc.tangle = tangle_;
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    if (const auto amount = operation.find("amount")) {
        desc.amount = static_cast<float>(unit_ * double{amount->number(-kLargest, kLargest)});
    }
    if (const auto bias = operation.find("bias")) desc.bias = bias->number(0, 1);
    if (const auto gain = operation.find("gain")) desc.gain = gain->number(0, 1);
    if (const auto reach = operation.find("reach")) desc.reach = length(*reach);
    FlgJob job = {};
    check(flgTangleDisplace(session_.context(), &desc, &job), operation.path());
    finish(job, operation);
}

FlgTangleSeeds TangleScript::read_seeds(const JsonPlace& place, SeedArrays& arrays) const {
    FlgTangleSeeds seeds = {};
    place.allow({"borders", "stretches", "points", "samples", "spacing", "of"});
    if (const auto borders = place.find("borders")) {
        seeds.borders = static_cast<FlgTangleBorders>(borders->word({"none", "outer", "each"}));
    }
    if (const auto stretches = place.find("stretches")) {
        for (const JsonPlace& item : stretches->items()) {
            item.allow({"loop", "begin", "end"});
            const auto share = [&](const char* key, float otherwise) {
                const auto found = item.find(key);
                return found ? found->number(0, 2) : otherwise;
            };
            arrays.stretches.push_back({item.at("loop").count(0, kAnyCount), share("begin", 0), share("end", 1)});
        }
    }
    if (const auto points = place.find("points")) {
        PlaceFinder finder(surface_, points->path());
        for (const JsonPlace& item : points->items()) arrays.points.push_back(finder.point(read_place(item)));
    }
    if (const auto samples = place.find("samples")) {
        samples->allow({"radius", "count"});
        seeds.sample_radius = length(samples->at("radius"));
        if (const auto count = samples->find("count")) seeds.sample_count = count->count(0, kAnyCount);
    }
    if (const auto spacing = place.find("spacing")) seeds.border_spacing = length(*spacing);
    if (const auto of = place.find("of")) arrays.regions = select(*of);
    seeds.stretches = arrays.stretches.data();
    seeds.stretch_count = static_cast<uint32_t>(arrays.stretches.size());
    seeds.points = arrays.points.data();
    seeds.point_count = static_cast<uint32_t>(arrays.points.size());
    seeds.regions = arrays.regions.data();
    seeds.region_count = static_cast<uint32_t>(arrays.regions.size());
    return seeds;
}

std::vector<uint32_t> TangleScript::select(const JsonPlace& selection) const {
    if (!selection.is_array()) return select_by_name(selection);
    std::set<uint32_t> all;
    for (const JsonPlace& item : selection.items()) {
        const std::vector<uint32_t> some = select_by_name(item);
        all.insert(some.begin(), some.end());
    }
    return {all.begin(), all.end()};
}

// NAME, NAME.regions, NAME.foreground, NAME.background or NAME.part:N.
std::vector<uint32_t> TangleScript::select_by_name(const JsonPlace& place) const {
    const std::string text = place.text();
    if (text == "root") return {0};
    const size_t dot = text.find('.');
    const auto found = results_.find(text.substr(0, dot));
    if (found == results_.end()) place.fail("names no operation before this one: `" + text + "`");
    if (dot == std::string::npos) return found->second.applied;
    const std::string which = text.substr(dot + 1);
    if (which == "regions") return found->second.made;
    const bool by_part = which.rfind("part:", 0) == 0;
    if (!by_part && which != "foreground" && which != "background") {
        place.fail("knows .regions, .foreground, .background and .part:N, not `." + which + "`");
    }
    uint64_t wanted = which == "background" ? 1 : 0;
    if (by_part) {
        const std::string digits = which.substr(5);
        if (digits.empty() || digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos) {
            place.fail("needs a number after `.part:`");
        }
        wanted = std::stoul(digits);
    }
    std::vector<uint32_t> chosen;
    for (const uint32_t r : found->second.made) {
        const uint32_t number = region(r).part;
        if ((by_part ? number : number % 2) == wanted) chosen.push_back(r);
    }
    return chosen;
}

}  // namespace flg::cli
