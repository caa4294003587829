// SPDX-License-Identifier: MIT
#include "strokes/style_cache.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "scenes/scenes.h"
#include "strokes/flat_plane.h"
#include "support/curve_arrays.h"

namespace flg::studio {
namespace {

constexpr float kLength = 3.5f;  // of a preview, of its height
// A displacement below this share of the guide's length cannot be seen.
constexpr float kUnseenShare = 1e-5f;
constexpr size_t kKept = 32;  // styles that nothing is drawn with

bool is_builtin_style(const std::string& name) {
    const std::vector<std::string>& names = scenes::library_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<glm::vec3> points_of(const StrokeDocument& document, const std::string& name) {
    std::vector<glm::vec3> points;
    if (const DrawnStyle* drawn = document.find_style(name)) {
        for (const StrokeSample& sample : drawn->stroke->samples) points.push_back(sample.position);
    } else if (is_builtin_style(name)) {
        for (const scenes::Point& p : scenes::make_style(name).points) points.emplace_back(p.x, p.y, p.z);
    }
    return points;
}

// The first of them, on the plane of the two directions along which they spread most; 0 to 1.
std::vector<glm::vec3> flattened(const std::vector<glm::vec3>& points) {
    if (points.empty()) return {};
    const FlatPlane plane(points);
    std::vector<glm::vec3> flat;
    glm::vec2 low(1e30f), high(-1e30f);
    const size_t least = points.size() / 5;
    for (const glm::vec3& p : points) {
        const glm::vec2 at = plane.flat(p);
        // As much of it as can be made out.
        const glm::vec2 size = glm::max(high, at) - glm::min(low, at);
        if (flat.size() > least && size.x > kLength * size.y) break;
        flat.emplace_back(at, 1.0f);
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const float size = std::max({high.x - low.x, high.y - low.y, 1e-9f});
    for (glm::vec3& p : flat) p = glm::vec3(0.5f + (glm::vec2(p) - 0.5f * (low + high)) / size, p.z);
    return flat;
}

// Of the points from their running mean, across the way that they go along: least and most.
glm::vec2 reach_of(const std::vector<glm::vec3>& points) {
    constexpr size_t kWindows = 10;  // about as many turns as a style has
    const size_t count = points.size(), half = count / (2 * kWindows);
    if (half == 0) return glm::vec2(0.0f);
    const glm::vec3 chord = points.back() - points.front();
    if (!(glm::length(chord) > 0.0f)) return glm::vec2(0.0f);
    const glm::vec3 along = glm::normalize(chord);
    const glm::vec3 u =
        glm::normalize(glm::cross(along, std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    const glm::vec3 v = glm::cross(along, u);
    std::vector<Eigen::Vector2f> off;
    Eigen::Matrix2f spread = Eigen::Matrix2f::Zero();
    for (size_t i = half; i + half < count; ++i) {
        glm::vec3 mean(0.0f);
        for (size_t k = i - half; k <= i + half; ++k) mean += points[k] / static_cast<float>(2 * half + 1);
        off.emplace_back(glm::dot(points[i] - mean, u), glm::dot(points[i] - mean, v));
        spread += off.back() * off.back().transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2f> solver(spread);
    glm::vec2 most(0.0f);
    for (const Eigen::Vector2f& o : off)
        for (int axis = 0; axis < 2; ++axis)
            most[axis] = std::max(most[axis], std::abs(o.dot(solver.eigenvectors().col(axis))));
    return most;
}

}  // namespace

bool StyleCache::has(const StrokeDocument& document, const std::string& name) const {
    return document.find_style(name) != nullptr || is_builtin_style(name);
}

std::vector<glm::vec3> StyleCache::example(const StrokeDocument& document, const std::string& name) const {
    return points_of(document, name);
}

filigree::Style StyleCache::prepare(const std::vector<glm::vec3>& example, const StrokeSettings& settings,
                                    Jobs::Done done, Jobs::Shown shown) {
    const uint32_t offsets[] = {0, static_cast<uint32_t>(example.size())};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, &example[0].x, 0, 0};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = &column;
    view.column_count = 1;
    const filigree::CurveSet set = app_.context.curve_set(view);
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = set.get();
    desc.patch = static_cast<uint32_t>(settings.patch);
    desc.smoothing = settings.smoothing;
    desc.beta = settings.beta;
    filigree::Job job;
    filigree::Style style = app_.context.style(desc, &job);
    app_.jobs.add("Learning style " + settings.style, std::move(job), std::move(done), shown);
    return style;
}

const filigree::Style* StyleCache::get(const StrokeDocument& document, const StrokeSettings& settings) {
    if (!has(document, settings.style)) return nullptr;
    Entry& entry = styles_[key_of(settings)];
    const DrawnStyle* drawn = document.find_style(settings.style);
    if (entry.style && (drawn == nullptr || entry.drawn == drawn->stroke)) return &entry.style;
    entry.drawn = drawn ? drawn->stroke : nullptr;
    entry.style = prepare(points_of(document, settings.style), settings, [this, key = key_of(settings)](const auto&) {
        const auto found = styles_.find(key);
        if (found == styles_.end() || !has_nothing_to_learn(found->second.style)) return;
        app_.notices.add(Weight::warning,
                         "Style " + std::get<0>(key) + " has nothing to learn: its example is straight, or too short.");
    });
    return &entry.style;
}

FlgStyleInfo StyleCache::read_info(const filigree::Style& style) const {
    FlgStyleInfo info{};
    info.struct_size = sizeof info;
    if (flgStyleGetInfo(app_.context.get(), style.get(), &info) != FLG_OK) info = {};
    return info;
}

bool StyleCache::has_nothing_to_learn(const filigree::Style& style) const {
    const FlgStyleInfo info = read_info(style);
    return info.guide_length > 0.0f && info.displacement_rms <= kUnseenShare * info.guide_length;
}

FlgStyleInfo StyleCache::info(const filigree::Style& style) const {
    FlgStyleInfo info = read_info(style);
    // Nothing to learn is nothing at any size.
    if (info.displacement_rms <= kUnseenShare * info.guide_length) info.displacement_rms = info.guide_length;
    return info;
}

bool StyleCache::warm(const filigree::Style& style, float temperature) {
    const std::pair<uint64_t, float> key{style.get().id, temperature};
    if (warm_.contains(key)) return true;
    if (!warming_.insert(key).second) return false;
    app_.jobs.add(
        "Preparing the pen", style.warm(temperature),
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

void StyleCache::forget(const StrokeDocument& document, const StrokeSettings& next) {
    std::erase_if(styles_, [&](const auto& item) {
        if (item.second.drawn == nullptr) return false;
        const DrawnStyle* drawn = document.find_style(std::get<0>(item.first));
        return drawn == nullptr || drawn->stroke != item.second.drawn;
    });
    if (styles_.size() <= kKept) return;
    std::set<Key> used{key_of(next)};
    for (const StrokeLayer& layer : document.layers)
        for (const Stroke& stroke : layer.strokes) used.insert(key_of(*stroke.settings));
    std::erase_if(styles_, [&](const auto& item) { return !used.contains(item.first); });
}

glm::vec2 StyleCache::reach(const StrokeDocument& document, const std::string& name) {
    const DrawnStyle* drawn = document.find_style(name);
    const StrokePtr stroke = drawn ? drawn->stroke : nullptr;
    const auto found = reaches_.find(name);
    if (found != reaches_.end() && found->second.first == stroke) return found->second.second;
    reaches_[name] = {stroke, reach_of(points_of(document, name))};
    return reaches_[name].second;
}

const std::vector<glm::vec3>& StyleCache::preview(const StrokeDocument& document, const std::string& name) {
    const DrawnStyle* drawn = document.find_style(name);
    const StrokePtr stroke = drawn ? drawn->stroke : nullptr;
    const auto found = previews_.find(name);
    if (found != previews_.end() && found->second.first == stroke) return found->second.second;
    auto& entry = previews_[name];
    entry = {stroke, flattened(points_of(document, name))};
    if (!is_builtin_style(name)) return entry.second;
    const std::vector<float> radii = scenes::make_style(name).radii;
    float mean = 0.0f;
    for (const float radius : radii) mean += radius / static_cast<float>(radii.size());
    for (size_t i = 0; i < std::min(radii.size(), entry.second.size()); ++i) entry.second[i].z = radii[i] / mean;
    return entry.second;
}

}  // namespace flg::studio
