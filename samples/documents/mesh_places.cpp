// SPDX-License-Identifier: MIT
#include "documents/mesh_places.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "documents/failure.h"
#include "documents/text_lines.h"

namespace flg::cli {
namespace {

// As the SDK takes positions.
constexpr double kLargestCoordinate = 1e30;

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (size_t end; (end = text.find(separator)) != std::string_view::npos; text.remove_prefix(end + 1)) {
        parts.push_back(text.substr(0, end));
    }
    parts.push_back(text);
    return parts;
}

template <class T>
bool read_number(std::string_view text, T& value) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stop == end;
}

Place parse_place(const std::string& option, std::string_view text) {
    Place place{std::string(text), {}, {}};
    const std::vector<std::string_view> parts = split(text, ',');
    if (uint32_t vertex = 0; parts.size() == 1 && read_number(parts[0], vertex)) {
        place.vertex = vertex;
        return place;
    }
    bool good = parts.size() == 3;
    for (size_t i = 0; good && i < 3; ++i) {
        good = read_number(parts[i], place.position[i]) && std::abs(place.position[i]) <= kLargestCoordinate;
    }
    if (!good) throw CLI::ValidationError(option, "'" + place.text + "' is neither a vertex, V, nor a point, x,y,z");
    return place;
}

}  // namespace

CLI::Option* add_places(CLI::App& app, const std::string& option, std::vector<Place>& places,
                        const std::string& description) {
    const auto set = [option, &places](const std::string& text) {
        places.clear();
        for (const std::string_view part : split(text, ';')) places.push_back(parse_place(option, part));
    };
    return app.add_option_function<std::string>(option, set, description)->type_name("V|x,y,z[;...]");
}

CLI::Option* add_place(CLI::App& app, const std::string& option, Place& place, const std::string& description) {
    const auto set = [option, &place](const std::string& text) { place = parse_place(option, text); };
    return app.add_option_function<std::string>(option, set, description)->type_name("V|x,y,z");
}

PlaceFinder::PlaceFinder(const MeshSurface& surface, const std::string& option)
    : surface_(surface), view_(surface.view()), subject_(surface.name() + ": " + option) {}

uint32_t PlaceFinder::vertex(const Place& place) const {
    const uint32_t count = surface_.file().info().vertex_count;
    if (*place.vertex >= count) {
        throw InputError(subject_ + ": there is no vertex " + shortened(place.text) + ", they are 0 to " +
                         std::to_string(count - 1));
    }
    const uint32_t vertex = surface_.vertex_of_input(*place.vertex);
    if (vertex == FLG_NO_INDEX) throw InputError(subject_ + ": vertex " + shortened(place.text) + " is in no triangle");
    return vertex;
}

FlgSurfacePoint PlaceFinder::point(const Place& place) {
    if (place.vertex) {
        const uint32_t *first = view_.mesh->triangles, *end = first + size_t{3} * view_.mesh->triangle_count;
        const auto corner = static_cast<size_t>(std::find(first, end, vertex(place)) - first);
        return {static_cast<uint32_t>(corner / 3), corner % 3 == 1 ? 1.0f : 0.0f, corner % 3 == 2 ? 1.0f : 0.0f};
    }
    if (!search_) search_ = std::make_unique<NearestSearch>(view_, subject_);
    const NearestPoint found = search_->nearest(place.position);
    gap_ = std::max(gap_, found.distance);
    return found.point;
}

}  // namespace flg::cli
