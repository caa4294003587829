// SPDX-License-Identifier: MIT
#include "skeletons/picture_layer.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "skeletons/image_file.h"

namespace flg::studio {

PictureLayer::~PictureLayer() {
    if (coming_.valid()) coming_.wait();
    renderer_.remove(texture_);
}

PictureLayer::Read PictureLayer::read(const std::string& path) {
    Read read;
    try {
        read.image = read_image(path);
    } catch (const std::exception& error) {
        read.error = error.what();
    }
    return read;
}

void PictureLayer::update(const TracedPicture& picture) {
    if (coming_.valid()) {
        if (coming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        const Read read = coming_.get();
        path_ = coming_path_;
        renderer_.remove(std::exchange(texture_, {}));
        if (!read.error.empty()) {
            notices_.add(Weight::error, read.error);
        } else {
            texture_ = renderer_.upload(read.image);
            aspect_ = static_cast<double>(read.image.width) / read.image.height;
        }
    }
    if (picture.path == path_) return;
    if (picture.path.empty()) {
        renderer_.remove(std::exchange(texture_, {}));
        path_.clear();
        return;
    }
    coming_path_ = picture.path;
    coming_ = std::async(std::launch::async, [path = picture.path] { return read(path); });
}

void PictureLayer::draw(ImDrawList& list, const View& view, const TracedPicture& picture) const {
    if (texture_.value == 0 || picture.opacity <= 0.0f) return;
    const glm::dvec2 half(0.5 * aspect_ * picture.height, 0.5 * picture.height);
    std::array<ImVec2, 4> corners;
    constexpr std::array<glm::dvec2, 4> kSides = {{{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}};
    for (size_t i = 0; i < 4; ++i) {
        const auto px = view.project(glm::vec3(glm::dvec3(picture.centre + kSides[i] * half, 0.0)));
        if (!px) return;
        corners[i] = {px->x, px->y};
    }
    const auto alpha = static_cast<int>(255.0f * std::min(picture.opacity, 1.0f));
    list.AddImageQuad(reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(texture_.value)), corners[0], corners[1],
                      corners[2], corners[3], {0, 0}, {1, 0}, {1, 1}, {0, 1}, IM_COL32(255, 255, 255, alpha));
}

}  // namespace flg::studio
