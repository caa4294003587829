// SPDX-License-Identifier: MIT
#include "documents/tangle_script.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "documents/failure.h"
#include "documents/mesh_places.h"
#include "documents/surface_spline.h"
#include "documents/tangle_borders.h"
#include "documents/tangle_shapes.h"

namespace flg::cli {

namespace {

constexpr double kLargest = 1e30;
constexpr float kShapeSize = 0.8f;  // of the circle that has room
constexpr uint32_t kAnyCount = std::numeric_limits<uint32_t>::max();

enum class Action { divide, apply_macro, displace, group, join, cut_shapes, stylize_borders };

struct Operation {
    const char* name;
    Action action;
    uint32_t kind = 0;  // the operator's or the macro's
};

const std::vector<Operation>& operations() {
    static const std::vector<Operation> all = [] {
        std::vector<Operation> list;
        for (uint32_t n = 0; const char* name = flgTangleOperatorGetName(n); ++n)
            list.push_back({name, Action::divide, n});
        list.push_back({"displace", Action::displace});
        list.push_back({"group", Action::group});
        list.push_back({"join", Action::join});
        for (uint32_t n = 0; const char* name = flgTangleMacroGetName(n); ++n)
            list.push_back({name, Action::apply_macro, n});
        list.push_back({"shapes", Action::cut_shapes});
        list.push_back({"stylize", Action::stylize_borders});
        return list;
    }();
    return all;
}

const Operation& read_operation(const JsonPlace& op) {
    std::vector<const char*> names;
    for (const Operation& operation : operations()) names.push_back(operation.name);
    return operations()[op.word(names)];
}

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

// Of up to nine digits.
uint32_t number_in(const JsonPlace& place, const std::string& digits) {
    if (digits.empty() || digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos)
        place.fail("needs a number after `.part:`, or two as in `.part:1/3`");
    return static_cast<uint32_t>(std::stoul(digits));
}

}  // namespace

TangleScript::TangleScript(Session& session, const MeshSurface& surface, Report& report)
    : session_(session), surface_(surface), report_(report) {
    FlgJob job = {};
    check(flgTangleCreate(session.context(), surface.handle(), nullptr, &tangle_, &job), surface.name());
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

void TangleScript::run(const nlohmann::json& script, const std::string& name, bool has_own_materials) {
    const JsonPlace whole(script, name + ": script");
    whole.allow({"unit", "operations", "materials"});
    if (const auto unit = whole.find("unit"); unit && unit->word({"metres", "size"}) == 1) {
        const FlgSurfaceReport& report = surface_.report();
        unit_ = std::hypot(report.box_max[0] - report.box_min[0], report.box_max[1] - report.box_min[1],
                           report.box_max[2] - report.box_min[2]);
    }
    folder_ = std::filesystem::path(name).parent_path();
    for (const JsonPlace& operation : whole.at("operations").items()) run_operation(operation);
    if (const auto materials = whole.find("materials")) take_materials(*materials, has_own_materials);
}

void TangleScript::take_materials(const JsonPlace& list, bool has_own) {
    std::vector<ScriptMaterial> entries = read_materials(list, has_own, [this](const JsonPlace& on) {
        const std::vector<uint32_t> regions = select(on);
        if (regions.empty()) report_.warn(on.path() + ": selects no region");
        return regions;
    });
    std::vector<FlgTangleRegion> regions;
    for (uint32_t r = 0; r < info().region_count; ++r) regions.push_back(region(r));
    materials_ = spread_materials(std::move(entries), regions);
}

float TangleScript::length(const JsonPlace& place) const {
    return static_cast<float>(unit_ * double{place.number(0, kLargest)});
}

void TangleScript::run_operation(const JsonPlace& operation) {
    operation.allow({"op",     "name",   "on",       "from",   "to",    "delta",        "count",
                     "groups", "cycle",  "scaffold", "closed", "each",  "perturbation", "frequency",
                     "seed",   "amount", "bias",     "gain",   "reach", "size",         "spacing",
                     "svg",    "turn",   "style",    "smooth", "mute",  "border"});
    const Operation& op = read_operation(operation.at("op"));
    Result result;
    result.applied = select(operation.at("on"));
    if (result.applied.empty() && mutes_any(operation.at("on"))) {
        report_.warn(operation.path() + " is left out: what it is on is made by operations that are muted");
        keep_result(operation, {{}, {}, true});
        return;
    }
    if (result.applied.empty()) operation.at("on").fail("selects no region");
    const uint32_t before = info().region_count, steps = info().undo_count;
    const bool each = operation.find("each") && operation.at("each").flag();
    const bool smooth = operation.find("smooth") && operation.at("smooth").flag();
    if (smooth && !(op.action == Action::divide && op.kind == FLG_TANGLE_OPERATOR_POLYLINE))
        operation.at("smooth").fail("is for polylines");
    const auto divide_all = [&](const std::vector<uint32_t>& regions) {
        if (smooth) return cut_spline(operation, regions);
        if (op.action == Action::divide) return divide(operation, static_cast<FlgTangleOperator>(op.kind), regions);
        apply_macro(operation, static_cast<FlgTangleMacro>(op.kind), regions);
    };
    const auto change = [&](auto function) {
        FlgJob job = {};
        check(function(session_.context(), tangle_, result.applied.data(), static_cast<uint32_t>(result.applied.size()),
                       nullptr, &job),
              operation.path());
        finish(job, operation);
    };
    bool may_divide = true;
    switch (op.action) {
        case Action::divide:
        case Action::apply_macro:
            if (!each) {
                divide_all(result.applied);
                break;
            }
            for (const uint32_t region : result.applied) divide_all({region});
            break;
        case Action::cut_shapes: cut_shapes(operation, result.applied); break;
        case Action::stylize_borders: stylize_borders(operation, result.applied); break;
        case Action::displace:
            displace(operation, result.applied);
            may_divide = false;
            break;
        case Action::group:
        case Action::join:
            change(op.action == Action::group ? flgTangleGroup : flgTangleJoin);
            may_divide = false;
            break;
    }
    if (operation.find("mute") && operation.at("mute").flag()) {
        mute_from(operation, steps);
        result.muted = true;
        may_divide = false;
    }
    const uint32_t after = info().region_count;
    if (may_divide && after == before) report_.warn(operation.path() + " divides nothing");
    for (uint32_t r = before; r < after; ++r) {
        const FlgTangleRegion node = region(r);
        if (node.child_count == 0 && node.joined_into == FLG_NO_INDEX) result.made.push_back(r);
    }
    keep_result(operation, std::move(result));
}

// The steps from one on, the last one first: none of them is computed again.
void TangleScript::mute_from(const JsonPlace& operation, uint32_t first) {
    for (uint32_t step = info().undo_count; step-- > first;) {
        FlgJob job = {};
        check(flgTangleMuteStep(session_.context(), tangle_, step, 1, nullptr, &job), operation.path());
        finish(job, operation);
    }
}

// Whether a selection names an operation that is muted, or was left out.
bool TangleScript::mutes_any(const JsonPlace& selection) const {
    if (selection.is_string()) {
        const auto found = results_.find(selection.text().substr(0, selection.text().find('.')));
        return found != results_.end() && found->second.muted;
    }
    if (!selection.is_array()) return mutes_any(selection.at("of")) || mutes_any(selection.at("in"));
    const std::vector<JsonPlace> items = selection.items();
    return std::any_of(items.begin(), items.end(), [this](const JsonPlace& item) { return mutes_any(item); });
}

void TangleScript::keep_result(const JsonPlace& operation, Result result) {
    if (const auto name = operation.find("name")) {
        if (name->text() == "root") name->fail("is taken by the whole surface");
        if (name->text() == "default") name->fail("is taken by the material of all that has no other");
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
    const FlgTangleSeeds a = read_seeds(operation.at("from"), from);
    desc.a = &a;
    FlgTangleSeeds b;
    if (const auto seeds = operation.find("to")) {
        b = read_seeds(*seeds, to);
        desc.b = &b;
    }
    // A share of the blend has no unit.
    const bool is_share = kind == FLG_TANGLE_OPERATOR_CONTOUR && operation.find("to");
    if (!is_share) desc.delta = in_metres(desc.delta);
    if (const auto delta = operation.find("delta")) desc.delta = is_share ? delta->number(0, 1) : length(*delta);
    if (const auto count = operation.find("count")) desc.count = count->count(0, 256);
    read_groups(operation, desc);
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

void TangleScript::read_groups(const JsonPlace& operation, FlgTangleDivideDesc& desc) const {
    if (const auto groups = operation.find("groups")) {
        desc.grouping = static_cast<FlgTangleGrouping>(groups->word({"two", "one", "each", "cycle"}));
    }
    if (const auto cycle = operation.find("cycle")) desc.cycle = cycle->count(1, 65536);
    if (const auto scaffold = operation.find("scaffold")) desc.scaffold = scaffold->flag() ? 1 : 0;
}

// The leaves below regions, rising.
std::vector<uint32_t> TangleScript::leaves_of(const std::vector<uint32_t>& regions) const {
    const std::set<uint32_t> chosen(regions.begin(), regions.end());
    std::set<uint32_t> leaves;
    const uint32_t count = info().region_count;
    for (uint32_t r = 0; r < count; ++r) {
        uint32_t at = r;
        while (at != FLG_NO_INDEX && !chosen.contains(at)) at = region(at).parent;
        if (at == FLG_NO_INDEX || region(r).child_count > 0) continue;
        uint32_t leaf = r;
        while (region(leaf).joined_into != FLG_NO_INDEX) leaf = region(leaf).joined_into;
        leaves.insert(leaf);
    }
    return {leaves.begin(), leaves.end()};
}

// A file that a script names: from the script's folder on.
std::string TangleScript::file_of(const JsonPlace& place) const {
    return (folder_ / place.text()).string();
}

// Along lines on the surface as it is; one step.
void TangleScript::cut_lines(const JsonPlace& operation, const std::vector<uint32_t>& regions, FlgSurfaceCurves lines) {
    FlgTangleDivideDesc desc;
    flgTangleDivideDescInit(&desc, sizeof desc);
    desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
    desc.tangle = tangle_;
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    FlgTangleSeeds a = flgTangleSeedsDefaults();
    a.curves = lines;
    desc.a = &a;
    read_groups(operation, desc);
    FlgJob job = {};
    check(flgTangleDivide(session_.context(), &desc, &job), operation.path());
    finish(job, operation);
}

// A polyline's points joined by a spline on the surface.
void TangleScript::cut_spline(const JsonPlace& operation, const std::vector<uint32_t>& regions) {
    SeedArrays arrays;
    read_seeds(operation.at("from"), arrays);
    if (arrays.points.empty()) operation.at("from").fail("has no points, which a smooth polyline goes through");
    const bool closed = operation.find("closed") && operation.at("closed").flag();
    if (spline_manifold_.id == 0)
        spline_manifold_ = create_manifold(session_, surface_.handle(), operation.path(), report_);
    const FlgCurveSet line =
        spline_through(session_, spline_manifold_, surface_.view(), arrays.points, closed, operation.path(), report_);
    const FlgSurfaceCurves laid = lay_lines(session_, surface_.handle(), line, operation.path(), report_);
    cut_lines(operation, regions, laid);
    flgCurveSetRelease(session_.context(), line);
    flgSurfaceCurvesRelease(session_.context(), laid);
}

// Cut into the regions, then into those around them; what these lose is joined to the regions, whose identifiers are
// lower.
void TangleScript::stylize_borders(const JsonPlace& operation, const std::vector<uint32_t>& regions) {
    const std::vector<uint32_t> inside = leaves_of(regions);
    const RegionBorders borders = find_borders(surface_.view(), {inside.begin(), inside.end()});
    if (borders.around.empty()) operation.at("on").fail("has no borders on the surface");
    StrokeLook look = {file_of(operation.at("style")), double{length(operation.at("size"))}, 1};
    if (!(look.length > 0)) operation.at("size").fail("must be above 0");
    if (const auto seed = operation.find("seed")) look.seed = seed->count(0, kAnyCount);
    const FlgCurveSet lines = stylize_lines(session_, borders.lines, look, operation.path(), report_);
    const auto cut = [&](const std::vector<uint32_t>& divided) {
        const FlgSurfaceCurves laid = lay_lines(session_, surface_.handle(), lines, operation.path(), report_);
        cut_lines(operation, divided, laid);
        flgSurfaceCurvesRelease(session_.context(), laid);
    };
    cut(inside);
    const uint32_t first = info().region_count;
    cut({borders.around.begin(), borders.around.end()});
    flgCurveSetRelease(session_.context(), lines);
    for (const auto& [region, won] : won_regions(leaves_of(regions), first)) {
        std::vector<uint32_t> joined = {region};
        joined.insert(joined.end(), won.begin(), won.end());
        FlgJob job = {};
        check(flgTangleJoin(session_.context(), tangle_, joined.data(), static_cast<uint32_t>(joined.size()), nullptr,
                            &job),
              operation.path());
        finish(job, operation);
    }
}

// Of the regions from the first one on, those to the left of lines: by the one of others, to the left of lines as well,
// with which they have most edges in common.
std::map<uint32_t, std::vector<uint32_t>> TangleScript::won_regions(const std::vector<uint32_t>& others,
                                                                    uint32_t first) const {
    const FlgSurfaceView surface = surface_.view();
    const std::set<uint32_t> inside(others.begin(), others.end());
    std::map<uint32_t, std::map<uint32_t, uint32_t>> edges;
    for (uint32_t edge = 0; edge < 3 * surface.mesh->triangle_count; ++edge) {
        const uint32_t across = surface.neighbours[edge];
        if (across == FLG_NO_INDEX) continue;
        const uint32_t a = surface.mesh->regions[edge / 3], b = surface.mesh->regions[across];
        if (a >= first && inside.contains(b) && region(a).part == 0 && region(b).part == 0) ++edges[a][b];
    }
    std::map<uint32_t, std::vector<uint32_t>> won;
    for (const auto& [sliver, touched] : edges) {
        const auto most = std::max_element(touched.begin(), touched.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        won[most->first].push_back(sliver);
    }
    return won;
}

void TangleScript::cut_shapes(const JsonPlace& operation, const std::vector<uint32_t>& regions) {
    SpaceLines shape = read_lines(file_of(operation.at("svg")), report_);
    prepare_shape(shape);
    const float size = operation.find("size") ? operation.at("size").number(0, kLargest) : kShapeSize;
    const float turn = operation.find("turn") ? operation.at("turn").number(-kLargest, kLargest) : 0;
    const std::vector<uint32_t> cells = leaves_of(regions);
    const std::vector<CellMiddle> middles = find_middles(session_, surface_, cells, operation.path(), report_);
    const FlgMeshView& mesh = *surface_.view().mesh;
    SpaceLines all;
    all.origin = origin_of(mesh);
    for (const CellMiddle& middle : middles) {
        if (middle.vertex == FLG_NO_INDEX) continue;
        place_shape(shape, vertex_at(mesh, middle.vertex), middle.normal, double{size} * middle.radius,
                    turn * M_PI / 180, all);
    }
    if (all.count() == 0) operation.fail("has no room in any of its regions");
    const FlgCurveSet set = create_set(session_.context(), all, operation.path());
    const FlgSurfaceCurves laid = lay_lines(session_, surface_.handle(), set, operation.path(), report_);
    cut_lines(operation, cells, laid);
    flgCurveSetRelease(session_.context(), set);
    flgSurfaceCurvesRelease(session_.context(), laid);
}

void TangleScript::apply_macro(const JsonPlace& operation, FlgTangleMacro kind, const std::vector<uint32_t>& regions) {
    FlgTangleApplyMacroDesc desc;
    flgTangleApplyMacroDescInit(&desc, sizeof desc);
    desc.kind = kind;
    desc.tangle = tangle_;
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    if (const auto count = operation.find("count")) desc.count = count->count(1, 256);
    desc.size = in_metres(desc.size);
    desc.spacing = in_metres(desc.spacing);
    if (const auto size = operation.find("size")) desc.size = length(*size);
    if (const auto spacing = operation.find("spacing")) desc.spacing = length(*spacing);
    if (const auto seed = operation.find("seed")) desc.seed = seed->count(0, kAnyCount);
    if (const auto border = operation.find("border")) {
        if (kind != FLG_TANGLE_MACRO_SUNBURST && kind != FLG_TANGLE_MACRO_GRID)
            border->fail("is for sunbursts and grids");
        desc.border = border->count(0, kAnyCount);
    }
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
    desc.amount = in_metres(desc.amount);
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
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
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
    if (selection.is_string()) return select_by_name(selection);
    if (!selection.is_array()) return select_inside(selection);
    std::set<uint32_t> all;
    for (const JsonPlace& item : selection.items()) {
        const std::vector<uint32_t> some = select(item);
        all.insert(some.begin(), some.end());
    }
    return {all.begin(), all.end()};
}

// {"of": SELECTION, "in": SELECTION}: those of the first that are, or lie in, one of the second.
std::vector<uint32_t> TangleScript::select_inside(const JsonPlace& selection) const {
    selection.allow({"of", "in"});
    const std::vector<uint32_t> around = select(selection.at("in"));
    const std::set<uint32_t> places(around.begin(), around.end());
    std::vector<uint32_t> inside;
    for (const uint32_t chosen : select(selection.at("of"))) {
        uint32_t at = chosen;
        while (at != FLG_NO_INDEX && !places.contains(at)) at = region(at).parent;
        if (at != FLG_NO_INDEX) inside.push_back(chosen);
    }
    return inside;
}

// Of foreground, background, light and dark.
bool TangleScript::is_of(uint32_t number, const std::string& which) const {
    const FlgTangleRegion node = region(number);
    if (which == "foreground" || which == "background") return (node.part % 2 == 1) == (which == "background");
    const uint32_t around = node.parent == FLG_NO_INDEX ? 0 : region(node.parent).part;
    return ((node.part + around) % 2 == 1) == (which == "dark");
}

// NAME, NAME.regions, NAME.foreground, NAME.background, NAME.light, NAME.dark, NAME.part:N or NAME.part:N/M.
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
    if (!by_part && which != "foreground" && which != "background" && which != "light" && which != "dark") {
        place.fail("knows .regions, .foreground, .background, .light, .dark and .part:N, not `." + which + "`");
    }
    uint32_t part = 0, every = 0;
    if (by_part) {
        const size_t slash = std::min(which.find('/'), which.size());
        part = number_in(place, which.substr(5, slash - 5));
        if (slash < which.size()) every = number_in(place, which.substr(slash + 1));
        if (slash < which.size() && part >= every)
            place.fail("needs a second number above the first: `." + which + "`");
    }
    std::vector<uint32_t> chosen;
    std::copy_if(found->second.made.begin(), found->second.made.end(), std::back_inserter(chosen), [&](uint32_t r) {
        if (!by_part) return is_of(r, which);
        return (every > 0 ? region(r).part % every : region(r).part) == part;
    });
    return chosen;
}

}  // namespace flg::cli
