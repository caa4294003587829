// SPDX-License-Identifier: MIT
#include "drawn_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

#include "documents/failure.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace flg::cli {
namespace {

constexpr double kInset = 2;        // pixels: so near to an outline, colours are mixed with what is beyond
constexpr uint8_t kOpaque = 128;    // alpha: below it a pixel is background
constexpr int kMostPixels = 16384;  // a side
constexpr size_t kChannels = 4;

// A part's drawing, lying flat in the model: point * scale + at.
struct Flat {
    explicit Flat(const DrawnPart& part) {
        const auto& m = part.placement;
        scale = std::sqrt(m[0] * m[0] + m[4] * m[4] + m[8] * m[8]);
        at = {m[3], m[7]};
    }
    double scale;
    std::array<double, 2> at;
};

struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> pixels;

    size_t count() const { return size_t(width) * size_t(height); }
};

Picture read_picture(const std::string& path) {
    Picture picture;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load(path.c_str(), &picture.width, &picture.height, &channels, int(kChannels)), stbi_image_free);
    if (!pixels) throw InputError(path + ": cannot be read as a picture: " + stbi_failure_reason());
    if (picture.width > kMostPixels || picture.height > kMostPixels)
        throw InputError(path + ": has more than 16384 pixels a side");
    picture.pixels.assign(pixels.get(), pixels.get() + kChannels * picture.count());
    return picture;
}

// Marks the pixels whose middles are within a part's outline, in its picture: by the crossings of each row.
void fill(const DrawnPart& part, const Picture& picture, std::vector<uint8_t>& inside) {
    const auto& [left, bottom, right, top] = part.picture;
    const std::vector<double>& points = part.contour.points;
    std::vector<std::vector<double>> crossings(size_t(picture.height));
    for (size_t ring = 0; ring + 1 < part.contour.offsets.size(); ++ring) {
        const size_t begin = part.contour.offsets[ring], end = part.contour.offsets[ring + 1];
        for (size_t i = begin; i < end; ++i) {
            const size_t next = i + 1 == end ? begin : i + 1;
            const auto x = [&](size_t p) { return (points[2 * p] - left) / (right - left) * picture.width; };
            const auto y = [&](size_t p) { return (top - points[2 * p + 1]) / (top - bottom) * picture.height; };
            const double low = std::min(y(i), y(next)), high = std::max(y(i), y(next));
            const double first = std::max(0.0, std::ceil(low - 0.5));
            for (double row = first; row + 0.5 < high && row < picture.height; ++row)
                crossings[size_t(row)].push_back(x(i) + (x(next) - x(i)) * (row + 0.5 - y(i)) / (y(next) - y(i)));
        }
    }
    for (size_t row = 0; row < crossings.size(); ++row) {
        std::sort(crossings[row].begin(), crossings[row].end());
        for (size_t k = 0; k + 1 < crossings[row].size(); k += 2) {
            const double first = std::max(0.0, std::ceil(crossings[row][k] - 0.5));
            for (double column = first; column + 0.5 < crossings[row][k + 1] && column < picture.width; ++column)
                inside[row * size_t(picture.width) + size_t(column)] = 1;
        }
    }
}

// Of each pixel the nearest one that is marked, by passing them on (Danielsson: Euclidean distance mapping, 1980).
class NearestPixels {
public:
    NearestPixels(const Picture& picture, const std::vector<uint8_t>& marked)
        : width_(picture.width), height_(picture.height), nearest_(marked.size(), kNone) {
        for (size_t i = 0; i < marked.size(); ++i)
            if (marked[i]) nearest_[i] = int(i);
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) offer(x, y, {{{-1, 0}, {0, -1}, {-1, -1}, {1, -1}}});
            for (int x = width_; x-- > 0;) offer(x, y, {{{1, 0}, {0, 0}, {0, 0}, {0, 0}}});
        }
        for (int y = height_; y-- > 0;) {
            for (int x = width_; x-- > 0;) offer(x, y, {{{1, 0}, {0, 1}, {1, 1}, {-1, 1}}});
            for (int x = 0; x < width_; ++x) offer(x, y, {{{-1, 0}, {0, 0}, {0, 0}, {0, 0}}});
        }
    }

    // kNone where nothing is marked.
    int of(size_t pixel) const { return nearest_[pixel]; }
    double distance(size_t pixel) const {
        return nearest_[pixel] == kNone ? HUGE_VAL
                                        : std::sqrt(squared(int(pixel) % width_, int(pixel) / width_, nearest_[pixel]));
    }
    static constexpr int kNone = -1;

private:
    double squared(int x, int y, int to) const {
        const double dx = to % width_ - x, dy = to / width_ - y;
        return dx * dx + dy * dy;
    }
    void offer(int x, int y, const std::array<std::array<int, 2>, 4>& steps) {
        int& own = nearest_[size_t(y) * size_t(width_) + size_t(x)];
        for (const auto& [dx, dy] : steps) {
            if (x + dx < 0 || x + dx >= width_ || y + dy < 0 || y + dy >= height_) continue;
            const int other = nearest_[size_t(y + dy) * size_t(width_) + size_t(x + dx)];
            if (other != kNone && (own == kNone || squared(x, y, other) < squared(x, y, own))) own = other;
        }
    }

    int width_, height_;
    std::vector<int> nearest_;
};

// Within an outline, and not at its rim; of what is too thin for that, the middle.
std::vector<uint8_t> kept_pixels(const Picture& picture, const std::vector<uint8_t>& inside) {
    std::vector<uint8_t> outside(inside.size());
    for (size_t i = 0; i < inside.size(); ++i) outside[i] = !inside[i] || picture.pixels[kChannels * i + 3] < kOpaque;
    const NearestPixels nearest(picture, outside);
    std::vector<uint8_t> kept(inside.size());
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const size_t i = size_t(y) * size_t(picture.width) + size_t(x);
            if (outside[i]) continue;
            const double own = nearest.distance(i);
            bool is_middle = own > 0;
            for (int dy = -1; dy <= 1 && is_middle; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int u = std::clamp(x + dx, 0, picture.width - 1),
                              v = std::clamp(y + dy, 0, picture.height - 1);
                    is_middle = is_middle && nearest.distance(size_t(v) * size_t(picture.width) + size_t(u)) <= own;
                }
            kept[i] = own > kInset || is_middle;
        }
    }
    return kept;
}

void append_bytes(void* to, void* data, int size) {
    auto& bytes = *static_cast<std::vector<uint8_t>*>(to);
    const auto* from = static_cast<const uint8_t*>(data);
    bytes.insert(bytes.end(), from, from + size);
}

}  // namespace

std::vector<double> page_of_svg(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const size_t begin = text.find("<svg");
    if (begin == std::string::npos) return {};
    const std::string tag = text.substr(begin, text.find('>', begin) - begin);
    // The numbers of an attribute, up to a unit: px, the only one that is the drawing's.
    const auto numbers = [&](const std::string& name) {
        std::vector<double> values;
        const size_t at = tag.find(" " + name + "=");
        if (at == std::string::npos) return values;
        const size_t first = at + name.size() + 3;
        std::string list = tag.substr(first, tag.find(tag[first - 1], first) - first);
        std::replace(list.begin(), list.end(), ',', ' ');
        std::istringstream stream(list);
        for (double value = 0; stream >> value;) values.push_back(value);
        return values;
    };
    const std::vector<double> box = numbers("viewBox"), width = numbers("width"), height = numbers("height");
    if (box.size() == 4 && box[2] > 0 && box[3] > 0) return {box[0], -box[1] - box[3], box[0] + box[2], -box[1]};
    if (width.size() == 1 && height.size() == 1 && width[0] > 0 && height[0] > 0) return {0, -height[0], width[0], 0};
    return {};
}

DecodedPicture decode_picture(const uint8_t* file, uint64_t size, const std::string& subject) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        size > INT32_MAX ? nullptr : stbi_load_from_memory(file, int(size), &width, &height, &channels, int(kChannels)),
        stbi_image_free);
    if (!pixels)
        throw InputError(subject + ": a texture can't be decoded: " +
                         (size > INT32_MAX ? "it is above 2 GiB" : stbi_failure_reason()));
    const size_t bytes = kChannels * size_t(width) * size_t(height);
    return {uint32_t(width), uint32_t(height), {pixels.get(), pixels.get() + bytes}};
}

void place_picture(const PictureOptions& options, ModelDrawing& drawing) {
    std::array<double, 4> box = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const DrawnPart& part : drawing.parts) {
        const Flat flat(part);
        for (size_t i = 0; i < part.contour.points.size(); ++i) {
            const double value = part.contour.points[i] * flat.scale + flat.at[i % 2];
            box[i % 2] = std::min(box[i % 2], value);
            box[2 + i % 2] = std::max(box[2 + i % 2], value);
        }
    }
    if (options.box.size() == box.size()) std::copy(options.box.begin(), options.box.end(), box.begin());
    for (DrawnPart& part : drawing.parts) {
        const Flat flat(part);
        if (part.picture != std::array<double, 4>{}) continue;
        for (size_t k = 0; k < box.size(); ++k) part.picture[k] = (box[k] - flat.at[k % 2]) / flat.scale;
    }
}

std::vector<uint8_t> bled_picture(const PictureOptions& options, const ModelDrawing& drawing) {
    Picture picture = read_picture(options.file);
    std::vector<uint8_t> inside(picture.count());
    for (const DrawnPart& part : drawing.parts) fill(part, picture, inside);
    const NearestPixels nearest(picture, kept_pixels(picture, inside));
    std::vector<uint8_t> bled(kChannels * picture.count());
    for (size_t i = 0; i < picture.count(); ++i) {
        const int from = nearest.of(i);
        if (from == NearestPixels::kNone)
            throw InputError(options.file +
                             ": no part of the drawing shows any of it; --texture-box says where it lies");
        std::copy_n(&picture.pixels[kChannels * size_t(from)], 3, &bled[kChannels * i]);
        bled[kChannels * i + 3] = 255;
    }
    std::vector<uint8_t> png;
    if (stbi_write_png_to_func(append_bytes, &png, picture.width, picture.height, int(kChannels), bled.data(),
                               picture.width * int(kChannels)) == 0)
        throw InputError(options.file + ": cannot be written as PNG");
    return png;
}

}  // namespace flg::cli
