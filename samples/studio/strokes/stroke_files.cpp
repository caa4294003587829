// SPDX-License-Identifier: MIT
#include "strokes/stroke_files.h"

#include <algorithm>
#include <filesystem>

#include "filigree/filigree_io.h"
#include "shell/studio_error.h"
#include "support/curve_source.h"

namespace flg::studio {
namespace {

using samples::find_column;
using samples::value_at;

constexpr float kSampleSeconds = 1.0f / 90.0f;  // of strokes that say nothing of time
constexpr float kScalePerRadius = 1.8f;

// The y axis of a controller.
glm::vec3 y_axis(const float* q) {
    const float x = q[0], y = q[1], z = q[2], w = q[3];
    return {2.0f * (x * y - w * z), w * w - x * x + y * y - z * z, 2.0f * (y * z + w * x)};
}

StrokePtr read_stroke(const FlgCurveSetView& view, uint32_t curve) {
    const FlgColumn& positions = *find_column(view, FLG_ATTRIBUTE_POSITION);
    const FlgColumn* orientations = find_column(view, FLG_ATTRIBUTE_ORIENTATION);
    const FlgColumn* normals = find_column(view, FLG_ATTRIBUTE_NORMAL);
    const FlgColumn* pressures = find_column(view, FLG_ATTRIBUTE_PRESSURE);
    const FlgColumn* times = find_column(view, FLG_ATTRIBUTE_TIME);
    const FlgColumn* colors = find_column(view, FLG_ATTRIBUTE_COLOR);
    auto stroke = std::make_shared<DrawnStroke>();
    const uint32_t first = view.curve_offsets[curve], end = view.curve_offsets[curve + 1];
    bool forwards = true;
    for (uint32_t i = first; i < end; ++i) {
        const float* p = value_at(positions, i);
        StrokeSample sample{{p[0], p[1], p[2]}, {0.0f, 1.0f, 0.0f}};
        if (normals != nullptr)
            sample.normal = {value_at(*normals, i)[0], value_at(*normals, i)[1], value_at(*normals, i)[2]};
        else if (orientations != nullptr)
            sample.normal = y_axis(value_at(*orientations, i));
        if (pressures != nullptr) sample.pressure = std::clamp(*value_at(*pressures, i), 0.0f, 1.0f);
        sample.time = times != nullptr ? *value_at(*times, i) : kSampleSeconds * static_cast<float>(i - first);
        forwards = forwards && (stroke->samples.empty() || stroke->samples.back().time <= sample.time);
        stroke->samples.push_back(sample);
    }
    if (!forwards)
        for (size_t i = 0; i < stroke->samples.size(); ++i)
            stroke->samples[i].time = kSampleSeconds * static_cast<float>(i);
    if (colors != nullptr) {
        const float* c = value_at(*colors, first);
        stroke->color = glm::vec3(c[0], c[1], c[2]);
    }
    return stroke;
}

float mean_radius(const FlgCurveSetView& view) {
    const FlgColumn* radii = find_column(view, FLG_ATTRIBUTE_RADIUS);
    const uint32_t count = view.curve_offsets[view.curve_count];
    if (radii == nullptr || count == 0) return 0.0f;
    double sum = 0.0;
    for (uint32_t i = 0; i < count; ++i) sum += static_cast<double>(*value_at(*radii, i));
    return static_cast<float>(sum / count);
}

}  // namespace

bool is_stroke_file(const std::string& path) {
    if (path.starts_with("builtin:")) {
        const std::string name = path.substr(8, path.find(':', 8) - 8);
        for (const auto* list : {&scenes::style_names(), &scenes::target_names(), &scenes::scene_names()})
            if (std::find(list->begin(), list->end(), name) != list->end()) return true;
        return false;
    }
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension != ".txt") return extension == ".tilt" || extension == ".xyz";
    // Contours are such files, too.
    FlgCurveFile file = nullptr;
    const bool readable = flgCurveFileRead(path.c_str(), &file) == FLG_OK;
    flgCurveFileRelease(file);
    return readable;
}

void import_strokes(StrokeDocument& document, const std::string& path) {
    std::optional<samples::CurveSource> source;
    try {
        source.emplace(path);
    } catch (const samples::SourceError& error) {
        throw StudioError(error.what());
    }
    const FlgCurveSetView& view = source->view();
    StrokeSettings settings = document.active_layer().settings;
    const float radius = mean_radius(view);
    if (radius > 0.0f) {
        settings.scale_cm = std::clamp(100.0f * kScalePerRadius * radius, 0.05f, 20.0f);
        // Thinner than what was drawn, so that the style's turns stay apart.
        settings.radius_mm = std::clamp(220.0f * radius, 0.1f, 50.0f);
    }
    StrokeLayer& layer = document.add_layer(std::filesystem::path(path).stem().string(), settings);
    for (uint32_t c = 0; c < view.curve_count; ++c) layer.strokes.push_back(read_stroke(view, c));
}

void export_strokes(const StrokeDocument& document, const StrokeLayers& layers, const std::string& path) {
    std::vector<float> positions, normals, radii, colors;
    std::vector<uint32_t> offsets{0};
    FlgGeometry geometry = FLG_GEOMETRY_TUBE;
    for (const StrokeLayer& layer : document.layers) {
        const filigree::CurveSet* result = layers.result(layer.id);
        if (!layer.visible || result == nullptr || layer.strokes.empty()) continue;
        if (layer.settings.shape == StrokeShape::ribbon) geometry = FLG_GEOMETRY_RIBBON;
        const FlgCurveSetView view = result->view();
        for (uint32_t c = 0; c < view.curve_count; ++c) {
            const glm::vec3 color = layer.strokes[c]->color.value_or(layer.settings.color);
            for (uint32_t i = view.curve_offsets[c]; i < view.curve_offsets[c + 1]; ++i) {
                const float* p = value_at(*find_column(view, FLG_ATTRIBUTE_POSITION), i);
                const float* n = value_at(*find_column(view, FLG_ATTRIBUTE_NORMAL), i);
                positions.insert(positions.end(), p, p + 3);
                normals.insert(normals.end(), n, n + 3);
                radii.push_back(*value_at(*find_column(view, FLG_ATTRIBUTE_RADIUS), i));
                colors.insert(colors.end(), {color.x, color.y, color.z, 1.0f});
            }
            offsets.push_back(static_cast<uint32_t>(radii.size()));
        }
    }
    if (offsets.size() == 1) throw StudioError("There are no strokes to write yet.");
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0},
                                 {FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0},
                                 {FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0},
                                 {FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0}};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = static_cast<uint32_t>(offsets.size() - 1);
    view.curve_offsets = offsets.data();
    view.columns = columns;
    view.column_count = 4;
    FlgCurveWriteDesc desc{};
    flgCurveWriteDescInit(&desc, sizeof desc);
    desc.geometry = geometry;
    if (flgCurveFileWrite(path.c_str(), &view, &desc) != FLG_OK) throw StudioError(flgIoLastError());
}

}  // namespace flg::studio
