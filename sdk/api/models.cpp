// SPDX-License-Identifier: MIT
// Parts and models: made, shown, released.
#include <cmath>
#include <unordered_set>

#include "api/contour_inputs.h"
#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/thresholds.h"
#include "bones/model.h"

namespace flg {

namespace {

constexpr uint32_t max_parts = 4096;
constexpr uint32_t max_joint_edits = 65535, max_apart_pairs = 65535, max_kept_joints = 65535;
constexpr size_t max_name = 63;
constexpr double shear_limit = 1e-4;  // of the scale

FlgPartDesc default_part_desc() {
    auto desc = sized<FlgPartDesc>();
    desc.spacing = default_spacing;
    desc.tolerance = 0.0015;
    desc.collapse = 0.5;
    return desc;
}

FlgModelPart default_model_part() {
    auto part = sized<FlgModelPart>();
    part.placement[0] = part.placement[5] = part.placement[10] = 1;
    part.thickness = 1;
    part.parent = FLG_NO_INDEX;
    return part;
}

FlgModelDesc default_model_desc() {
    auto desc = sized<FlgModelDesc>();
    desc.shape_weight = 0.25f;
    desc.mirror[0] = 1;
    desc.root = FLG_NO_INDEX;
    return desc;
}

FlgJointEdit default_joint_edit() {
    auto edit = sized<FlgJointEdit>();
    edit.kind = FLG_JOINT_EDIT_KIND_PIN;
    edit.share = 0.5;
    return edit;
}

// The scale of a placement that turns, scales and moves, mirrored or not.
double read_placement(const double (&placement)[12], uint32_t part, Eigen::Matrix<double, 3, 4>& out) {
    char name[48];
    for (int i = 0; i < 12; ++i) {
        std::snprintf(name, sizeof name, "desc.parts[%u].placement[%d]", part, i);
        check_range(std::abs(placement[i]) <= 1e30, name, placement[i], "finite and at most 1e30 in size");
        out(i / 4, i % 4) = placement[i];
    }
    const double scale = out.col(0).norm();
    const Eigen::Matrix3d turn = out.leftCols<3>();
    const double off = (turn.transpose() * turn - scale * scale * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(scale > 1e-30) || off > shear_limit * scale * scale)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.parts[%u].placement does more than turn, mirror, move and scale by one factor above 0",
                      part);
    return scale;
}

ModelPart read_part(Context& context, const FlgModelPart& in, const FlgBoneThresholds& thresholds, uint32_t number,
                    Submission& submission) {
    char name[64];
    const auto field = [&](const char* member) {
        std::snprintf(name, sizeof name, "desc.parts[%u].%s", number, member);
        return name;
    };
    ModelPart out(context.memory[MemoryKind::models]);
    out.part = context.parts.get(in.part.id, field("part"));
    out.source = number;
    out.thickness = in.thickness;
    out.thresholds = read_thresholds(in.thresholds, thresholds, field("thresholds"));
    submission.read(*out.part, field("part"));
    out.scale = read_placement(in.placement, number, out.placement);
    check_range(in.thickness >= 0.01f && in.thickness <= 100, field("thickness"), in.thickness, "0.01 to 100");
    if (in.branch_simplify) {
        for (uint32_t b = 0; b < in.branch_count; ++b) {
            check_range(in.branch_simplify[b] <= 10, field("branch_simplify"), in.branch_simplify[b], "at most 10");
            out.branch_simplify.push_back(in.branch_simplify[b]);
        }
    }
    char default_name[16];
    std::snprintf(default_name, sizeof default_name, "part%u", number);
    out.name = in.name ? in.name : default_name;
    check_range(std::isfinite(in.depth), field("depth"), in.depth, "finite");
    out.depth = in.depth;
    std::array<double, 4>& picture = out.picture;
    for (uint32_t k = 0; k < picture.size(); ++k) {
        check_range(std::abs(in.picture[k]) <= 1e30, field("picture"), in.picture[k],
                    "finite and at most 1e30 in size");
        picture[k] = in.picture[k];
    }
    if (picture != std::array<double, 4>{} && !(picture[0] < picture[2] && picture[1] < picture[3]))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.parts[%u].picture is %g to %g by %g to %g: left and bottom must come first", number,
                      picture[0], picture[2], picture[1], picture[3]);
    out.parent = in.parent;
    if (in.parent_joint) out.parent_joint = in.parent_joint;
    if (out.name.empty() || out.name.size() > max_name)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.parts[%u].name has %zu bytes, must have 1 to %zu", number,
                      out.name.size(), max_name);
    return out;
}

void read_mirror(const float (&mirror)[4], HeldModel& model) {
    for (int i = 0; i < 4; ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "desc.mirror[%d]", i);
        check_range(is_coordinate(mirror[i]), name, mirror[i], "finite and at most 1e30 in size");
    }
    const Vec3 normal = load_vec3(mirror);
    if (!(normal.norm() > 1e-30)) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.mirror has a normal of no length");
    model.mirror_normal = normal.normalized();
    model.mirror_offset = mirror[3] / normal.norm();
}

// Puts a part on the other side of the mirror.
void mirror_part(ModelPart& part, const HeldModel& model) {
    const Vec3& n = model.mirror_normal;
    part.placement = (part.placement - 2 * n * (n.transpose() * part.placement)).eval();
    part.placement.col(3) += 2 * model.mirror_offset * n;
    part.is_mirrored = true;
}

// Hosts count their own parts; here mirror images count too. An image hangs on an image if there is one.
void read_parents(uint32_t part_count, HeldModel& model, Memory* memory) {
    std::pmr::vector<uint32_t> number(part_count, 0, memory);
    for (uint32_t p = static_cast<uint32_t>(model.parts.size()); p-- > 0;) number[model.parts[p].source] = p;
    const auto check_part = [&](uint32_t index, const char* argument) {
        check_range(index < part_count, argument, index, "the index of a part, or FLG_NO_INDEX");
    };
    for (uint32_t p = 0; p < model.parts.size(); ++p) {
        ModelPart& part = model.parts[p];
        if (part.parent == no_number) {
            if (!part.parent_joint.empty())
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.parts[%u].parent_joint needs a parent", part.source);
            continue;
        }
        char field[48];
        std::snprintf(field, sizeof field, "desc.parts[%u].parent", part.source);
        check_part(part.parent, field);
        if (part.parent == part.source) {
            part.parent = p;
            continue;
        }
        const uint32_t parent = number[part.parent];
        part.parent = part.is_mirrored && model.parts[parent].twin != no_number ? parent + 1 : parent;
    }
    for (uint32_t p = 0; p < model.parts.size(); ++p) {
        uint32_t at = p;
        for (uint32_t steps = 0; at != no_number && model.parts[at].parent != at; at = model.parts[at].parent) {
            if (++steps > model.parts.size())
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "desc.parts[%u].parent makes a cycle: %s would hang on itself", model.parts[at].source,
                              model.parts[at].name.c_str());
        }
    }
    if (model.root == no_number) return;
    check_part(model.root, "desc.root");
    model.root = number[model.root];
    const ModelPart& root = model.parts[model.root];
    if (root.parent != no_number && root.parent != model.root)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.root is %s, which has a parent: desc.parts[%u].parent is set",
                      root.name.c_str(), root.source);
}

// Pairs of the host's parts, with all their images.
void read_apart_pairs(const FlgModelDesc& desc, HeldModel& model) {
    check_range(desc.apart_pair_count <= max_apart_pairs, "desc.apart_pair_count", desc.apart_pair_count,
                "at most 65535");
    if (desc.apart_pair_count > 0) require(desc.apart_pairs, "desc.apart_pairs");
    std::pmr::vector<uint32_t> number(desc.part_count, 0, model.apart.get_allocator());
    for (uint32_t p = static_cast<uint32_t>(model.parts.size()); p-- > 0;) number[model.parts[p].source] = p;
    for (uint32_t i = 0; i < 2 * desc.apart_pair_count; i += 2) {
        const uint32_t pair[] = {desc.apart_pairs[i], desc.apart_pairs[i + 1]};
        for (uint32_t k = 0; k < 2; ++k) {
            char field[48];
            std::snprintf(field, sizeof field, "desc.apart_pairs[%u]", i + k);
            check_range(pair[k] < desc.part_count, field, pair[k], "the index of a part");
        }
        const uint32_t first = number[pair[0]], second = number[pair[1]];
        const uint32_t first_end = first + (model.parts[first].twin != no_number ? 2 : 1),
                       second_end = second + (model.parts[second].twin != no_number ? 2 : 1);
        for (uint32_t a = first; a < first_end; ++a)
            for (uint32_t b = second; b < second_end; ++b)
                if (first != second || a < b) model.apart.push_back({a, b});
    }
}

JointEdit read_joint_edit(const FlgJointEdit& in, uint32_t number, Memory* memory) {
    constexpr size_t longest = 127;
    char name[64];
    const auto field = [&](const char* member) {
        std::snprintf(name, sizeof name, "desc.joint_edits[%u].%s", number, member);
        return name;
    };
    JointEdit out(memory);
    check_enum(in.kind, FLG_JOINT_EDIT_KIND_PIN, FLG_JOINT_EDIT_KIND_RENAME, field("kind"), "FLG_JOINT_EDIT_KIND_");
    out.kind = in.kind;
    const auto read_text = [&](const char* text, const char* member, std::pmr::string& to) {
        require(text, field(member));
        to = text;
        if (to.empty() || to.size() > longest)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s has %zu bytes, must have 1 to %zu", field(member), to.size(),
                          longest);
    };
    read_text(in.joint, "joint", out.joint);
    if (in.kind == FLG_JOINT_EDIT_KIND_SPLIT || in.kind == FLG_JOINT_EDIT_KIND_RENAME)
        read_text(in.name, "name", out.name);
    for (int i = 0; i < 3; ++i) {
        check_range(std::abs(in.at[i]) <= 1e30, field("at"), in.at[i], "finite and at most 1e30 in size");
        out.at[i] = in.at[i];
    }
    check_range(in.kind != FLG_JOINT_EDIT_KIND_SPLIT || (in.share > 0 && in.share < 1), field("share"), in.share,
                "between 0 and 1");
    out.share = in.share;
    return out;
}

// Of a view that a host filled: what joints are known by.
void read_kept_joints(const FlgModelView& in, HeldModel& model) {
    constexpr size_t longest = 255;
    if (model.previous) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.previous and desc.previous_view are both set");
    const FlgModelView view = read_struct(&in, sized<FlgModelView>(), "desc.previous_view");
    check_range(view.joint_count <= max_kept_joints, "desc.previous_view.joint_count", view.joint_count,
                "at most 65535");
    if (view.joint_count == 0) return;
    require(view.joint_keys, "desc.previous_view.joint_keys");
    require(view.joint_places, "desc.previous_view.joint_places");
    require(view.joint_parents, "desc.previous_view.joint_parents");
    model.kept_joints.reserve(view.joint_count);
    for (uint32_t j = 0; j < view.joint_count; ++j) {
        char name[64];
        const auto field = [&](const char* member) {
            std::snprintf(name, sizeof name, "desc.previous_view.%s[%u]", member, j);
            return name;
        };
        require(view.joint_keys[j], field("joint_keys"));
        const size_t length = strnlen(view.joint_keys[j], longest + 1);
        if (length == 0 || length > longest)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s has %s bytes, must have 1 to %zu", field("joint_keys"),
                          length == 0 ? "0" : "more", longest);
        for (size_t k = 0; k < 2; ++k)
            check_range(std::abs(view.joint_places[3 * size_t{j} + k]) <= 1e30, field("joint_places"),
                        view.joint_places[3 * size_t{j} + k], "finite and at most 1e30 in size");
        const uint32_t parent = view.joint_parents[j];
        check_range(parent < j || parent == FLG_NO_INDEX, field("joint_parents"), parent,
                    "a joint before it or FLG_NO_INDEX");
        model.kept_joints.push_back({std::pmr::string(view.joint_keys[j], length, model.kept_joints.get_allocator()),
                                     {view.joint_places[3 * size_t{j}], view.joint_places[3 * size_t{j} + 1]},
                                     parent});
    }
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgPartDescInit(FlgPartDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_part_desc());
}

FlgResult flgPartCreate(FlgContext context, const FlgPartDesc* desc, FlgPart* out_part, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_part, "out_part", out_job);
        Memory* const memory = self.memory[MemoryKind::models];
        const FlgPartDesc read = read_struct(desc, default_part_desc(), "desc");
        check_range(read.spacing == 0 || (read.spacing >= 0.0005 && read.spacing <= 0.1), "desc.spacing", read.spacing,
                    "0, or 0.0005 to 0.1");
        check_range(read.tolerance >= 0 && read.tolerance <= 0.1, "desc.tolerance", read.tolerance, "0 to 0.1");
        check_range(read.collapse >= 0 && read.collapse <= 10, "desc.collapse", read.collapse, "0 to 10");
        Submission submission(self, read.job);
        const bool repair = read.repair != 0;
        const auto out = make_object<HeldPart>(memory, read_contour(read.contour, memory, repair), memory);
        out->repair = repair;
        out->change.input = read.contour->point_count;
        out->spacing = read.spacing;
        out->tolerance = read.tolerance;
        out->collapse = read.collapse;
        submission.job().strand.start(make_part(submission.pace(), out));
        *out_part = {submission.commit(self.parts, out, out_job)};
    });
}

FlgResult flgPartViewInit(FlgPartView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgPartGetView(FlgContext context, FlgPart part, FlgPartView* out_view) {
    return get_view(out_view, [&] { return get_context(context).parts.get(part.id, "part"); });
}

FlgResult flgPartRelease(FlgContext context, FlgPart part) {
    return release(context, &Context::parts, part, "part");
}

FlgResult flgBoneThresholdsInit(FlgBoneThresholds* thresholds, uint32_t struct_size) {
    return init(thresholds, struct_size, default_thresholds(), "thresholds");
}

FlgResult flgModelPartInit(FlgModelPart* part, uint32_t struct_size) {
    return init(part, struct_size, default_model_part(), "part");
}

FlgResult flgJointEditInit(FlgJointEdit* edit, uint32_t struct_size) {
    return init(edit, struct_size, default_joint_edit(), "edit");
}

FlgResult flgModelDescInit(FlgModelDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_model_desc());
}

FlgResult flgModelCreate(FlgContext context, const FlgModelDesc* desc, FlgModel* out_model, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_model, "out_model", out_job);
        Memory* const memory = self.memory[MemoryKind::models];
        const FlgModelDesc read = read_struct(desc, default_model_desc(), "desc");
        check_range(read.part_count >= 1 && read.part_count <= max_parts, "desc.part_count", read.part_count,
                    "1 to 4096");
        require(read.parts, "desc.parts");
        check_range(read.shape_weight >= 0 && read.shape_weight <= 100, "desc.shape_weight", read.shape_weight,
                    "0 to 100");
        Submission submission(self, read.job);
        const auto out = make_object<HeldModel>(memory, memory);
        out->origin = read_origin(read.origin, "desc.origin");
        out->thresholds = read_thresholds(read.thresholds, default_thresholds(), "desc.thresholds");
        out->shape_weight = read.shape_weight;
        read_mirror(read.mirror, *out);
        std::pmr::unordered_set<std::pmr::string> names(memory);
        for (uint32_t p = 0; p < read.part_count; ++p) {
            char place[32];
            std::snprintf(place, sizeof place, "desc.parts[%u]", p);
            const FlgModelPart part = read_element(read.parts, p, default_model_part(), place);
            out->parts.push_back(read_part(self, part, out->thresholds, p, submission));
            if (!names.insert(out->parts.back().name).second)
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.parts[%u].name is \"%s\", as that of a part before", p,
                              out->parts.back().name.c_str());
            if (!part.mirrored) continue;
            const auto original = static_cast<uint32_t>(out->parts.size()) - 1;
            out->parts.push_back(read_part(self, part, out->thresholds, p, submission));
            mirror_part(out->parts.back(), *out);
            out->parts[original].twin = original + 1;
            out->parts[original + 1].twin = original;
        }
        out->root = read.root;
        if (read.root_joint) out->root_joint = read.root_joint;
        read_parents(read.part_count, *out, memory);
        read_apart_pairs(read, *out);
        check_range(read.joint_edit_count <= max_joint_edits, "desc.joint_edit_count", read.joint_edit_count,
                    "at most 65535");
        if (read.joint_edit_count > 0) require(read.joint_edits, "desc.joint_edits");
        for (uint32_t e = 0; e < read.joint_edit_count; ++e) {
            char place[40];
            std::snprintf(place, sizeof place, "desc.joint_edits[%u]", e);
            out->edits.push_back(
                read_joint_edit(read_element(read.joint_edits, e, default_joint_edit(), place), e, memory));
        }
        if (read.previous.id != 0) {
            out->previous = self.models.get(read.previous.id, "desc.previous");
            submission.read(*out->previous, "desc.previous");
        }
        if (read.previous_view) read_kept_joints(*read.previous_view, *out);
        submission.job().strand.start(make_model(submission.pace(), out));
        *out_model = {submission.commit(self.models, out, out_job)};
    });
}

FlgResult flgModelViewInit(FlgModelView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgModelGetView(FlgContext context, FlgModel model, FlgModelView* out_view) {
    return get_view(out_view, [&] { return get_context(context).models.get(model.id, "model"); });
}

FlgResult flgModelRelease(FlgContext context, FlgModel model) {
    return release(context, &Context::models, model, "model");
}

}  // extern "C"
