// SPDX-License-Identifier: MIT
#include "skeletons/contour_edits.h"

#include <algorithm>
#include <cmath>

namespace flg::studio {

std::vector<double> follow_shares(const Ring& ring, uint32_t point, double reach) {
    const size_t n = ring.size();
    std::vector<double> along(n, 0.0), shares(n, 0.0);
    double length = 0.0;
    for (size_t k = 0; k < n; ++k) {
        const size_t i = (point + k) % n;
        along[i] = length;
        length += glm::distance(ring[i], ring[(i + 1) % n]);
    }
    for (size_t i = 0; i < n; ++i) {
        const double share = std::min(along[i], length - along[i]) / reach;
        if (share < 1.0) shares[i] = (1.0 - share * share) * (1.0 - share * share);
    }
    shares[point] = 1.0;
    return shares;
}

Contour with_point_moved(const Contour& contour, ContourPoint point, const glm::dvec2& by, double reach) {
    Contour moved = contour;
    Ring& ring = moved.rings[point.ring];
    const std::vector<double> shares = follow_shares(ring, point.index, reach);
    for (size_t i = 0; i < ring.size(); ++i) ring[i] += shares[i] * by;
    return moved;
}

Contour with_point_after(const Contour& contour, ContourPoint point, const glm::dvec2& at) {
    Contour larger = contour;
    Ring& ring = larger.rings[point.ring];
    ring.insert(ring.begin() + point.index + 1, at);
    return larger;
}

Contour without_point(const Contour& contour, ContourPoint point) {
    Contour smaller = contour;
    Ring& ring = smaller.rings[point.ring];
    ring.erase(ring.begin() + point.index);
    return smaller;
}

glm::dvec2 rounded(const glm::dvec2& point, double spacing) {
    const double step = std::pow(10.0, std::floor(std::log10(spacing)) - 2.0);
    return glm::round(point / step) * step;
}

}  // namespace flg::studio
