// SPDX-License-Identifier: MIT
// The picture that a drawing was made over, as the texture of its model: where it lies in the drawing, and the picture
// itself, with the colours within the outlines carried on beyond them. So bodies, which reach a little beyond, and
// coarser levels of the texture show no background.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "documents/model_drawing.h"

namespace flg::cli {

struct PictureOptions {
    std::string file;         // PNG or JPEG
    std::vector<double> box;  // left, bottom, right, top of it in the drawing; empty: the box of all outlines
};

// The page of an SVG file, by its viewBox or its size, as a box in the drawing (y upwards); empty: the file tells none.
std::vector<double> page_of_svg(const std::string& path);

// Tells the parts that have no picture yet where it lies in their own drawings. Parts count as they are placed, but
// lying flat: their turns do not matter.
void place_picture(const PictureOptions& options, ModelDrawing& drawing);

// A PNG or JPEG file as RGBA, rows from the top.
struct DecodedPicture {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> pixels;
};

// Throws InputError about `subject`.
DecodedPicture decode_picture(const uint8_t* file, uint64_t size, const std::string& subject);

// The picture as a PNG file. Throws InputError.
std::vector<uint8_t> bled_picture(const PictureOptions& options, const ModelDrawing& drawing);

}  // namespace flg::cli
