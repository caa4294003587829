// SPDX-License-Identifier: MIT
// Takes the pictures: panels side by side, each with its curves and its camera, drawn larger and averaged down.
#pragma once

#include <string>
#include <vector>

#include "filigree_renderer/renderer.h"
#include "gallery/columns.h"

namespace flg::gallery {

struct Layer {
    Columns curves;  // whose data is alive until the picture is taken
    render::CurveLook look;
    float magnitude_offset = 0.0f;  // of curves with displacements
};

struct Panel {
    std::vector<Layer> layers;
    glm::vec3 sight = {-0.45f, -0.22f, -1.0f};  // from the eye into the scene
    float nearer = 0.9f;                        // factor on the distance at which all is seen
    glm::vec2 shift = {0.0f, 0.0f};             // of the view, right and up, in heights of the picture
    bool ground = true;
    // The box that the camera is aimed at; empty: of the layers.
    render::Box box;
};

// The shape alone, without colours and radii that the curves may have.
Panel panel_of(const FlgCurveSetView& curves, const render::CurveLook& look, glm::vec3 sight = {-0.2f, -0.12f, -1.0f});

class Studio {
public:
    // Pictures are written to `folder`.
    explicit Studio(std::string folder) : folder_(std::move(folder)) {}

    // Panels from left to right, `columns` of them in a row. Width and height are those of the whole picture.
    void take(const std::string& name, const std::vector<Panel>& panels, uint32_t columns, uint32_t width,
              uint32_t height);

private:
    render::Image draw(const Panel& panel, uint32_t width, uint32_t height);

    std::string folder_;
    render::Renderer renderer_;
};

}  // namespace flg::gallery
