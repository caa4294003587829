// SPDX-License-Identifier: MIT
// The filter and the expansions are those of Shewchuk: Adaptive precision floating-point arithmetic and fast robust
// geometric predicates, 1997.
#include "skeletons/point2.h"

#include <cmath>

namespace flg {

namespace {

constexpr double filter = 0x1.8p-52;  // above (3 + 16 epsilon) epsilon, with epsilon = 2^-53

// A sum kept exactly, as parts that do not overlap, the smallest first.
struct Expansion {
    double parts[12];
    int count = 0;

    void add(double value) {
        double sum = value;
        int kept = 0;
        for (int i = 0; i < count; ++i) {
            const double total = sum + parts[i], shown = total - sum;
            const double lost = (sum - (total - shown)) + (parts[i] - shown);
            if (lost != 0) parts[kept++] = lost;
            sum = total;
        }
        if (sum != 0) parts[kept++] = sum;
        count = kept;
    }
    void add_product(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }
    int sign() const { return count == 0 ? 0 : parts[count - 1] > 0 ? 1 : -1; }
};

int exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
    Expansion sum;
    sum.add_product(a.x, b.y);
    sum.add_product(-a.x, c.y);
    sum.add_product(b.x, c.y);
    sum.add_product(-b.x, a.y);
    sum.add_product(c.x, a.y);
    sum.add_product(-c.x, b.y);
    return sum.sign();
}

}  // namespace

int orientation(const Point2& a, const Point2& b, const Point2& c) {
    const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x), difference = left - right;
    if (std::fabs(difference) > filter * (std::fabs(left) + std::fabs(right))) return difference > 0 ? 1 : -1;
    return exact_orientation(a, b, c);
}

}  // namespace flg
