// SPDX-License-Identifier: MIT
#include "lasting_names.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "documents/json_place.h"

namespace flg::cli {
namespace {

constexpr double same_joint = 0.05;  // of a part's length, as in models
constexpr size_t none = SIZE_MAX;

struct NamedJoint {
    std::string name, key, part;  // part: with .M where it is a mirror image
    std::array<double, 3> place;
};

std::string part_of(const std::string& name, bool is_mirrored) {
    return is_mirrored ? name + ".M" : name;
}

std::vector<NamedJoint> read_joints(const std::string& path) {
    const nlohmann::json json = JsonPlace::read(path);
    const JsonPlace whole(json, path + ": bones");
    std::vector<std::string> parts;
    for (const JsonPlace& item : whole.at("parts").items())
        parts.push_back(part_of(item.at("name").text(), item.at("mirrored").flag()));
    std::vector<NamedJoint> joints;
    for (const JsonPlace& item : whole.at("joints").items()) {
        if (parts.empty()) whole.at("parts").fail("is empty");
        const uint32_t part = item.at("part").count(0, static_cast<uint32_t>(parts.size()) - 1);
        const std::vector<JsonPlace> numbers = item.at("place").items();
        if (numbers.size() != 3) item.at("place").fail("must be 3 numbers");
        NamedJoint joint{item.at("name").text(), item.at("key").text(), parts[part], {}};
        for (size_t k = 0; k < 3; ++k) joint.place[k] = numbers[k].real(-1e30, 1e30);
        joints.push_back(std::move(joint));
    }
    return joints;
}

double distance_of(const NamedJoint& a, const NamedJoint& b) {
    return std::hypot(a.place[0] - b.place[0], a.place[1] - b.place[1], a.place[2] - b.place[2]);
}

size_t nearest(const NamedJoint& joint, const std::vector<NamedJoint>& others) {
    size_t best = none;
    for (size_t i = 0; i < others.size(); ++i)
        if (others[i].part == joint.part &&
            (best == none || distance_of(joint, others[i]) < distance_of(joint, others[best])))
            best = i;
    return best;
}

double length_of(const DrawnPart& part) {
    const std::vector<double>& p = part.contour.points;
    const size_t end = part.contour.offsets.size() > 1 ? part.contour.offsets[1] : p.size() / 2;
    double length = 0;
    for (size_t i = 0, before = end - 1; i < end; before = i++)
        length += std::hypot(p[2 * i] - p[2 * before], p[2 * i + 1] - p[2 * before + 1]);
    return length;
}

// The joints of a model, and by joint which of those before it is, none: a new one.
struct Matched {
    Matched(const std::vector<NamedJoint>& before, const FlgModelView& model, const ModelDrawing& drawing) {
        std::vector<double> near;
        for (uint32_t j = 0; j < model.joint_count; ++j) {
            const uint32_t part = model.joint_parts[j];
            const DrawnPart& drawn = drawing.parts[model.part_sources[part]];
            const double* place = model.joint_places + 3 * size_t{j};
            now.push_back({model.joint_names[j],
                           model.joint_keys[j],
                           part_of(drawn.name, model.part_mirrored[part] != 0),
                           {place[0], place[1], place[2]}});
            near.push_back(same_joint * length_of(drawn));
        }
        for (size_t j = 0; j < now.size(); ++j) {
            const size_t old = nearest(now[j], before);
            const bool is_same =
                old != none && nearest(before[old], now) == j && distance_of(now[j], before[old]) < near[j];
            same.push_back(is_same ? old : none);
        }
    }
    std::vector<NamedJoint> now;
    std::vector<size_t> same;
};

}  // namespace

std::vector<std::string> follow_joints(const std::string& bones, const FlgModelView& model, ModelDrawing& drawing) {
    const std::vector<NamedJoint> before = read_joints(bones);
    const Matched matched(before, model, drawing);
    std::set<std::string> split;
    for (const JointEdit& edit : drawing.joint_edits)
        if (edit.kind == FLG_JOINT_EDIT_KIND_SPLIT) split.insert(edit.name);
    std::vector<std::string> gone;
    std::erase_if(drawing.joint_edits, [&](JointEdit& edit) {
        for (size_t j = 0; j < matched.now.size(); ++j)
            if (matched.same[j] != none && before[matched.same[j]].key == edit.joint) {
                edit.joint = matched.now[j].key;
                return false;
            }
        if (split.contains(edit.joint)) return false;
        gone.push_back(edit.joint);
        return true;
    });
    return gone;
}

LastingNames::LastingNames(const std::string& bones, const FlgModelView& model, const ModelDrawing& drawing) {
    const std::vector<NamedJoint> before = read_joints(bones);
    auto [now, same] = Matched(before, model, drawing);
    std::set<std::string> taken_keys;
    for (const NamedJoint& joint : before) taken_keys.insert(joint.key);
    for (size_t j = 0; j < now.size(); ++j) {
        std::string key = same[j] == none ? now[j].key : before[same[j]].key;
        while (same[j] == none && !taken_keys.insert(key).second) key += "_";
        keys_.push_back(std::move(key));
    }
    std::set<std::string> taken;
    for (size_t j = 0; j < now.size(); ++j) {
        if (now[j].name == now[j].key) continue;
        taken.insert(now[j].name);
        same[j] = none;
    }
    names_.resize(now.size());
    for (size_t j = 0; j < now.size(); ++j) {
        if (same[j] != none && taken.insert(before[same[j]].name).second)
            names_[j] = before[same[j]].name;
        else
            same[j] = none;
    }
    // A name that a joint had which is gone is not given again at once.
    for (const NamedJoint& joint : before) taken.insert(joint.name);
    for (size_t j = 0; j < now.size(); ++j) {
        if (same[j] != none) continue;
        names_[j] = now[j].name;
        if (now[j].name != now[j].key) continue;
        const std::string& part = drawing.parts[model.part_sources[model.joint_parts[j]]].name;
        const std::string end = now[j].name.substr(now[j].name.size() - std::min<size_t>(2, now[j].name.size()));
        const std::string side = end == ".L" || end == ".R" ? end : "";
        for (size_t number = 0; !taken.insert(names_[j]).second; ++number)
            names_[j] = part + "_" + std::to_string(number) + side;
    }
    for (const std::string& name : names_) pointers_.push_back(name.c_str());
    for (const std::string& key : keys_) key_pointers_.push_back(key.c_str());
}

}  // namespace flg::cli
