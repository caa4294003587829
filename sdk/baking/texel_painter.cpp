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
    : canvas_(canvas),
      owners_(owners),
      wants_distances_(canvas.request.wants_distances()),
      wants_heights_(canvas.request.wants_heights()),
      near_(canvas.borders, memory) {}

uint32_t TexelPainter::begin(uint32_t triangle) {
    const BakeRequest& request = canvas_.request;
    const Mesh& mesh = canvas_.surface.mesh();
    const TexelTriangle& corners = canvas_.triangles[triangle];
    y_ = end_row_ = 0;
    std::array<double, 3> x, y;
    for (size_t k = 0; k < 3; ++k) x[k] = double{corners[k][0]}, y[k] = double{corners[k][1]};
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0) return 1;
    const double per_area = 1 / area;
    // Texels whose middles lie within the box.
    const auto [west, east] = std::minmax({x[0], x[1], x[2]});
    const auto [north, south] = std::minmax({y[0], y[1], y[2]});
    const auto texel = [&request](double place) {
        return static_cast<uint32_t>(std::clamp(place, 0.0, request.size - 1.0));
    };
    left_ = texel(std::ceil(west - 0.5 - edge_slack));
    right_ = texel(std::floor(east - 0.5 + edge_slack));
    const uint32_t top = std::max(owners_.first_row, texel(std::ceil(north - 0.5 - edge_slack)));
    const uint32_t bottom = std::min(owners_.end_row, texel(std::floor(south - 0.5 + edge_slack)) + 1);
    if (top >= bottom || left_ > right_) return 1;
    for (size_t k = 0; k < 3; ++k) {
        const size_t next = (k + 1) % 3, last = (k + 2) % 3;
        Rise& weight = weights_[k];
        weight.dx = (y[next] - y[last]) * per_area;
        weight.dy = (x[last] - x[next]) * per_area;
        weight.from = -weight.dx * x[next] - weight.dy * y[next];
        slack_[k] = -edge_slack * std::sqrt(weight.dx * weight.dx + weight.dy * weight.dy);
        columns_[k] = -1 / weight.dx;
    }
    const uint32_t source = mesh.source_triangles[triangle];
    const Triple& inputs = (*canvas_.surface.input_triangles)[source];
    if (!plane_.set(request.positions, inputs, &request.corner_uvs[6 * size_t{source}], request.size)) return 4;
    half_line_ = static_cast<float>(0.5 * double{request.border_width} * plane_.per_metre);
    half_texel_ = static_cast<float>(0.5 * plane_.diagonal());
    set_heights(triangle);
    label_ = mesh.regions[triangle];
    batch_.count = 0;
    if (wants_distances_) near_.begin(mesh.triangles[triangle]);
    y_ = top;
    end_row_ = bottom;
    begin_row();
    return 16;
}

// What displacement made of the corners.
void TexelPainter::set_heights(uint32_t triangle) {
    is_flat_ = true;
    if (canvas_.shape.heights.empty()) return;
    for (size_t k = 0; k < 3; ++k) {
        const uint32_t v = canvas_.surface.mesh().triangles[triangle][k];
        const Vec3 slope = load_vec3(canvas_.shape.slopes[v].data());
        heights_[k] = canvas_.shape.heights[v];
        slopes_x_[k] = static_cast<float>(slope.dot(plane_.axis_x));
        slopes_y_[k] = static_cast<float>(-slope.dot(plane_.axis_y));
        is_flat_ &= heights_[k] == 0 && slopes_x_[k] == 0 && slopes_y_[k] == 0;
    }
}

uint32_t TexelPainter::run(uint32_t units) {
    uint32_t done = 0;
    while (done < units) {
        if (batch_.count < TexelBatch::lanes && y_ < end_row_) {
            done += take_texels();
        } else if (batch_.count == 0) {
            break;
        } else if (wants_distances_ && !near_.is_gathered()) {
            done += near_.gather(plane_, units - done);
        } else if (wants_distances_ && !near_.is_searched()) {
            done += near_.search(batch_, units - done);
        } else {
            for (uint32_t i = 0; i < batch_.count; ++i) {
                const Nearest found = {
                    std::sqrt(batch_.distances_sq[i]),
                    batch_.nearest[i] < 0 ? nullptr : &near_[static_cast<size_t>(batch_.nearest[i])]};
                paint(batch_.texels[i][0], batch_.texels[i][1], found);
            }
            done += batch_.count * (1 + canvas_.request.component_count / 8);
            batch_.count = 0;
        }
    }
    return done;
}

// The texels of a row whose middles lie within.
void TexelPainter::begin_row() {
    double begin = left_, end = right_;
    for (size_t k = 0; k < 3; ++k) {
        const Rise& weight = weights_[k];
        const double room = weight.at(0.5, y_ + 0.5) - slack_[k];  // at the first column
        if (weight.dx > 0) begin = std::max(begin, room * columns_[k]);
        if (weight.dx < 0) end = std::min(end, room * columns_[k]);
        if (weight.dx == 0 && room < 0) end = -1;
    }
    x_ = begin < end + 1 ? static_cast<uint32_t>(std::ceil(begin)) : 1;
    stop_ = begin < end + 1 ? static_cast<uint32_t>(std::floor(end + 1)) : 0;
}

// Up to as many as the batch has lanes left, of one row.
uint32_t TexelPainter::take_texels() {
    constexpr uint32_t looks = 8;  // a unit
    const uint32_t from = x_;
    if (batch_.count == 0) near_.begin_search(batch_);
    for (; x_ < stop_ && batch_.count < TexelBatch::lanes; ++x_) {
        if (!owners_.take(x_, y_)) continue;
        batch_.texels[batch_.count] = {x_, y_};
        batch_.x[batch_.count] = plane_.x(x_ + 0.5, y_ + 0.5);
        batch_.y[batch_.count] = plane_.y(y_ + 0.5);
        ++batch_.count;
    }
    const uint32_t looked = x_ > from ? x_ - from : 0;
    if (x_ >= stop_) {
        ++y_;
        begin_row();
    }
    return 1 + looked / looks;
}

void TexelPainter::paint(uint32_t x, uint32_t y, const Nearest& found) {
    const BakeRequest& request = canvas_.request;
    const BakedMaps& maps = request.maps;
    const size_t texel = size_t{y} * request.size + x;
    if (maps.ids) maps.ids[texel] = label_;
    if (wants_distances_) {
        if (maps.distances) maps.distances[texel] = static_cast<float>(double{found.distance} * plane_.unit);
        if (maps.borders) maps.borders[texel] = share_of_line(found);
        if (maps.blends) write_blends(texel, found);
    }
    if (wants_heights_) paint_height(texel, x + 0.5, y + 0.5);
}

void TexelPainter::paint_height(size_t texel, double right, double down) {
    const BakedMaps& maps = canvas_.request.maps;
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

// Of the texel's width across the line, what lies on the line: both begin and end somewhere. In 255ths.
uint8_t TexelPainter::share_of_line(const Nearest& found) const {
    if (!found.piece || found.distance >= half_line_ + half_texel_) return 0;
    const float half = 0.5f * found.piece->width(plane_);
    if (half <= 0) return found.distance < half_line_ ? 255 : 0;
    const float common = std::min(found.distance + half, half_line_) - std::max(found.distance - half, -half_line_);
    return static_cast<uint8_t>(255.0f * std::clamp(common / (2 * half), 0.0f, 1.0f) + 0.5f);
}

void TexelPainter::write_blends(size_t texel, const Nearest& found) const {
    const BakeRequest& request = canvas_.request;
    const size_t count = request.component_count;
    float* const out = request.maps.blends + texel * count;
    const float* const own = &request.region_values[label_ * count];
    const float width = found.piece && found.distance < half_texel_ ? found.piece->width(plane_) : 0;
    if (2 * found.distance >= width) {
        for (size_t c = 0; c < count; ++c) out[c] = own[c];
        return;
    }
    const auto [one, other] = canvas_.borders.pieces[found.piece->piece].labels;
    const uint32_t beyond = canvas_.tree[one].look == canvas_.tree[label_].look ? other : one;
    const float* const theirs = &request.region_values[beyond * count];
    const float share = 0.5f + found.distance / width;
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
