// SPDX-License-Identifier: MIT
#include "tangles/tangle_acts.h"

#include "shell/studio_error.h"

namespace flg::studio {
namespace {

nlohmann::json color_json(const std::optional<uint32_t>& color) {
    return color ? nlohmann::json(*color) : nlohmann::json();
}

std::optional<uint32_t> color_from(const nlohmann::json& json) {
    if (json.is_null()) return std::nullopt;
    return json.get<uint32_t>();
}

}  // namespace

void Acts::push(Act act) {
    forget_undone();
    acts_.push_back(std::move(act));
    ++done_;
}

void Acts::forget_mesh(uint32_t mesh) {
    size_t kept = 0, done = 0;
    for (size_t i = 0; i < acts_.size(); ++i) {
        if (acts_[i].mesh == mesh) continue;
        if (i < done_) ++done;
        if (kept != i) acts_[kept] = std::move(acts_[i]);
        ++kept;
    }
    acts_.resize(kept);
    done_ = done;
}

nlohmann::json Acts::to_json(const std::map<uint32_t, size_t>& number_of) const {
    nlohmann::json list = nlohmann::json::array();
    size_t done = 0;
    for (size_t i = 0; i < acts_.size(); ++i) {
        const Act& act = acts_[i];
        if (act.kind != Act::Kind::palette && !number_of.contains(act.mesh)) continue;
        if (i < done_) ++done;
        switch (act.kind) {
            case Act::Kind::step: list.push_back({{"step", number_of.at(act.mesh)}}); break;
            case Act::Kind::paint: {
                nlohmann::json paints = nlohmann::json::array();
                for (const PaintChange& p : act.paints)
                    paints.push_back({p.region, color_json(p.before), color_json(p.after)});
                list.push_back({{"paint", number_of.at(act.mesh)}, {"regions", std::move(paints)}});
                break;
            }
            case Act::Kind::palette:
                list.push_back({{"palette", {studio::to_json(act.before), studio::to_json(act.after)}}});
                break;
        }
    }
    return {{"list", std::move(list)}, {"done", done}};
}

Acts Acts::from_json(const nlohmann::json& json, const std::vector<uint32_t>& mesh_of) {
    Acts acts;
    for (const nlohmann::json& entry : json.at("list")) {
        Act act;
        if (entry.contains("palette")) {
            act.kind = Act::Kind::palette;
            act.before = palette_from_json(entry.at("palette").at(0));
            act.after = palette_from_json(entry.at("palette").at(1));
        } else if (entry.contains("paint")) {
            act.kind = Act::Kind::paint;
            act.mesh = mesh_of.at(entry.at("paint").get<size_t>());
            for (const nlohmann::json& p : entry.at("regions"))
                act.paints.push_back({p.at(0).get<uint32_t>(), color_from(p.at(1)), color_from(p.at(2))});
        } else {
            act.mesh = mesh_of.at(entry.at("step").get<size_t>());
        }
        acts.acts_.push_back(std::move(act));
    }
    acts.done_ = json.at("done").get<size_t>();
    if (acts.done_ > acts.acts_.size()) throw StudioError("The tangles' list of acts is shorter than it says.");
    return acts;
}

}  // namespace flg::studio
