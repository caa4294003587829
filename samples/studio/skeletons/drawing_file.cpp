// SPDX-License-Identifier: MIT
#include "skeletons/drawing_file.h"

#include <algorithm>
#include <cmath>

#include "documents/failure.h"
#include "documents/model_drawing.h"
#include "shell/document.h"
#include "shell/studio_error.h"

namespace flg::studio {
namespace {

bool are_same(const FlgBoneThresholds& a, const FlgBoneThresholds& b) {
    return a.simplify == b.simplify && a.merge == b.merge && a.prune == b.prune && a.collapse == b.collapse &&
           a.detail == b.detail;
}

ContourPtr contour_of(const cli::ContourArrays& arrays) {
    auto contour = std::make_shared<Contour>();
    for (size_t r = 0; r + 1 < arrays.offsets.size(); ++r) {
        Ring& ring = contour->rings.emplace_back();
        for (size_t i = arrays.offsets[r]; i < arrays.offsets[r + 1]; ++i)
            ring.emplace_back(arrays.points[2 * i], arrays.points[2 * i + 1]);
    }
    return contour;
}

DrawnPart part_of(const cli::DrawnPart& from, const FlgBoneThresholds& of_all) {
    DrawnPart part;
    part.name = from.name;
    part.contour = contour_of(from.contour);
    set_placement(part, from.placement);
    part.thickness = from.thickness;
    part.depth = from.depth;
    part.mirrored = from.is_mirrored;
    part.color = {from.material.color[0], from.material.color[1], from.material.color[2]};
    part.metallic = from.material.metallic;
    part.roughness = from.material.roughness;
    if (from.thresholds && !are_same(*from.thresholds, of_all)) part.thresholds = from.thresholds;
    return part;
}

Drawing drawing_of(const cli::ModelDrawing& from) {
    Drawing drawing;
    drawing.mirror = {from.mirror[0], from.mirror[1], from.mirror[2], from.mirror[3]};
    drawing.thresholds = from.thresholds;
    drawing.apart = from.apart;
    for (const cli::JointEdit& edit : from.joint_edits)
        drawing.joint_edits.push_back({edit.kind, edit.joint, edit.name, edit.at, edit.share});
    for (const cli::DrawnPart& part : from.parts) {
        drawing.parts.push_back(part_of(part, from.thresholds));
        drawing.parts.back().name = drawing.free_name(part.name, drawing.parts.back().id);
        drawing.parts.back().id = static_cast<uint32_t>(drawing.parts.size());
    }
    return drawing;
}

// Contours of files come in pixels as well as in metres. All of a set must get the same scale, whatever their own size.
void take_pixels(Drawing& drawing) {
    constexpr double kLargest = 20.0, kPixel = 0.01;  // metres
    glm::dvec2 low = drawing.parts[0].contour->rings[0][0], high = low;
    for (const DrawnPart& part : drawing.parts)
        for (const glm::dvec2& p : part.contour->rings[0]) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    if (glm::distance(low, high) <= kLargest) return;
    for (DrawnPart& part : drawing.parts) {
        part.scale *= kPixel;
        part.at *= kPixel;
    }
}

nlohmann::json numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

void put_thresholds(nlohmann::json& json, const FlgBoneThresholds& thresholds) {
    json["simplify"] = thresholds.simplify;
    json["merge"] = thresholds.merge;
    json["prune"] = thresholds.prune;
    json["collapse"] = thresholds.collapse;
    json["detail"] = thresholds.detail;
}

nlohmann::json part_json(const DrawnPart& part) {
    nlohmann::json json = {{"name", part.name},
                           {"at", numbers(part.at)},
                           {"turn", numbers(part.turn)},
                           {"scale", part.scale},
                           {"thickness", part.thickness},
                           {"mirrored", part.mirrored},
                           {"color", numbers(part.color)},
                           {"metallic", part.metallic},
                           {"roughness", part.roughness}};
    nlohmann::json rings = nlohmann::json::array();
    for (const Ring& ring : part.contour->rings) {
        nlohmann::json& points = rings.emplace_back(nlohmann::json::array());
        for (const glm::dvec2& p : ring) points.push_back({p.x, p.y});
    }
    json["contour"] = std::move(rings);
    if (part.thresholds) put_thresholds(json, *part.thresholds);
    if (part.depth != 0.0f) json["depth"] = part.depth;
    return json;
}

nlohmann::json edit_json(const JointEdit& edit) {
    switch (edit.kind) {
        case FLG_JOINT_EDIT_KIND_PIN: return {{"joint", edit.joint}, {"edit", "pin"}, {"at", edit.at}};
        case FLG_JOINT_EDIT_KIND_SPLIT:
            return {{"joint", edit.joint}, {"edit", "split"}, {"name", edit.name}, {"share", edit.share}};
        case FLG_JOINT_EDIT_KIND_MERGE: return {{"joint", edit.joint}, {"edit", "merge"}};
        default: return {{"joint", edit.joint}, {"edit", "rename"}, {"name", edit.name}};
    }
}

nlohmann::json place_json(const BodyPlace& place) {
    return {place.part, place.is_image, place.at.x, place.at.y, place.at.z};
}

BodyPlace place_of(const nlohmann::json& json) {
    return {json.at(0).get<std::string>(),
            json.at(1).get<bool>(),
            {json.at(2).get<double>(), json.at(3).get<double>(), json.at(4).get<double>()}};
}

nlohmann::json numbers(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

glm::vec3 vector_of(const nlohmann::json& json) {
    return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

constexpr const char* kBrushNames[] = {"add", "subtract", "smooth"};

nlohmann::json stroke_json(const WeightStroke& stroke) {
    nlohmann::json json = {{"brush", kBrushNames[static_cast<size_t>(stroke.brush)]},
                           {"joint", stroke.joint},
                           {"strength", stroke.strength}};
    if (!stroke.mirror_joint.empty()) json["mirror_joint"] = stroke.mirror_joint;
    json["dabs"] = nlohmann::json::array();
    for (const WeightDab& dab : stroke.dabs) {
        nlohmann::json place = place_json(dab.place);
        place.push_back(dab.radius);
        place.push_back(dab.is_mirror);
        json["dabs"].push_back(std::move(place));
    }
    return json;
}

WeightStrokePtr stroke_of(const nlohmann::json& json) {
    WeightStroke stroke;
    const std::string brush = json.at("brush").get<std::string>();
    for (size_t b = 0; b < std::size(kBrushNames); ++b)
        if (brush == kBrushNames[b]) stroke.brush = static_cast<WeightBrush>(b);
    stroke.joint = json.at("joint").get<std::string>();
    stroke.mirror_joint = json.value("mirror_joint", std::string());
    stroke.strength = std::clamp(json.at("strength").get<float>(), 0.0f, 1.0f);
    for (const nlohmann::json& dab : json.at("dabs"))
        stroke.dabs.push_back({place_of(dab), std::max(dab.at(5).get<double>(), 0.0), dab.at(6).get<bool>()});
    return std::make_shared<const WeightStroke>(std::move(stroke));
}

nlohmann::json pulls_json(const Pulls& pulls) {
    nlohmann::json json = nlohmann::json::object();
    for (const PullPin& pin : pulls.pins) json["pins"].push_back({place_json(pin.place), numbers(pin.by)});
    if (!pulls.record) return json;
    for (const BodyPlace& place : pulls.record->places) json["places"].push_back(place_json(place));
    for (const PullRecord::Key& key : pulls.record->keys) {
        nlohmann::json held = nlohmann::json::array();
        for (const auto& [place, by] : key.by) held.push_back({place, by.x, by.y, by.z});
        json["keys"].push_back({key.seconds, std::move(held)});
    }
    return json;
}

Pulls pulls_of(const nlohmann::json& json) {
    Pulls pulls;
    if (json.contains("pins"))
        for (const nlohmann::json& pin : json["pins"])
            pulls.pins.push_back({place_of(pin.at(0)), vector_of(pin.at(1))});
    if (!json.contains("keys")) return pulls;
    PullRecord record;
    for (const nlohmann::json& place : json.at("places")) record.places.push_back(place_of(place));
    for (const nlohmann::json& from : json["keys"]) {
        PullRecord::Key key{from.at(0).get<float>(), {}};
        if (key.seconds < record.length())
            throw StudioError("The keys of a pulled body are not in the order of their times.");
        for (const nlohmann::json& held : from.at(1)) {
            const auto place = held.at(0).get<uint32_t>();
            if (place >= record.places.size()) throw StudioError("A key of a pulled body has a pin that is not there.");
            key.by[place] = {held.at(1).get<float>(), held.at(2).get<float>(), held.at(3).get<float>()};
        }
        record.keys.push_back(std::move(key));
    }
    pulls.record = std::make_shared<const PullRecord>(std::move(record));
    return pulls;
}

// What reading a document or a drawing may throw.
template <class Read>
auto with_sentence(const std::string& subject, Read read) {
    try {
        return read();
    } catch (const cli::InputError& error) {
        throw StudioError(error.what());
    } catch (const nlohmann::json::exception& error) {
        throw StudioError(subject + " is not a drawing of the studio: " + error.what());
    }
}

}  // namespace

Drawing read_drawing(const std::string& path, std::vector<std::string>& warnings) {
    return with_sentence(path, [&] {
        if (path.ends_with(".json")) return drawing_of(cli::read_model_drawing(path));
        cli::ModelDrawing contour;
        contour.thresholds = kUsualBones;
        contour.parts = cli::read_contour_parts(path, warnings);
        Drawing drawing = drawing_of(contour);
        const DrawnPart usual;
        for (DrawnPart& part : drawing.parts) {
            part.color = usual.color;
            part.thickness = usual.thickness;
        }
        take_pixels(drawing);
        return drawing;
    });
}

nlohmann::json drawing_json(const Drawing& drawing) {
    nlohmann::json json;
    const glm::vec4& mirror = drawing.mirror;
    json["mirror"] = {mirror.x, mirror.y, mirror.z, mirror.w};
    put_thresholds(json, drawing.thresholds);
    json["parts"] = nlohmann::json::array();
    for (const DrawnPart& part : drawing.parts) json["parts"].push_back(part_json(part));
    for (const JointEdit& edit : drawing.joint_edits) json["joints"].push_back(edit_json(edit));
    if (!drawing.apart.empty()) json["apart"] = drawing.apart;
    return json;
}

void write_drawing(const Drawing& drawing, const std::string& path) {
    if (drawing.parts.empty()) throw StudioError("There is no drawing to export. Draw a part first.");
    const std::string text = drawing_json(drawing).dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
    write_file(path, text + "\n");
}

nlohmann::json document_json(const Drawing& drawing) {
    nlohmann::json json = nlohmann::json::object();
    if (!drawing.parts.empty()) json["drawing"] = drawing_json(drawing);
    nlohmann::json hidden = nlohmann::json::array(), branches = nlohmann::json::object(),
                   turns = nlohmann::json::object();
    for (const DrawnPart& part : drawing.parts) {
        if (!part.visible) hidden.push_back(part.name);
        if (!part.branch_simplify.empty()) branches[part.name] = part.branch_simplify;
    }
    for (const auto& [joint, turn] : drawing.pose.turns) turns[joint] = {turn.x, turn.y, turn.z, turn.w};
    json["hidden"] = std::move(hidden);
    json["branches"] = std::move(branches);
    json["thresholds"] = nlohmann::json::object();
    put_thresholds(json["thresholds"], drawing.thresholds);
    json["pose"] = {{"turns", std::move(turns)}, {"shift", numbers(drawing.pose.shift)}};
    for (const WeightStrokePtr& stroke : drawing.weight_strokes) json["weights"].push_back(stroke_json(*stroke));
    if (nlohmann::json pulls = pulls_json(drawing.pulls); !pulls.empty()) json["pulls"] = std::move(pulls);
    const TracedPicture& picture = drawing.picture;
    if (!picture.path.empty())
        json["picture"] = {{"path", picture.path},
                           {"centre", {picture.centre.x, picture.centre.y}},
                           {"height", picture.height},
                           {"opacity", picture.opacity}};
    return json;
}

Drawing drawing_of_document(const nlohmann::json& document) {
    return with_sentence("The skeletons' part of the document", [&] {
        Drawing drawing;
        if (document.contains("drawing"))
            drawing = drawing_of(cli::model_drawing_of(document.at("drawing"), "skeletons", {}));
        else if (document.contains("thresholds"))
            drawing.thresholds = {.struct_size = sizeof(FlgBoneThresholds),
                                  .simplify = document["thresholds"].at("simplify"),
                                  .merge = document["thresholds"].at("merge"),
                                  .prune = document["thresholds"].at("prune"),
                                  .collapse = document["thresholds"].at("collapse"),
                                  .detail = document["thresholds"].value("detail", kUsualBones.detail)};
        const nlohmann::json none = nlohmann::json::object();
        const nlohmann::json &branches = document.contains("branches") ? document["branches"] : none,
                             &hidden = document.contains("hidden") ? document["hidden"] : none;
        for (DrawnPart& part : drawing.parts) {
            part.visible = std::find(hidden.begin(), hidden.end(), part.name) == hidden.end();
            if (branches.contains(part.name)) part.branch_simplify = branches[part.name].get<std::vector<float>>();
        }
        if (document.contains("pose")) {
            for (const auto& [joint, turn] : document["pose"].at("turns").items()) {
                const glm::quat q(turn.at(3).get<float>(), turn.at(0).get<float>(), turn.at(1).get<float>(),
                                  turn.at(2).get<float>());
                if (glm::length(q) > 0.5f) drawing.pose.turns[joint] = glm::normalize(q);
            }
            const nlohmann::json& shift = document["pose"].at("shift");
            drawing.pose.shift = {shift.at(0).get<float>(), shift.at(1).get<float>(), shift.at(2).get<float>()};
        }
        if (document.contains("weights"))
            for (const nlohmann::json& stroke : document["weights"])
                drawing.weight_strokes.push_back(stroke_of(stroke));
        if (document.contains("pulls")) drawing.pulls = pulls_of(document["pulls"]);
        if (document.contains("picture")) {
            const nlohmann::json& from = document["picture"];
            drawing.picture.path = from.at("path").get<std::string>();
            drawing.picture.centre = {from.at("centre").at(0).get<double>(), from.at("centre").at(1).get<double>()};
            drawing.picture.height = std::clamp(from.at("height").get<double>(), 1e-3, 1e3);
            drawing.picture.opacity = std::clamp(from.at("opacity").get<float>(), 0.0f, 1.0f);
        }
        return drawing;
    });
}

std::unique_ptr<const cli::KeptJoints> joints_of_document(const nlohmann::json& document) {
    if (!document.contains("joints")) return nullptr;
    return with_sentence("The skeletons' part of the document", [&] {
        return std::make_unique<const cli::KeptJoints>(cli::JsonPlace(document["joints"], "skeletons: joints"));
    });
}

}  // namespace flg::studio
