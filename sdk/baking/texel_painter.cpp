// SPDX-License-Identifier: MIT
#include "baking/texel_painter.h"

#include <cmath>
#include <limits>

namespace flg {

namespace {

constexpr double edge_slack = 0.005;  // texels: owners are of whole 256ths
constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

TexelPainter::TexelPainter(const Canvas& canvas, TexelOwners& owners, Memory* memory)
    : canvas_(canvas), owners_(owners), near_(memory) {}

uint32_t TexelPainter::begin(uint32_t triangle) {
    const TexelTriangle& corners = canvas_.triangles[triangle];
    y_ = end_ = 0;
    std::array<double, 3> x, y;
    for (size_t k = 0; k < 3; ++k) x[k] = double{corners[k][0]}, y[k] = double{corners[k][1]};
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0) return 1;
    // Texels whose middles lie within the box.
    const auto [west, east] = std::minmax({x[0], x[1], x[2]});
    const auto [north, south] = std::minmax({y[0], y[1], y[2]});
    const auto texel = [this](double place) {
        return static_cast<uint32_t>(std::clamp(place, 0.0, canvas_.request.size - 1.0));
    };
    left_ = texel(std::ceil(west - 0.5 - edge_slack));
    right_ = texel(std::floor(east - 0.5 + edge_slack));
    y_ = std::max(owners_.first_row, texel(std::ceil(north - 0.5 - edge_slack)));
    end_ = std::min(owners_.end_row, texel(std::floor(south - 0.5 + edge_slack)) + 1);
    x_ = left_;
    if (y_ >= end_ || left_ > right_) {
        end_ = 0;
        return 1;
    }
    for (size_t k = 0; k < 3; ++k) {
        const size_t next = (k + 1) % 3, last = (k + 2) % 3;
        Rise& weight = weights_[k];
        weight.dx = (y[next] - y[last]) / area;
        weight.dy = (x[last] - x[next]) / area;
        weight.from = -weight.dx * x[next] - weight.dy * y[next];
        slack_[k] = -edge_slack * std::hypot(weight.dx, weight.dy);
    }
    if (!place_triangle(triangle)) {
        end_ = 0;
        return 4;
    }
    label_ = canvas_.surface.mesh().regions[triangle];
    near_.clear();
    if (canvas_.request.wants_distances()) gather(triangle);
    texel_units_ = 1 + static_cast<uint32_t>(near_.size()) / 8;
    return 8 + 2 * static_cast<uint32_t>(near_.size());
}

// The plane that the mesh's triangle spans, and what displacement made of the corners.
bool TexelPainter::place_triangle(uint32_t triangle) {
    const Mesh& mesh = canvas_.surface.mesh();
    const BakeRequest& request = canvas_.request;
    const uint32_t source = mesh.source_triangles[triangle];
    const Triple& corners = (*canvas_.surface.input_triangles)[source];
    const float* const uvs = &request.corner_uvs[6 * size_t{source}];
    const double size = request.size;
    const double x1 = size * (double{uvs[2]} - double{uvs[0]}), y1 = size * (double{uvs[3]} - double{uvs[1]});
    const double x2 = size * (double{uvs[4]} - double{uvs[0]}), y2 = size * (double{uvs[5]} - double{uvs[1]});
    const double area = x1 * y2 - x2 * y1;
    if (area == 0) return false;
    origin_ = load_vec3(request.positions[corners[0]].data());
    const Vec3 first = load_vec3(request.positions[corners[1]].data()) - origin_;
    const Vec3 second = load_vec3(request.positions[corners[2]].data()) - origin_;
    const Vec3 right = (y2 * first - y1 * second) / area, down = (x1 * second - x2 * first) / area;
    corner_ = {size * double{uvs[0]}, size * double{uvs[1]}};
    step_x_ = right.stableNorm();
    axis_x_ = right.stableNormalized();
    row_x_ = axis_x_.dot(down);
    const Vec3 across = down - row_x_ * axis_x_;
    row_y_ = across.stableNorm();
    axis_y_ = across.stableNormalized();
    axis_z_ = axis_x_.cross(axis_y_);

    is_flat_ = canvas_.shape.heights.empty();
    if (is_flat_) return true;
    bool rises = false;
    for (size_t k = 0; k < 3; ++k) {
        const uint32_t v = mesh.triangles[triangle][k];
        const Vec3 slope = load_vec3(canvas_.shape.slopes[v].data());
        heights_[k] = canvas_.shape.heights[v];
        slopes_x_[k] = static_cast<float>(slope.dot(axis_x_));
        slopes_y_[k] = static_cast<float>(-slope.dot(axis_y_));
        rises |= heights_[k] != 0 || slopes_x_[k] != 0 || slopes_y_[k] != 0;
    }
    is_flat_ = !rises;
    return true;
}

void TexelPainter::gather(uint32_t triangle) {
    for (const uint32_t v : canvas_.surface.mesh().triangles[triangle])
        canvas_.borders.visit_near(v, [&](uint32_t piece) { add_piece(piece); });
}

void TexelPainter::add_piece(uint32_t piece) {
    for (const NearPiece& known : near_)
        if (known.piece == piece) return;
    const BorderPiece& border = canvas_.borders.pieces[piece];
    const Vec3 from = load_vec3(canvas_.shape.places[border.ends[0]].data());
    const Vec3 along = load_vec3(canvas_.shape.places[border.ends[1]].data()) - from;
    const double length_sq = along.squaredNorm();
    const double along_x = axis_x_.dot(along), along_y = axis_y_.dot(along);
    const double flat_length = std::hypot(along_x, along_y);
    // How far one texel on, and one row on, lead across it.
    const double over_x = flat_length > 0 ? along_y * step_x_ / flat_length : step_x_;
    const double over_y = flat_length > 0 ? (along_y * row_x_ - along_x * row_y_) / flat_length : row_y_;
    const Vec3 offset = from - origin_;
    near_.push_back({static_cast<float>(axis_x_.dot(offset)), static_cast<float>(axis_y_.dot(offset)),
                     static_cast<float>(axis_z_.dot(offset)), static_cast<float>(along_x), static_cast<float>(along_y),
                     static_cast<float>(axis_z_.dot(along)), length_sq > 0 ? static_cast<float>(1 / length_sq) : 0.0f,
                     static_cast<float>(std::hypot(over_x, over_y)), piece});
}

uint32_t TexelPainter::run(uint32_t units) {
    if (y_ >= end_) return 0;
    uint32_t done = 0;
    while (y_ < end_ && done < units) {
        const double down = y_ + 0.5;
        const std::array<double, 3> rows = {weights_[0].at(0, down), weights_[1].at(0, down), weights_[2].at(0, down)};
        uint32_t looked = 0;
        for (; x_ <= right_ && done + looked / 8 < units; ++x_, ++looked) {
            const double middle = x_ + 0.5;
            bool inside = true;
            for (size_t k = 0; k < 3; ++k) inside &= rows[k] + weights_[k].dx * middle >= slack_[k];
            if (!inside || !owners_.take(x_, y_)) continue;
            paint(x_, middle, down);
            done += texel_units_;
        }
        done += 1 + looked / 8;
        if (x_ <= right_) break;
        x_ = left_;
        ++y_;
    }
    return done;
}

void TexelPainter::paint(uint32_t x, double right, double down) {
    const BakeRequest& request = canvas_.request;
    const BakedMaps& maps = request.maps;
    const size_t texel = size_t{y_} * request.size + x;
    if (maps.ids) maps.ids[texel] = label_;
    if (request.wants_distances()) {
        const double along = right - corner_[0], rows = down - corner_[1];
        const Nearest found =
            nearest(static_cast<float>(step_x_ * along + row_x_ * rows), static_cast<float>(row_y_ * rows));
        if (maps.distances) maps.distances[texel] = found.distance;
        if (maps.borders) maps.borders[texel] = static_cast<uint8_t>(255.0f * share_of_line(found) + 0.5f);
        if (maps.blends) write_blends(texel, found);
    }
    if (!request.wants_heights()) return;
    float height = 0, normal_x = 0, normal_y = 0, normal_z = 1;
    if (!is_flat_) {
        std::array<float, 3> weights;
        weights[1] = static_cast<float>(std::clamp(weights_[1].at(right, down), 0.0, 1.0));
        weights[2] = static_cast<float>(std::clamp(weights_[2].at(right, down), 0.0, 1.0 - double{weights[1]}));
        weights[0] = 1 - weights[1] - weights[2];
        for (size_t k = 0; k < 3; ++k) {
            height += weights[k] * heights_[k];
            normal_x -= weights[k] * slopes_x_[k];
            normal_y -= weights[k] * slopes_y_[k];
        }
        normal_z = 1 / std::sqrt(1 + normal_x * normal_x + normal_y * normal_y);
        normal_x *= normal_z;
        normal_y *= normal_z;
    }
    if (maps.heights) maps.heights[texel] = height;
    if (!maps.normals) return;
    maps.normals[3 * texel] = normal_x;
    maps.normals[3 * texel + 1] = normal_y;
    maps.normals[3 * texel + 2] = normal_z;
}

TexelPainter::Nearest TexelPainter::nearest(float x, float y) const {
    float least = infinity;
    const NearPiece* of = nullptr;
    for (const NearPiece& piece : near_) {
        const float to_x = x - piece.x, to_y = y - piece.y, to_z = -piece.z;
        const float dot = to_x * piece.along_x + to_y * piece.along_y + to_z * piece.along_z;
        const float share = std::clamp(dot * piece.inverse_length_sq, 0.0f, 1.0f);
        const float off_x = to_x - share * piece.along_x, off_y = to_y - share * piece.along_y,
                    off_z = to_z - share * piece.along_z;
        const float found = off_x * off_x + off_y * off_y + off_z * off_z;
        if (found >= least) continue;
        least = found;
        of = &piece;
    }
    return {std::sqrt(least), of};
}

// Of the texel's width across the line, what lies on the line: both begin and end somewhere.
float TexelPainter::share_of_line(const Nearest& found) const {
    if (!found.piece) return 0;
    const float half_line = 0.5f * canvas_.request.border_width, half = 0.5f * found.piece->width;
    if (half <= 0) return found.distance < half_line ? 1.0f : 0.0f;
    const float common = std::min(found.distance + half, half_line) - std::max(found.distance - half, -half_line);
    return std::clamp(common / (2 * half), 0.0f, 1.0f);
}

void TexelPainter::write_blends(size_t texel, const Nearest& found) const {
    const BakeRequest& request = canvas_.request;
    const size_t count = request.component_count;
    float* const out = request.maps.blends + texel * count;
    const float* const own = &request.region_values[label_ * count];
    const bool crosses = found.piece && 2 * found.distance < found.piece->width;
    if (!crosses) {
        for (size_t c = 0; c < count; ++c) out[c] = own[c];
        return;
    }
    const auto [one, other] = canvas_.borders.pieces[found.piece->piece].labels;
    const uint32_t beyond = canvas_.tree[one].look == canvas_.tree[label_].look ? other : one;
    const float* const theirs = &request.region_values[beyond * count];
    const float share = 0.5f + found.distance / found.piece->width;
    for (size_t c = 0; c < count; ++c) out[c] = theirs[c] + share * (own[c] - theirs[c]);
}

void paint_background(const BakeRequest& request, size_t texel) {
    const BakedMaps& maps = request.maps;
    if (maps.ids) maps.ids[texel] = no_index;
    if (maps.distances) maps.distances[texel] = infinity;
    if (maps.borders) maps.borders[texel] = 0;
    if (maps.heights) maps.heights[texel] = 0;
    if (maps.normals) {
        maps.normals[3 * texel] = maps.normals[3 * texel + 1] = 0;
        maps.normals[3 * texel + 2] = 1;
    }
    if (!maps.blends) return;
    for (size_t c = 0; c < request.component_count; ++c) maps.blends[texel * request.component_count + c] = 0;
}

}  // namespace flg
