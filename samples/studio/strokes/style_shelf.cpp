// SPDX-License-Identifier: MIT
#include "strokes/style_shelf.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "scenes/scenes.h"
#include "support/curve_arrays.h"

namespace flg::studio {
namespace {

bool is_builtin(const std::string& name) {
    const std::vector<std::string>& names = scenes::style_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<glm::vec3> points_of(const StrokeDocument& document, const std::string& name) {
    std::vector<glm::vec3> points;
    if (const DrawnStyle* drawn = document.find_style(name)) {
        for (const StrokeSample& sample : drawn->stroke->samples) points.push_back(sample.position);
    } else if (is_builtin(name)) {
        for (const scenes::Point& p : scenes::make_style(name).points) points.emplace_back(p.x, p.y, p.z);
    }
    return points;
}

// On the plane of the two directions along which they spread most; 0 to 1.
std::vector<glm::vec2> flattened(const std::vector<glm::vec3>& points) {
    if (points.empty()) return {};
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const glm::vec3& p : points) mean += Eigen::Vector3f(p.x, p.y, p.z) / static_cast<float>(points.size());
    Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
    for (const glm::vec3& p : points) {
        const Eigen::Vector3f d = Eigen::Vector3f(p.x, p.y, p.z) - mean;
        spread += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(spread);
    Eigen::Vector3f along = solver.eigenvectors().col(2), across = solver.eigenvectors().col(1);
    if (along[0] < 0.0f) along = -along;  // from left to right, as it was drawn
    if (across[1] < 0.0f) across = -across;
    std::vector<glm::vec2> flat;
    glm::vec2 low(1e30f), high(-1e30f);
    for (const glm::vec3& p : points) {
        const Eigen::Vector3f d = Eigen::Vector3f(p.x, p.y, p.z) - mean;
        flat.emplace_back(along.dot(d), -across.dot(d));
        low = glm::min(low, flat.back());
        high = glm::max(high, flat.back());
    }
    const float size = std::max({high.x - low.x, high.y - low.y, 1e-9f});
    for (glm::vec2& p : flat) p = 0.5f + (p - 0.5f * (low + high)) / size;
    return flat;
}

}  // namespace

const filigree::Style* StyleShelf::get(const StrokeDocument& document, const std::string& name, int patch) {
    Entry& entry = styles_[{name, patch}];
    const DrawnStyle* drawn = document.find_style(name);
    if (drawn == nullptr && !is_builtin(name)) return nullptr;
    if (entry.style && (drawn == nullptr || entry.drawn == drawn->stroke)) return &entry.style;
    const std::vector<glm::vec3> points = points_of(document, name);
    const uint32_t offsets[] = {0, static_cast<uint32_t>(points.size())};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, &points[0].x, 0, 0};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = &column;
    view.column_count = 1;
    const filigree::CurveSet example = desk_.context.curves(view);
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = example.get();
    desc.patch = static_cast<uint32_t>(patch);
    filigree::Job job;
    entry = {desk_.context.style(desc, &job), drawn ? drawn->stroke : nullptr};
    desk_.jobs.add("Learning the style " + name, std::move(job));
    return &entry.style;
}

FlgStyleInfo StyleShelf::info(const filigree::Style& style) const {
    FlgStyleInfo info{};
    info.struct_size = sizeof info;
    if (flgStyleGetInfo(desk_.context.get(), style.get(), &info) != FLG_OK) info.displacement_rms = 0.0f;
    return info;
}

bool StyleShelf::warm(const filigree::Style& style, float temperature) {
    const std::pair<uint64_t, float> key{style.get().id, temperature};
    if (warm_.contains(key)) return true;
    if (!warming_.insert(key).second) return false;
    desk_.jobs.add(
        "Warming the pen", desk_.context.warm(style, temperature),
        [this, key](const FlgJobStatus& status) {
            warming_.erase(key);
            if (status.result != FLG_OK) return;
            // A style keeps the trees of its last four temperatures.
            std::erase_if(warm_, [&](const auto& other) { return other.first == key.first; });
            warm_.insert(key);
        },
        Jobs::Shown::quiet);
    return false;
}

void StyleShelf::forget_drawn(const StrokeDocument& document) {
    std::erase_if(styles_, [&](const auto& item) {
        if (item.second.drawn == nullptr) return false;
        const DrawnStyle* drawn = document.find_style(item.first.first);
        return drawn == nullptr || drawn->stroke != item.second.drawn;
    });
}

const std::vector<glm::vec2>& StyleShelf::preview(const StrokeDocument& document, const std::string& name) {
    const DrawnStyle* drawn = document.find_style(name);
    const StrokePtr stroke = drawn ? drawn->stroke : nullptr;
    const auto found = previews_.find(name);
    if (found != previews_.end() && found->second.first == stroke) return found->second.second;
    auto& entry = previews_[name];
    entry = {stroke, flattened(points_of(document, name))};
    return entry.second;
}

}  // namespace flg::studio
