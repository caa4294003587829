// SPDX-License-Identifier: MIT
// Curves and pictures that the renderer's tests are made of.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "filigree_renderer/renderer.h"

namespace flg::render::test {

constexpr float pi = 3.14159265f;

struct Curves {
    std::vector<float> positions;
    std::vector<float> normals;
    std::vector<float> radii;
    std::vector<uint32_t> offsets{0};
    std::vector<uint8_t> flags;
    std::vector<FlgColumn> columns;

    void add(glm::vec3 p) { positions.insert(positions.end(), {p.x, p.y, p.z}); }
    void end(bool closed = false) {
        offsets.push_back(static_cast<uint32_t>(positions.size() / 3));
        flags.push_back(closed ? FLG_CURVE_CLOSED : 0);
    }
    FlgCurveSetView view() {
        columns = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0}};
        if (!normals.empty()) columns.push_back({FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0});
        if (!radii.empty()) columns.push_back({FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0});
        FlgCurveSetView v{};
        v.struct_size = sizeof v;
        v.curve_count = static_cast<uint32_t>(flags.size());
        v.curve_offsets = offsets.data();
        v.curve_flags = flags.data();
        v.columns = columns.data();
        v.column_count = static_cast<uint32_t>(columns.size());
        return v;
    }
};

// A straight curve along x, centred, with the same normal everywhere.
inline Curves straight(float length, uint32_t points, glm::vec3 normal) {
    Curves curves;
    for (uint32_t i = 0; i < points; ++i) {
        curves.add({length * (static_cast<float>(i) / static_cast<float>(points - 1) - 0.5f), 0, 0});
        curves.normals.insert(curves.normals.end(), {normal.x, normal.y, normal.z});
    }
    curves.end();
    return curves;
}

inline Curves helix(uint32_t points) {
    Curves curves;
    for (uint32_t i = 0; i < points; ++i) {
        const float t = 6 * pi * static_cast<float>(i) / static_cast<float>(points);
        curves.add({0.5f * std::cos(t), 0.08f * t, 0.5f * std::sin(t)});
    }
    curves.end();
    return curves;
}

inline Curves trefoil(uint32_t points) {
    Curves curves;
    for (uint32_t i = 0; i < points; ++i) {
        const float t = 2 * pi * static_cast<float>(i) / static_cast<float>(points);
        curves.add({std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)});
    }
    curves.end(true);
    return curves;
}

constexpr uint32_t picture_size = 512;
constexpr float camera_distance = 4.0f;

// From +z at the origin; a metre at the origin is pixels_per_metre() pixels.
inline Camera front_camera() {
    return {{0, 0, camera_distance}, {0, 0, 0}, {0, 1, 0}, default_fov_y_rad};
}
inline float pixels_per_metre() {
    return 0.5f * picture_size / (camera_distance * std::tan(0.5f * default_fov_y_rad));
}

// Every test's renderer runs under the validation layer, and leaves it silent.
class RendererTest : public ::testing::Test {
protected:
    static Options options(uint32_t samples = 1) {
        Options o;
        o.validation = true;
        o.samples = samples;
        o.shadow_size = 512;
        return o;
    }
    void TearDown() override { expect_silence(renderer); }
    static void expect_silence(const Renderer& r) {
        for (const std::string& message : r.messages()) ADD_FAILURE() << message;
    }
    template <class Action>
    static void expect_error(Action&& action, const char* part) {
        try {
            action();
            ADD_FAILURE() << "no error that says \"" << part << "\"";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
    void without_ground() {
        Scene scene;
        scene.ground = false;
        renderer.set_scene(scene);
    }
    Image picture(Target& target, const Camera& camera = front_camera()) {
        renderer.draw(target, camera);
        return renderer.capture(target);
    }
    Renderer renderer{options()};
};

inline uint32_t differing_pixels(const Image& a, const Image& b) {
    uint32_t count = 0;
    for (size_t i = 0; i < a.pixels.size(); i += 4)
        if (a.pixels[i] != b.pixels[i] || a.pixels[i + 1] != b.pixels[i + 1] || a.pixels[i + 2] != b.pixels[i + 2])
            ++count;
    return count;
}

}  // namespace flg::render::test
