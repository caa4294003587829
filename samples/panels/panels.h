// SPDX-License-Identifier: MIT
// Pictures of panels side by side, each with its curves, surfaces, camera and words, drawn larger and averaged down.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "filigree_renderer/renderer.h"
#include "panels/columns.h"
#include "panels/lettering.h"

namespace flg::panels {

// How many times larger pictures are drawn each way: widths of lines in pixels are those of the larger one.
constexpr uint32_t kOversampling = 2;

// Data is alive until the picture is taken.
struct Layer {
    Columns curves;
    render::CurveLook look;
    float magnitude_offset = 0.0f;  // of curves with displacements
};

struct SurfaceLayer {
    FlgMeshView mesh;
    render::SurfaceLook look;
    std::span<const float> field{};
};

// A surface that follows joints, in a pose.
struct SkinLayer {
    FlgSkinView skin;
    render::SurfaceLook look;
    std::vector<float> dual_quaternions;  // 8 a joint
};

// Words at a place of the scene, `by` pixels from where the picture shows it.
struct Note {
    glm::vec3 at;
    std::string text;
    glm::vec2 by{0.0f};
    glm::vec3 color{0.012f};
    float size = 15.0f;  // pixels
    Align align = Align::center;
};

// What a colour means.
struct Key {
    glm::vec3 color;
    std::string text;
};

struct Panel {
    std::string title;      // in the upper left corner,
    std::vector<Key> keys;  // with these below it
    std::string credit;     // in the lower left corner, small
    std::vector<Note> notes;
    std::vector<Layer> layers;
    std::vector<SurfaceLayer> surfaces;
    std::vector<SkinLayer> skins;
    glm::vec3 sight = {-0.45f, -0.22f, -1.0f};  // from the eye into the scene
    float margin = 1.10f;                       // the picture's size over that of what it is aimed at
    bool ground = true;
    // What the camera is aimed at; empty: all that the panel shows.
    std::vector<glm::vec3> aim;
};

// The shape alone, without colours and radii that the curves may have.
Layer shape_of(const FlgCurveSetView& curves, const render::CurveLook& look);

Panel panel_of(const FlgCurveSetView& curves, const render::CurveLook& look, glm::vec3 sight = {-0.2f, -0.12f, -1.0f});

// Titles of the first panels, in order.
void entitle(std::span<Panel> panels, std::initializer_list<const char*> titles);

// What the panel shows, radii included.
std::vector<glm::vec3> points_of(const Panel& panel);

// One camera for all of them.
void aim_together(std::span<Panel> panels);

class Studio {
public:
    // Pictures are kept in `folder`.
    explicit Studio(std::string folder = ".") : folder_(std::move(folder)) {}

    // Panels from left to right, `columns` of them in a row. Width and height are those of the whole picture.
    render::Image compose(std::span<const Panel> panels, uint32_t columns, uint32_t width, uint32_t height);
    // Keeps it, too.
    void take(const std::string& name, std::span<const Panel> panels, uint32_t columns, uint32_t width,
              uint32_t height) {
        keep(name, compose(panels, columns, width, height));
    }

    // A panel by itself. What it is aimed at keeps out of a strip above, so many pixels high.
    render::Image draw(const Panel& panel, uint32_t width, uint32_t height, uint32_t strip = 0);

    // A picture as it is.
    void keep(const std::string& name, const render::Image& image);
    std::string path_of(const std::string& name) const { return folder_ + "/" + name + ".png"; }

    const render::Renderer& renderer() const { return renderer_; }

private:
    std::string folder_;
    render::Renderer renderer_;
};

}  // namespace flg::panels
