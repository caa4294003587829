// SPDX-License-Identifier: MIT
// Drawings of models (samples/models; sdk/bones/README.md explains them): parts with their contours, places and
// colours.
#pragma once

#include <OgreColourValue.h>
#include <OgreMatrix4.h>

#include <string>
#include <vector>

namespace viewer {

struct DrawnPart {
    std::string name;
    std::vector<double> contour;  // x, y, ...
    Ogre::Matrix4 placement;
    float thickness, prune;
    bool mirrored;
    Ogre::ColourValue colour;  // linear
};

struct Drawing {
    Ogre::Vector4 mirror;
    float simplify, merge, prune, collapse;
    std::vector<DrawnPart> parts;
};

// `json` is the text of a drawing of curves. Throws what nlohmann::json throws at other text.
Drawing read_drawing(const std::string& json);

}  // namespace viewer
