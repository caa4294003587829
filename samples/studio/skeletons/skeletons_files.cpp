// SPDX-License-Identifier: MIT
// What the workspace reads and writes.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "filigree/filigree_io.h"
#include "skeletons/drawing_file.h"
#include "skeletons/image_file.h"
#include "skeletons/skeletons.h"

namespace flg::studio {
namespace {

bool ends_with(std::string path, const char* end) {
    std::transform(path.begin(), path.end(), path.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return path.ends_with(end);
}

// Others have .json files too.
bool is_drawing(const std::string& path) {
    std::ifstream file(path);
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    return json.is_object() && json.contains("parts");
}

constexpr Workspace::Export kExports[] = {{"Model", ".glb"}, {"Drawing", ".json"}};

}  // namespace

void Skeletons::open_picture(const std::string& path) {
    constexpr double kOfView = 0.85;
    const ImageSize size = image_size(path);
    editor_.commit();
    // Before it is seen for the first time there is no camera to go by.
    if (wants_frame_ && app_.view.viewport.z > 1) {
        frame_drawing({0.0f, 0.0f, -1.0f});
        wants_frame_ = false;
    }
    const glm::vec3& aim = app_.view.orbit.camera.target;
    const double metres = static_cast<double>(app_.view.metres_per_px({aim.x, aim.y, 0.0f}));
    const double fit = std::min(static_cast<double>(app_.view.viewport.w),
                                app_.view.viewport.z * static_cast<double>(size.height) / size.width);
    TracedPicture& picture = editor_.change("picture").picture;
    picture.path = std::filesystem::absolute(path).string();
    picture.centre = {aim.x, aim.y};
    picture.height = std::clamp(kOfView * fit * metres, 0.1, 100.0);
    editor_.commit();
}

bool Skeletons::open(const std::string& path) {
    if (ends_with(path, ".png") || ends_with(path, ".jpg") || ends_with(path, ".jpeg")) {
        open_picture(path);
        set_mode(Mode::draw);
        return true;
    }
    const bool is_contour = ends_with(path, ".txt") || (is_in_front_ && ends_with(path, ".svg"));
    if (!is_contour && !(ends_with(path, ".json") && is_drawing(path))) return false;
    std::vector<std::string> warnings;
    Drawing drawing = read_drawing(path, warnings);
    for (const std::string& warning : warnings) editor_.app.notices.add(Weight::warning, warning);
    drop_tools();
    if (is_contour) {
        editor_.add(std::move(drawing.parts), MirrorAs::single);
    } else {
        // The picture and what is drawn over it stay together.
        drawing.picture = editor_.drawing().picture;
        editor_.open(std::move(drawing));
    }
    wants_frame_ = true;
    return true;
}

nlohmann::json Skeletons::save() const {
    nlohmann::json json = document_json(editor_.drawing());
    json["mode"] = static_cast<int>(mode_);
    if (nlohmann::json joints = editor_.live.kept_joints(); !joints.is_null()) json["joints"] = std::move(joints);
    return json;
}

void Skeletons::load(const nlohmann::json& part) {
    Drawing drawing = drawing_of_document(part);
    std::unique_ptr<const cli::KeptJoints> joints = joints_of_document(part);
    drop_tools();
    play(false);
    was_played_ = false;
    editor_.replace(std::move(drawing));
    editor_.live.begin_with(std::move(joints));
    const int mode = part.contains("mode") && part["mode"].is_number_integer() ? part["mode"].get<int>() : 0;
    mode_ = static_cast<Mode>(std::clamp(mode, 0, static_cast<int>(Mode::pull)));
    draw_.depth = 0.0f;
    wants_frame_ = true;
    own_camera_.reset();
}

std::span<const Workspace::Export> Skeletons::exports() const {
    return kExports;
}

void Skeletons::write(const Export& what, const std::string& path) {
    if (std::string(what.extension) == ".json") {
        write_drawing(editor_.drawing(), path);
        const Drawing& drawing = editor_.drawing();
        if (!drawing.weight_strokes.empty() || !drawing.pulls.pins.empty() || drawing.pulls.record)
            app_.notices.add(Weight::info,
                             "Drawings keep no painted weights and no pins. The document and the model (.glb) have the "
                             "weights, the document has the pins.");
        return;
    }
    const LiveModel::Skinned* skin = editor_.live.skin();
    if (skin == nullptr) throw StudioError("There is no body to export. Draw a part first.");
    if (editor_.live.busy() || editor_.live.is_binding() || weights_.busy())
        throw StudioError("The body is still being built. Export again when it is done.");
    const Pose& pose = editor_.drawing().pose;
    std::vector<FlgSkinAnimation> animations;
    const float start = 0.0f;
    std::vector<float> rotations;
    for (const glm::quat& turn : turns_of(skin->rig, pose))
        rotations.insert(rotations.end(), {turn.x, turn.y, turn.z, turn.w});
    if (!pose.is_rest()) {
        FlgSkinAnimation& animation = animations.emplace_back(flgSkinAnimationDefaults());
        animation.name = "pose";
        animation.key_count = 1;
        animation.times = &start;
        animation.rotations = rotations.data();
        animation.translations = &pose.shift.x;
    }
    if (was_played_) animations.push_back(skin->motion.animation());
    std::vector<std::string> names;
    std::vector<FlgMeshMaterial> materials;
    for (const uint32_t id : skin->parts) {
        const DrawnPart* part = editor_.drawing().find(id);
        const DrawnPart shown = part ? *part : DrawnPart{};
        names.push_back(shown.name);
        FlgMeshMaterial& material = materials.emplace_back(flgMeshMaterialDefaults());
        for (int k = 0; k < 3; ++k) material.color[k] = std::clamp(shown.color[k], 0.0f, 1.0f);
        material.metallic = shown.metallic;
        material.roughness = shown.roughness;
    }
    for (size_t m = 0; m < materials.size(); ++m) materials[m].name = names[m].c_str();
    FlgSkinFileWriteDesc desc{};
    if (flgSkinFileWriteDescInit(&desc, sizeof desc) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
    desc.skin = &skin->view;
    desc.animations = animations.data();
    desc.animation_count = static_cast<uint32_t>(animations.size());
    desc.materials = materials.data();
    desc.material_count = static_cast<uint32_t>(materials.size());
    if (flgSkinFileWrite(path.c_str(), &desc) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
}

}  // namespace flg::studio
