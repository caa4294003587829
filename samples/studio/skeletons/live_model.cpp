// SPDX-License-Identifier: MIT
#include "skeletons/live_model.h"

#include <algorithm>

namespace flg::studio {
namespace {

constexpr uint32_t kQuickVertices = 2500, kFineVertices = 16000;
constexpr size_t kMaxCrossings = 16;

std::array<float, 5> array_of(const FlgBoneThresholds& from) {
    return {from.simplify, from.merge, from.prune, from.collapse, from.detail};
}

FlgBoneThresholds thresholds_of(const std::array<float, 5>& from) {
    return {.struct_size = sizeof(FlgBoneThresholds),
            .simplify = from[0],
            .merge = from[1],
            .prune = from[2],
            .collapse = from[3],
            .detail = from[4]};
}

}  // namespace

bool ModelRecipe::Part::is_shaped_as(const Part& other) const {
    return id == other.id && contour == other.contour && placement == other.placement && thickness == other.thickness &&
           depth == other.depth && mirrored == other.mirrored;
}

bool ModelRecipe::is_shaped_as(const ModelRecipe& other) const {
    return mirror == other.mirror && std::equal(parts.begin(), parts.end(), other.parts.begin(), other.parts.end(),
                                                [](const Part& a, const Part& b) { return a.is_shaped_as(b); });
}

void LiveModel::update(const Drawing& drawing, Body body) {
    make_parts(drawing);
    look_at_parts(drawing);
    take_model();
    take_skin();
    take_bound();
    start_model(drawing);
    const bool is_fine = body == Body::fine && skin_ && skin_recipe_.is_shaped_as(recipe_);
    wanted_vertices_ = body == Body::none ? 0 : is_fine ? kFineVertices : kQuickVertices;
    if (model_ && !coming_model_ && !coming_skin_ && wants_skin()) start_skin(wanted_vertices_);
}

void LiveModel::clear() {
    parts_.clear();
    good_lines_.clear();
    model_.reset(), coming_model_.reset();
    drop_skin();
    rig_ = {};
    loose_.clear();
    wanted_ = recipe_ = skin_recipe_ = {};
    model_failed_ = skin_failed_ = false;
    ++rig_revision_;
}

void LiveModel::make_parts(const Drawing& drawing) {
    // First, so that none is taken for another at the same place in memory.
    std::erase_if(parts_, [](const auto& entry) { return entry.second.contour.expired(); });
    FlgJobOptions urgent = flgJobOptionsDefaults();
    urgent.priority = FLG_PRIORITY_HIGH;
    for (const DrawnPart& part : drawing.parts) {
        if (parts_.contains(part.contour.get())) continue;
        PartMade& made = parts_[part.contour.get()];
        made.contour = part.contour;
        std::vector<double> points;
        std::vector<uint32_t> offsets = {0};
        for (const Ring& ring : part.contour->rings) {
            for (const glm::dvec2& p : ring) points.insert(points.end(), {p.x, p.y});
            offsets.push_back(static_cast<uint32_t>(points.size() / 2));
        }
        FlgPartDesc desc = flgPartDefaults();
        FlgContourView drawn = flgContourViewDefaults();
        drawn.points = points.data();
        drawn.point_count = offsets.back();
        drawn.ring_offsets = offsets.data();
        drawn.ring_count = static_cast<uint32_t>(offsets.size()) - 1;
        desc.contour = &drawn;
        desc.job = &urgent;
        FlgPart handle{};
        if (flgPartCreate(context_.get(), &desc, &handle, nullptr) == FLG_OK)
            made.part = PartOwner(context_.get(), handle);
        else
            made.state.fault = flgErrorGetMessage();
    }
}

void LiveModel::look_at_parts(const Drawing& drawing) {
    for (auto& [contour, made] : parts_) {
        if (made.state.ready || !made.state.fault.empty()) continue;
        const FlgResult result = flgPartGetView(context_.get(), made.part.get(), &made.view);
        made.state.ready = result == FLG_OK;
        if (result >= 0) continue;
        made.state.fault = flgErrorGetMessage();
        made.state.crossings = crossings_of(*contour, kMaxCrossings);
    }
    std::erase_if(good_lines_, [&](const auto& entry) { return drawing.find(entry.first) == nullptr; });
    for (const DrawnPart& part : drawing.parts)
        if (parts_.at(part.contour.get()).state.ready) good_lines_[part.id] = part.contour;
}

ContourPtr LiveModel::line_for(const DrawnPart& part) const {
    if (parts_.at(part.contour.get()).state.fault.empty()) return part.contour;
    const auto good = good_lines_.find(part.id);
    return good == good_lines_.end() ? nullptr : good->second;
}

bool LiveModel::keeps_line(uint32_t part) const {
    return good_lines_.contains(part);
}

void LiveModel::start_model(const Drawing& drawing) {
    ModelRecipe recipe{{},
                       {drawing.mirror.x, drawing.mirror.y, drawing.mirror.z, drawing.mirror.w},
                       array_of(drawing.thresholds),
                       drawing.joint_edits,
                       {}};
    for (const DrawnPart& part : drawing.parts) {
        const ContourPtr line = line_for(part);
        if (!part.visible || !line) continue;
        const PartMade& made = parts_.at(line.get());
        ModelRecipe::Part& entry = recipe.parts.emplace_back(ModelRecipe::Part{
            part.id, part.name, line, part.placement(), part.thickness, part.depth, part.mirrored, {}, {}});
        if (part.thresholds) entry.thresholds = array_of(*part.thresholds);
        if (made.state.ready && part.branch_simplify.size() == made.view.branch_count)
            entry.branch_simplify = part.branch_simplify;
    }
    for (const auto& pair : drawing.apart) {
        const auto place = [&](const std::string& name) {
            const auto found = std::find_if(recipe.parts.begin(), recipe.parts.end(),
                                            [&](const ModelRecipe::Part& part) { return part.name == name; });
            return static_cast<uint32_t>(found - recipe.parts.begin());
        };
        const uint32_t first = place(pair[0]), second = place(pair[1]);
        if (std::max(first, second) < recipe.parts.size()) recipe.apart.insert(recipe.apart.end(), {first, second});
    }
    if (recipe != wanted_) {
        model_failed_ = skin_failed_ = false;
        wanted_ = recipe;
    }
    if (recipe.parts.empty()) {
        if (!model_ && !skin_) return;
        model_.reset(), coming_model_.reset();
        drop_skin();
        rig_ = {};
        loose_.clear();
        recipe_ = skin_recipe_ = {};
        ++rig_revision_;
        return;
    }
    if (coming_model_ || model_failed_ || (model_ && !is_other_document_ && recipe == recipe_)) return;
    std::vector<FlgModelPart> parts;
    std::vector<FlgBoneThresholds> thresholds(recipe.parts.size());
    for (const ModelRecipe::Part& entry : recipe.parts) {
        FlgModelPart part = flgModelPartDefaults();
        part.part = parts_.at(entry.contour.get()).part.get();
        part.name = entry.name.c_str();
        std::copy(entry.placement.begin(), entry.placement.end(), part.placement);
        part.thickness = entry.thickness;
        part.depth = entry.depth;
        part.mirrored = entry.mirrored;
        FlgBoneThresholds& own = thresholds[parts.size()];
        if (entry.thresholds) {
            own = thresholds_of(*entry.thresholds);
            part.thresholds = &own;
        }
        if (!entry.branch_simplify.empty()) {
            part.branch_simplify = entry.branch_simplify.data();
            part.branch_count = static_cast<uint32_t>(entry.branch_simplify.size());
        }
        parts.push_back(part);
    }
    FlgModelDesc desc = flgModelDefaults();
    desc.parts = parts.data();
    desc.part_count = static_cast<uint32_t>(parts.size());
    const FlgBoneThresholds of_all = thresholds_of(recipe.thresholds);
    desc.thresholds = &of_all;
    FlgJobOptions urgent = flgJobOptionsDefaults();
    urgent.priority = FLG_PRIORITY_HIGH;
    desc.job = &urgent;
    std::copy(recipe.mirror.begin(), recipe.mirror.end(), desc.mirror);
    std::vector<FlgJointEdit> edits;
    for (const JointEdit& edit : recipe.joint_edits) edits.push_back(cli::described(edit));
    desc.joint_edits = edits.data();
    desc.joint_edit_count = static_cast<uint32_t>(edits.size());
    desc.apart_pairs = recipe.apart.data();
    desc.apart_pair_count = static_cast<uint32_t>(recipe.apart.size() / 2);
    // So joints keep their names, and with them their poses, while the drawing changes.
    if (!is_other_document_) desc.previous = model_.get();
    const FlgModelView kept = kept_ ? kept_->view() : flgModelViewDefaults();
    if (kept_) desc.previous_view = &kept;
    FlgModel handle{};
    if (flgModelCreate(context_.get(), &desc, &handle, nullptr) != FLG_OK) {
        model_failed_ = true;
        notices_.add(Weight::error, std::string("The bones cannot be built: ") + flgErrorGetMessage());
        return;
    }
    coming_model_ = ModelOwner(context_.get(), handle);
    coming_recipe_ = std::move(recipe);
}

void LiveModel::take_model() {
    if (!coming_model_) return;
    FlgModelView view = flgModelViewDefaults();
    const FlgResult result = flgModelGetView(context_.get(), coming_model_.get(), &view);
    if (result == FLG_NOT_READY) return;
    if (result != FLG_OK) {
        coming_model_.reset();
        // A part that failed says so itself, and is left out the next time.
        if (result == FLG_ERROR_DEPENDENCY || coming_recipe_ != wanted_) return;
        model_failed_ = true;
        notices_.add(Weight::error, std::string("The bones cannot be built: ") + flgErrorGetMessage());
        return;
    }
    model_ = std::move(coming_model_);
    coming_model_.reset();
    is_other_document_ = false;
    kept_.reset();
    recipe_ = std::move(coming_recipe_);
    std::vector<uint32_t> sources;
    for (const ModelRecipe::Part& part : recipe_.parts) sources.push_back(part.id);
    rig_ = rig_of(view, sources);
    loose_.clear();
    for (uint32_t p = 1; p < view.part_count; ++p)
        if (view.part_parents[p] == FLG_NO_INDEX && view.part_sources[p] > 0)
            loose_.push_back(sources[view.part_sources[p]]);
    ++rig_revision_;
}

void LiveModel::start_skin(uint32_t vertices) {
    FlgSkinDesc desc = flgSkinDefaults();
    desc.model = model_.get();
    desc.vertex_count = vertices;
    FlgSkin handle{};
    FlgJob job{};
    if (flgSkinCreate(context_.get(), &desc, &handle, &job) != FLG_OK) {
        skin_failed_ = true;
        notices_.add(Weight::error, std::string("The body cannot be built: ") + flgErrorGetMessage());
        return;
    }
    coming_skin_ = SkinOwner(context_.get(), handle);
    coming_skin_recipe_ = recipe_;
    coming_skinned_ = {};
    coming_skinned_.rig = rig_;
    const FlgModelView view = model();
    for (uint32_t p = 0; p < view.part_count; ++p) {
        coming_skinned_.parts.push_back(recipe_.parts[view.part_sources[p]].id);
        coming_skinned_.is_image.push_back(view.part_mirrored[p] != 0);
    }
    cli::ModelDrawing placed;
    for (const ModelRecipe::Part& part : recipe_.parts) placed.parts.emplace_back().placement = part.placement;
    coming_skinned_.motion = cli::make_test_motion(view, placed);
    coming_vertices_ = vertices;
    jobs_.add("Building the body", filigree::Job(context_.get(), job), {},
              vertices == kFineVertices ? Jobs::Shown::listed : Jobs::Shown::quiet);
}

void LiveModel::take_skin() {
    if (!coming_skin_) return;
    FlgSkinView view{};
    view.struct_size = sizeof view;
    const FlgResult result = flgSkinGetView(context_.get(), coming_skin_.get(), &view);
    if (result == FLG_NOT_READY) return;
    if (result != FLG_OK) {
        coming_skin_.reset();
        // Not again until something is changed; the jobs' list has said why.
        if (coming_skin_recipe_ == recipe_) skin_failed_ = true;
        return;
    }
    skin_ = std::move(coming_skin_);
    coming_skin_.reset();
    skin_recipe_ = std::move(coming_skin_recipe_);
    skin_vertices_ = coming_vertices_;
    skinned_ = std::move(coming_skinned_);
    skinned_.view = automatic_ = view;
    bound_.reset(), coming_bound_.reset();
    ++skin_revision_, ++shape_revision_;
}

void LiveModel::drop_skin() {
    skin_.reset(), coming_skin_.reset(), bound_.reset(), coming_bound_.reset();
    ++skin_revision_, ++shape_revision_;
}

void LiveModel::bind(const std::vector<uint16_t>& joints, const std::vector<float>& weights) {
    FlgSkinSetWeightsDesc desc = flgSkinSetWeightsDefaults();
    desc.skin = skin_.get();
    desc.vertex_count = automatic_.vertex_count;
    desc.vertex_joints = joints.data();
    desc.vertex_weights = weights.data();
    FlgSkin handle{};
    if (flgSkinSetWeights(context_.get(), &desc, &handle, nullptr) != FLG_OK)
        return notices_.add(Weight::error, std::string("The weights cannot be taken: ") + flgErrorGetMessage());
    coming_bound_ = SkinOwner(context_.get(), handle);
}

void LiveModel::take_bound() {
    if (!coming_bound_) return;
    FlgSkinView view = flgSkinViewDefaults();
    const FlgResult result = flgSkinGetView(context_.get(), coming_bound_.get(), &view);
    if (result == FLG_NOT_READY) return;
    if (result == FLG_OK) {
        bound_ = std::move(coming_bound_);
        skinned_.view = view;
        ++skin_revision_;
    } else {
        notices_.add(Weight::error, std::string("The weights cannot be taken: ") + flgErrorGetMessage());
    }
    coming_bound_.reset();
}

void LiveModel::unbind() {
    if (bound_) ++skin_revision_;
    bound_.reset(), coming_bound_.reset();
    skinned_.view = automatic_;
}

bool LiveModel::is_loose(uint32_t part) const {
    return std::find(loose_.begin(), loose_.end(), part) != loose_.end();
}

FlgModelView LiveModel::model() const {
    FlgModelView view = flgModelViewDefaults();
    if (model_) filigree::check(flgModelGetView(context_.get(), model_.get(), &view));
    return view;
}

void LiveModel::begin_with(std::unique_ptr<const cli::KeptJoints> joints) {
    is_other_document_ = true;
    kept_ = std::move(joints);
    // Made with the joints of the other one.
    coming_model_.reset();
}

nlohmann::json LiveModel::kept_joints() const {
    if (kept_) return cli::KeptJoints::json_of(kept_->view());
    return model_ && !is_other_document_ ? cli::KeptJoints::json_of(model()) : nlohmann::json();
}

bool LiveModel::wants_skin() const {
    const bool is_current = skin_ && skin_recipe_ == recipe_ && skin_vertices_ >= wanted_vertices_;
    return wanted_vertices_ > 0 && !recipe_.parts.empty() && !skin_failed_ && !is_current;
}

const LiveModel::PartState& LiveModel::state_of(const ContourPtr& contour) const {
    static const PartState none;
    const auto found = parts_.find(contour.get());
    return found == parts_.end() ? none : found->second.state;
}

const FlgPartView* LiveModel::axis_of(const ContourPtr& contour) const {
    const auto found = parts_.find(contour.get());
    return found == parts_.end() || !found->second.state.ready ? nullptr : &found->second.view;
}

size_t LiveModel::fault_count(const Drawing& drawing) const {
    return static_cast<size_t>(std::count_if(drawing.parts.begin(), drawing.parts.end(), [this](const DrawnPart& part) {
        return !state_of(part.contour).fault.empty();
    }));
}

bool LiveModel::busy() const {
    const bool has_pending_part = std::any_of(parts_.begin(), parts_.end(), [](const auto& entry) {
        return !entry.second.state.ready && entry.second.state.fault.empty();
    });
    const bool wants_model = !wanted_.parts.empty() && !model_failed_ && wanted_ != recipe_;
    return has_pending_part || coming_model_ || coming_skin_ || wants_model || wants_skin();
}

}  // namespace flg::studio
