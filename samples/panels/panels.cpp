// SPDX-License-Identifier: MIT
#include "panels/panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/gtc/type_ptr.hpp>

#include "filigree/filigree.hpp"
#include "panels/small_png.h"
#include "support/curve_source.h"

namespace flg::panels {
namespace {

// What titles have above the picture proper, pixels.
constexpr uint32_t kTitleStrip = 28;
// Between panels, pixels, white.
constexpr uint32_t kGap = 4;

float to_linear(uint8_t value) {
    const float v = static_cast<float>(value) / 255.0f;
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

uint8_t to_srgb(float v) {
    const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
    // 7 bits: in the last one there is only the dither of the drawing, which the average makes needless.
    constexpr long kSteps = 2;
    return static_cast<uint8_t>(
        std::min(kSteps * std::lround(255.0f / kSteps * std::clamp(encoded, 0.0f, 1.0f)), 255L));
}

render::Image averaged_down(const render::Image& large) {
    std::array<float, 256> linear;
    for (uint32_t i = 0; i < 256; ++i) linear[i] = to_linear(static_cast<uint8_t>(i));
    render::Image image{large.width / kOversampling, large.height / kOversampling, {}};
    image.pixels.reserve(size_t{4} * image.width * image.height);
    for (uint32_t y = 0; y < image.height; ++y) {
        for (uint32_t x = 0; x < image.width; ++x) {
            for (uint32_t c = 0; c < 3; ++c) {
                float sum = 0.0f;
                for (uint32_t i = 0; i < kOversampling * kOversampling; ++i) {
                    sum += linear[large.at(x * kOversampling + i % kOversampling,
                                           y * kOversampling + i / kOversampling)[c]];
                }
                image.pixels.push_back(to_srgb(sum / (kOversampling * kOversampling)));
            }
            image.pixels.push_back(255);
        }
    }
    return image;
}

void paste(const render::Image& from, render::Image& into, uint32_t left, uint32_t top) {
    for (uint32_t y = 0; y < from.height; ++y) {
        std::copy_n(from.at(0, y), size_t{4} * from.width,
                    into.pixels.begin() + static_cast<ptrdiff_t>(4 * (size_t{top + y} * into.width + left)));
    }
}

// Softer than the renderer's own: what lies in shadow keeps its colour.
render::Scene daylight() {
    render::Scene scene;
    scene.sun_color = {3.1f, 2.9f, 2.6f};
    scene.sky_color = {1.15f, 1.24f, 1.40f};
    scene.bounce_color = {0.85f, 0.78f, 0.70f};
    scene.background_top = {0.80f, 0.92f, 1.08f};
    scene.background_bottom = {1.55f, 1.52f, 1.48f};
    return scene;
}

void add_points(const Layer& layer, std::vector<glm::vec3>& points) {
    constexpr uint32_t kEnough = 20'000;
    const FlgCurveSetView view = layer.curves.view();
    const FlgColumn& positions = *samples::find_column(view, FLG_ATTRIBUTE_POSITION);
    const FlgColumn *radii = samples::find_column(view, FLG_ATTRIBUTE_RADIUS),
                    *displacements = samples::find_column(view, FLG_ATTRIBUTE_DISPLACEMENT);
    const uint32_t count = view.curve_offsets[view.curve_count];
    for (uint32_t i = 0; i < count; i += 1 + count / kEnough) {
        glm::vec3 p = glm::make_vec3(samples::value_at(positions, i));
        if (layer.magnitude_offset != 0.0f && displacements != nullptr) {
            p += layer.magnitude_offset * glm::make_vec3(samples::value_at(*displacements, i));
        }
        const float radius =
            layer.look.radius_scale * (radii == nullptr ? layer.look.radius : *samples::value_at(*radii, i));
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 out(0.0f);
            out[axis] = radius;
            points.push_back(p + out), points.push_back(p - out);
        }
    }
}

// Where a picture of this size shows a place, pixels from its upper left corner. `strip` rows above are beyond the
// camera's own height of view.
glm::vec2 seen_at(const render::Camera& camera, const glm::vec3& place, uint32_t width, uint32_t height,
                  uint32_t strip) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye),
                    right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward),
                    from = place - camera.eye;
    const float scale =
        0.5f * static_cast<float>(height - strip) / (std::tan(0.5f * camera.fov_y_rad) * glm::dot(from, forward));
    return {0.5f * static_cast<float>(width) + scale * glm::dot(from, right),
            0.5f * static_cast<float>(height + strip) - scale * glm::dot(from, up)};
}

void letter(render::Image& image, const Panel& panel, const render::Camera& camera, uint32_t strip) {
    constexpr float kTitle = 17.0f, kSmall = 14.0f, kCredit = 12.0f, kLine = 21.0f, kDot = 5.5f;  // pixels
    constexpr glm::vec3 kLetters = glm::vec3(0.012f);
    glm::vec2 corner(12.0f, 18.0f);
    if (!panel.title.empty()) {
        const float room = static_cast<float>(image.width) - 2.0f * corner.x;
        write_words(image, panel.title, corner, kTitle * std::min(1.0f, room / width_of(panel.title, kTitle)),
                    kLetters);
        corner.y += 1.1f * kLine;
    }
    for (const Key& key : panel.keys) {
        draw_dot(image, corner + glm::vec2(kDot, 0.0f), kDot, key.color);
        write_words(image, key.text, corner + glm::vec2(3.0f * kDot, 0.0f), kSmall, kLetters);
        corner.y += kLine;
    }
    if (!panel.credit.empty()) {
        write_words(image, panel.credit, {12.0f, static_cast<float>(image.height) - 14.0f}, kCredit, kLetters);
    }
    for (const Note& note : panel.notes) {
        write_words(image, note.text, seen_at(camera, note.at, image.width, image.height, strip) + note.by, note.size,
                    note.color, note.align);
    }
}

}  // namespace

Layer shape_of(const FlgCurveSetView& curves, const render::CurveLook& look) {
    return {Columns(curves).without(FLG_ATTRIBUTE_COLOR).without(FLG_ATTRIBUTE_RADIUS), look};
}

Panel panel_of(const FlgCurveSetView& curves, const render::CurveLook& look, glm::vec3 sight) {
    Panel panel;
    panel.layers = {shape_of(curves, look)};
    panel.sight = sight;
    return panel;
}

std::vector<glm::vec3> points_of(const Panel& panel) {
    std::vector<glm::vec3> points;
    for (const Layer& layer : panel.layers) add_points(layer, points);
    for (const SurfaceLayer& surface : panel.surfaces) {
        const FlgColumn& positions = surface.mesh.columns[0];
        for (uint32_t i = 0; i < surface.mesh.vertex_count; ++i) {
            points.push_back(glm::make_vec3(samples::value_at(positions, i)));
        }
    }
    for (const SkinLayer& layer : panel.skins) {
        std::vector<float> posed(3 * size_t{layer.skin.vertex_count});
        filigree::check(flgSkinDeform(&layer.skin, FLG_SKINNING_DUAL_QUATERNION, layer.dual_quaternions.data(),
                                      posed.data(), nullptr));
        for (size_t i = 0; i < posed.size(); i += 3) points.push_back(glm::make_vec3(&posed[i]));
    }
    return points;
}

void entitle(std::span<Panel> panels, std::initializer_list<const char*> titles) {
    size_t i = 0;
    for (const char* const title : titles) panels[i++].title = title;
}

void aim_together(std::span<Panel> panels) {
    std::vector<glm::vec3> all;
    for (const Panel& panel : panels) {
        const std::vector<glm::vec3> points = points_of(panel);
        all.insert(all.end(), points.begin(), points.end());
    }
    for (Panel& panel : panels) panel.aim = all;
}

render::Image Studio::draw(const Panel& panel, uint32_t width, uint32_t height, uint32_t strip) {
    renderer_.clear();
    for (const Layer& layer : panel.layers) {
        const render::CurvesId id = renderer_.upload(layer.curves.view(), layer.look);
        if (layer.magnitude_offset != 0.0f) renderer_.set_magnitude_offset(id, layer.magnitude_offset);
    }
    for (const SurfaceLayer& surface : panel.surfaces) renderer_.upload(surface.mesh, surface.look, surface.field);
    for (const SkinLayer& layer : panel.skins) {
        renderer_.set_pose(renderer_.upload(layer.skin, layer.look), FLG_SKINNING_DUAL_QUATERNION,
                           layer.dual_quaternions);
    }
    render::Scene scene = daylight();
    scene.ground = panel.ground;
    renderer_.set_scene(scene);
    render::Target target(renderer_, width * kOversampling, height * kOversampling);
    const std::vector<glm::vec3> aim = panel.aim.empty() ? points_of(panel) : panel.aim;
    // The picture proper is below the strip, and the view goes on into it.
    const auto below = static_cast<float>(height - strip);
    render::Camera camera = render::frame_points(aim, panel.sight, static_cast<float>(width) / below, panel.margin);
    const float half = std::tan(0.5f * camera.fov_y_rad), aside = std::atan(half * static_cast<float>(width) / below);
    camera.field = render::FieldOfView{
        -aside, aside, std::atan(half * (1.0f + 2.0f * static_cast<float>(strip) / below)), -std::atan(half)};
    renderer_.draw(target, camera);
    render::Image image = averaged_down(renderer_.capture(target));
    letter(image, panel, camera, strip);
    return image;
}

render::Image Studio::compose(std::span<const Panel> panels, uint32_t columns, uint32_t width, uint32_t height) {
    const uint32_t rows = (static_cast<uint32_t>(panels.size()) + columns - 1) / columns;
    const uint32_t panel_width = (width - (columns - 1) * kGap) / columns,
                   panel_height = (height - (rows - 1) * kGap) / rows;
    render::Image picture{width, height, std::vector<uint8_t>(size_t{4} * width * height, 255)};
    for (uint32_t i = 0; i < panels.size(); ++i) {
        // Panels of a row stay level.
        const auto row =
            panels.subspan(i / columns * columns, std::min<size_t>(columns, panels.size() - i / columns * columns));
        const bool titled = std::any_of(row.begin(), row.end(), [](const Panel& p) { return !p.title.empty(); });
        paste(draw(panels[i], panel_width, panel_height, titled ? kTitleStrip : 0), picture,
              (i % columns) * (panel_width + kGap), (i / columns) * (panel_height + kGap));
    }
    return picture;
}

void Studio::keep(const std::string& name, const render::Image& image) {
    write_small_png(image, path_of(name));
    std::printf("wrote %s\n", path_of(name).c_str());
    std::fflush(stdout);
}

}  // namespace flg::panels
