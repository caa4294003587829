// SPDX-License-Identifier: MIT
#include "skeletons/model_picture.h"

#include <algorithm>
#include <utility>

namespace flg::studio {
namespace {

// Of the house: bone, red, gold.
constexpr glm::vec3 kBone{0.90f, 0.88f, 0.80f}, kJoint{0.66f, 0.035f, 0.020f}, kChosen{0.95f, 0.50f, 0.03f},
    kBright{1.0f, 0.85f, 0.25f};
constexpr float kBrightSize = 1.5f, kChosenGlow = 1.25f;
// Shares of a joint's ball.
constexpr float kBoneWide = 0.5f, kBoneThin = 0.22f;
// A ball is a tube as short as this, in its radius, with round ends.
constexpr float kBallLength = 0.02f;

class Tubes {
public:
    void add(const glm::vec3& from, const glm::vec3& to, float from_radius, float to_radius, const glm::vec3& color) {
        for (const glm::vec3& p : {from, to}) {
            positions_.insert(positions_.end(), {p.x, p.y, p.z});
            colors_.insert(colors_.end(), {color.x, color.y, color.z, 1.0f});
        }
        radii_.insert(radii_.end(), {from_radius, to_radius});
        offsets_.push_back(offsets_.back() + 2);
    }
    bool empty() const { return radii_.empty(); }
    void show(render::Renderer& renderer, render::CurvesId& id) const {
        const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions_.data(), 0, 0},
                                     {FLG_ATTRIBUTE_RADIUS, 1, radii_.data(), 0, 0},
                                     {FLG_ATTRIBUTE_COLOR, 4, colors_.data(), 0, 0}};
        FlgCurveSetView view = flgCurveSetViewDefaults();
        view.curve_count = static_cast<uint32_t>(offsets_.size() - 1);
        view.curve_offsets = offsets_.data();
        view.columns = columns;
        view.column_count = 3;
        render::CurveLook look;
        look.shape = render::Shape::tube;
        look.casts_shadow = false;
        look.in_front = true;
        if (id.value == 0)
            id = renderer.upload(view, look);
        else
            renderer.update(id, view, look);
    }

private:
    std::vector<float> positions_, radii_, colors_;
    std::vector<uint32_t> offsets_{0};
};

}  // namespace

ModelPicture::~ModelPicture() {
    renderer_.remove(body_);
    renderer_.remove(shape_);
    renderer_.remove(bones_);
}

bool ModelPicture::show_body(const LiveModel::Skinned* skin, uint64_t revision, const Drawing& drawing,
                             uint32_t selected) {
    if (skin == nullptr) {
        renderer_.remove(std::exchange(body_, {}));
        return false;
    }
    render::SurfaceLook look;
    for (const uint32_t id : skin->parts) {
        render::Material& material = look.regions.emplace_back();
        if (const DrawnPart* part = drawing.find(id)) {
            const float glow = id == selected ? kChosenGlow : 1.0f;
            material.color = glm::min(glow * part->color, 1.0f);
            material.metallic = part->metallic;
            material.roughness = part->roughness;
        }
    }
    const bool looks_same =
        std::equal(look.regions.begin(), look.regions.end(), materials_.begin(), materials_.end(),
                   [](const render::Material& a, const render::Material& b) {
                       return a.color == b.color && a.metallic == b.metallic && a.roughness == b.roughness;
                   });
    if (body_.value != 0 && revision == body_revision_ && looks_same) return false;
    if (body_.value == 0)
        body_ = renderer_.upload(skin->view, look);
    else
        renderer_.update(body_, skin->view, look);
    renderer_.set_visible(body_, is_body_visible_);
    body_revision_ = revision;
    materials_ = std::move(look.regions);
    return true;
}

void ModelPicture::show_shape(const LiveModel::Skinned& skin, std::span<const float> positions,
                              std::span<const float> field, const std::array<uint64_t, 3>& revision) {
    if (shape_.value != 0 && revision == shape_revision_) return;
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0}};
    FlgMeshView mesh = flgMeshViewDefaults();
    mesh.vertex_count = skin.view.vertex_count;
    mesh.triangle_count = skin.view.triangle_count;
    mesh.columns = columns;
    mesh.column_count = 1;
    mesh.triangles = skin.view.triangles;
    render::SurfaceLook look;
    if (field.empty()) {
        mesh.regions = skin.view.triangle_parts;
        look.regions = materials_;
    } else {
        look.field_low = 0.0f;
        look.field_high = 1.0f;
        look.material.roughness = 0.9f;
    }
    if (shape_.value == 0)
        shape_ = renderer_.upload(mesh, look, field);
    else
        renderer_.update(shape_, mesh, look, field);
    shape_revision_ = revision;
}

void ModelPicture::hide_shape() {
    renderer_.remove(std::exchange(shape_, {}));
}

void ModelPicture::pose_body(FlgSkinning skinning, std::span<const float> transforms) {
    if (body_.value != 0) renderer_.set_pose(body_, skinning, transforms);
}

void ModelPicture::set_body_visible(bool visible) {
    if (std::exchange(is_body_visible_, visible) == visible) return;
    if (body_.value != 0) renderer_.set_visible(body_, visible);
}

void ModelPicture::device_lost() {
    body_ = {};
    shape_ = {};
    bones_ = {};
}

void ModelPicture::show_bones(const Rig& rig, uint64_t revision, const std::vector<glm::vec3>& at,
                              const BonesLook& look) {
    if (rig.count() == 0) return renderer_.remove(std::exchange(bones_, {}));
    if (bones_.value != 0 && revision == bones_revision_ && at == bones_at_ && look == bones_look_) return;
    bones_revision_ = revision;
    bones_at_ = at;
    bones_look_ = look;
    Tubes tubes;
    for (size_t j = 0; j < rig.count(); ++j) {
        const bool is_bright = std::find(look.bright.begin(), look.bright.end(), j) != look.bright.end();
        const float radius = joint_radius(rig, j) * (is_bright ? kBrightSize : 1.0f);
        const glm::vec3 half(0.5f * kBallLength * radius, 0.0f, 0.0f);
        const bool is_chosen = rig.parts[j] == look.selected_part;
        tubes.add(at[j] - half, at[j] + half, radius, radius, is_bright ? kBright : is_chosen ? kChosen : kJoint);
        const uint32_t parent = rig.parents[j];
        if (parent == FLG_NO_INDEX) continue;
        tubes.add(at[parent], at[j], kBoneWide * radius, kBoneThin * radius, is_bright ? kBright : kBone);
    }
    tubes.show(renderer_, bones_);
}

float joint_radius(const Rig& rig, size_t joint) {
    // Shares of the model's size; those of small parts are smaller.
    constexpr float kLeast = 0.0030f, kMost = 0.0056f;
    return std::clamp(0.35f * rig.radii[joint], kLeast * rig.size, kMost * rig.size);
}

}  // namespace flg::studio
