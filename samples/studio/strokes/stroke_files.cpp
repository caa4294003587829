// SPDX-License-Identifier: MIT
#include "strokes/stroke_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "filigree/filigree_io.h"
#include "shell/studio_error.h"
#include "strokes/standing_strokes.h"
#include "support/brush_shape.h"
#include "support/curve_source.h"

namespace flg::studio {
namespace {

using samples::find_column;
using samples::value_at;

constexpr float kSampleSeconds = 1.0f / 90.0f;  // of strokes that say nothing of time
constexpr float kScalePerThickness = 1.8f;      // of the style, for strokes this thick

// The z axis of a controller, which brushes that paint bands have as their normal.
glm::vec3 z_axis(const float* q) {
    const float x = q[0], y = q[1], z = q[2], w = q[3];
    return {2.0f * (x * z + w * y), 2.0f * (y * z - w * x), w * w - x * x - y * y + z * z};
}

// The largest of a curve.
float radius_of(const FlgCurveSetView& view, uint32_t curve) {
    const FlgColumn& radii = *find_column(view, FLG_ATTRIBUTE_RADIUS);
    float largest = 0.0f;
    for (uint32_t i = view.curve_offsets[curve]; i < view.curve_offsets[curve + 1]; ++i)
        largest = std::max(largest, *value_at(radii, i));
    return largest;
}

float median_radius(const FlgCurveSetView& view) {
    if (find_column(view, FLG_ATTRIBUTE_RADIUS) == nullptr || view.curve_count == 0) return 0.0f;
    std::vector<float> radii;
    for (uint32_t c = 0; c < view.curve_count; ++c) radii.push_back(radius_of(view, c));
    std::nth_element(radii.begin(), radii.begin() + radii.size() / 2, radii.end());
    return radii[radii.size() / 2];
}

// `radius`: of the layer's strokes as they were painted, their median; 0 where the file has no radii.
std::shared_ptr<DrawnStroke> read_stroke(const FlgCurveSetView& view, uint32_t curve, float radius) {
    const FlgColumn& positions = *find_column(view, FLG_ATTRIBUTE_POSITION);
    const FlgColumn* orientations = find_column(view, FLG_ATTRIBUTE_ORIENTATION);
    const FlgColumn* normals = find_column(view, FLG_ATTRIBUTE_NORMAL);
    const FlgColumn* pressures = find_column(view, FLG_ATTRIBUTE_PRESSURE);
    const FlgColumn* radii = find_column(view, FLG_ATTRIBUTE_RADIUS);
    const FlgColumn* times = find_column(view, FLG_ATTRIBUTE_TIME);
    const FlgColumn* colors = find_column(view, FLG_ATTRIBUTE_COLOR);
    auto stroke = std::make_shared<DrawnStroke>();
    const uint32_t first = view.curve_offsets[curve], end = view.curve_offsets[curve + 1];
    float largest = 0.0f;
    if (radius > 0.0f) {
        // Sizes are octaves, so that many strokes have the same one; the rest is in what counts as pressure.
        largest = std::max(radius_of(view, curve), 1e-6f * radius);
        stroke->size = std::exp2(std::ceil(std::log2(largest / radius)));
        largest = radius * stroke->size;
    }
    bool forwards = true;
    for (uint32_t i = first; i < end; ++i) {
        const float* p = value_at(positions, i);
        StrokeSample sample{{p[0], p[1], p[2]}, {0.0f, 1.0f, 0.0f}};
        if (normals != nullptr)
            sample.normal = {value_at(*normals, i)[0], value_at(*normals, i)[1], value_at(*normals, i)[2]};
        else if (orientations != nullptr)
            sample.normal = z_axis(value_at(*orientations, i));
        if (stroke->size > 0.0f)
            sample.pressure = std::clamp(*value_at(*radii, i) / largest, 0.0f, 1.0f);
        else if (pressures != nullptr)
            sample.pressure = std::clamp(*value_at(*pressures, i), 0.0f, 1.0f);
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

}  // namespace

bool is_stroke_file(const std::string& path) {
    if (path.starts_with("builtin:")) {
        const std::string name = path.substr(8, path.find(':', 8) - 8);
        for (const auto* list : {&scenes::library_names(), &scenes::target_names(), &scenes::scene_names()})
            if (std::find(list->begin(), list->end(), name) != list->end()) return true;
        return false;
    }
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension != ".txt") return extension == ".tilt" || extension == ".xyz";
    // Contours are such files, too.
    FlgCurveFile file = nullptr;
    const bool readable = flgCurveFileRead(path.c_str(), nullptr, &file) == FLG_OK;
    flgCurveFileRelease(file);
    return readable;
}

bool import_strokes(StrokeDocument& document, StrokeSettings& next, const FindPlace& find_place,
                    const std::string& path) {
    std::optional<samples::CurveSource> source;
    try {
        source.emplace(path);
    } catch (const samples::SourceError& error) {
        throw StudioError(error.what());
    }
    const FlgCurveSetView& view = source->view();
    const float radius_there = median_radius(view);
    std::vector<std::shared_ptr<DrawnStroke>> drawn;
    render::Box box;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        drawn.push_back(read_stroke(view, c, radius_there));
        for (const StrokeSample& sample : drawn.back()->samples) box.add({sample.position, sample.position});
    }
    const render::Placement place = find_place(box);
    if (!place.is_identity()) {
        for (const auto& stroke : drawn) {
            for (StrokeSample& sample : stroke->samples) {
                sample.position = place.point(sample.position);
                sample.normal = place.direction(sample.normal);
            }
        }
    }
    const float radius = place.scale * radius_there;
    if (radius > 0.0f) {
        // What is drawn beside them has their size; with a style, thinner, so that its turns stay apart.
        next.scale_cm = 100.0f * kScalePerThickness * radius;
        next.radius_mm = 1000.0f * radius / kThickness;
    }
    const std::vector<FlgCurveGeometry> shapes = samples::shapes_of_strokes(*source);
    StrokeSettings settings = next;
    settings.styled = shapes.empty();
    StrokeLayer& layer = document.add_layer(std::filesystem::path(path).stem().string());
    std::map<StrokeShape, SettingsPtr> looks;
    std::map<std::pair<StrokeShape, float>, uint32_t> number;  // of the next of this look and size
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        if (!shapes.empty())
            settings.shape = shapes[c] == FLG_CURVE_GEOMETRY_RIBBON ? StrokeShape::ribbon : StrokeShape::tube;
        SettingsPtr& look = looks[settings.shape];
        if (look == nullptr) look = std::make_shared<StrokeSettings>(settings);
        const uint32_t nth = number[{settings.shape, drawn[c]->size}]++;
        layer.strokes.push_back({std::move(drawn[c]), look, nth, true});
    }
    return find_column(view, FLG_ATTRIBUTE_COLOR) != nullptr;
}

void export_strokes(const StrokeDocument& document, const StrokeLayers& layers, const Scene& scene,
                    const std::string& path) {
    StandingCurves standing(scene);
    FlgCurveGeometry geometry = FLG_CURVE_GEOMETRY_TUBE;
    for (const StrokeLayer& layer : document.layers) {
        if (!layer.visible) continue;
        layers.visit(layer.id, [&](const FlgCurveSetView& view, std::span<const Stroke> strokes) {
            for (const Stroke& stroke : strokes)
                if (stroke.settings->shape == StrokeShape::ribbon) geometry = FLG_CURVE_GEOMETRY_RIBBON;
            standing.add(view, strokes);
        });
    }
    if (standing.empty()) throw StudioError("There are no strokes to export. Draw one first.");
    const FlgCurveSetView view = standing.view(true);
    FlgCurveFileWriteDesc desc{};
    flgCurveFileWriteDescInit(&desc, sizeof desc);
    desc.geometry = geometry;
    if (flgCurveFileWrite(path.c_str(), &view, &desc) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
}

}  // namespace flg::studio
