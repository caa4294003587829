// SPDX-License-Identifier: MIT
#include "splines/cable_contacts.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t piece_looks = 48;                     // at a piece, at most
constexpr uint32_t rough_parts = 8, refined_parts = 32;  // of a piece, where distances are not convex
constexpr uint32_t rough_work = 16, refined_work = 40;   // of Cost::microseconds
constexpr double most_drop = 0.25;                       // of a solid's core_depth(), so that nothing goes through
constexpr double like_before = 0.5;                      // the cosine of planes' angle: one takes the other's forces

// Where a straight piece is nearest to an obstacle. Outwards is across the piece unless that is at an end of it: on an
// edge of the solid, between both sides' directions.
struct Lowest {
    double away = HUGE_VAL;  // metres
    double at = 0;           // 0 to 1
    Vec3 outwards = Vec3::Zero();
};

struct PieceLook {
    double away, slope;  // metres, by the share of the piece
    Vec3 outwards;
};

PieceLook look_at_piece(const ObstacleSet& set, uint32_t obstacle, const Vec3& a, const Vec3& b, double at) {
    const Vec3 place = a + at * (b - a);
    PieceLook look{};
    look.away = set[obstacle].evaluate_exactly(place.data(), look.outwards.data(), nullptr) - set.clearance();
    look.slope = look.outwards.dot(b - a);
    return look;
}

// Of a distance that is convex between two places of the piece: by its tangents there, which bound it from below, and
// where they meet. If that is no less than `enough`, it is not looked for.
Lowest lowest_between(const ObstacleSet& set, uint32_t obstacle, const Vec3& a, const Vec3& b, double low, double high,
                      double enough) {
    PieceLook below = look_at_piece(set, obstacle, a, b, low), above = look_at_piece(set, obstacle, a, b, high);
    Lowest out;
    const auto take = [&](const PieceLook& look, double at) {
        if (look.away < out.away) out = {look.away, at, look.outwards};
    };
    take(below, low);
    take(above, high);
    const double fine = 1e-13 * (b - a).norm();
    for (uint32_t round = 0; round < piece_looks && below.slope < 0 && above.slope > 0; ++round) {
        const double fall = above.slope - below.slope;
        const double meet =
            std::clamp((below.away - above.away + above.slope * high - below.slope * low) / fall, low, high);
        const double bound =
            std::max(below.away + below.slope * (meet - low), above.away + above.slope * (meet - high));
        // Both tangents pass there.
        const bool is_found = out.away - bound <= fine || high - low < 1e-9;
        if (is_found || (bound >= enough && out.away >= enough)) {
            out.at = meet;
            out.away = std::min(out.away, std::max(bound, out.away - fine));
            out.outwards = (above.slope * below.outwards - below.slope * above.outwards) / fall;
            break;
        }
        const double least_step = 1e-3 * (high - low), at = std::clamp(meet, low + least_step, high - least_step);
        const PieceLook look = look_at_piece(set, obstacle, a, b, at);
        take(look, at);
        (look.slope < 0 ? low : high) = at;
        (look.slope < 0 ? below : above) = look;
        if (look.slope == 0) break;
    }
    return out;
}

Lowest lowest_of_piece(const ObstacleSet& set, uint32_t obstacle, const Vec3& a, const Vec3& b, double enough,
                       bool is_refined) {
    const double length = (b - a).norm();
    const Vec3 middle = 0.5 * (a + b);
    if (set.at_least(obstacle, middle.data()) >= enough + 0.5 * length) return {};
    if (set[obstacle].is_convex()) return lowest_between(set, obstacle, a, b, 0, 1, enough);
    const uint32_t parts = is_refined ? refined_parts : rough_parts;
    double least = HUGE_VAL, at = 0;
    for (double t = 0;;) {
        const Vec3 place = a + t * (b - a);
        const double limit = set.clearance() + enough + length / parts;
        const double away = set[obstacle].evaluate_exactly(place.data(), nullptr, nullptr, limit) - set.clearance();
        if (away < least) least = away, at = t;
        if (t >= 1 || length == 0) break;
        t = std::min(t + std::max((away - enough) / length, 1.0 / parts), 1.0);
    }
    if (least >= enough + 0.5 * length / parts) return {};
    return lowest_between(set, obstacle, a, b, std::max(at - 1.0 / parts, 0.0), std::min(at + 1.0 / parts, 1.0),
                          enough);
}

// With the force of the one before it, if there was one. Where there are too many the farthest goes.
ContactPlane* add_plane(const CableContacts& all, uint32_t obstacle, ContactPlane::Of of, const Vec3& outwards,
                        double away, const PieceContacts& before, PieceContacts& contacts) {
    if (!(away < all.reach)) return nullptr;
    ContactPlane* const end = contacts.planes + contacts.count;
    ContactPlane* out = end;
    if (contacts.count == PieceContacts::most) {
        out = std::max_element(contacts.planes, end,
                               [](const ContactPlane& p, const ContactPlane& q) { return p.away < q.away; });
        if (out->away <= away) return nullptr;
    } else {
        ++contacts.count;
    }
    *out = {};
    out->obstacle = obstacle;
    out->of = of;
    out->outwards = outwards;
    out->away = away;
    double nearest = like_before;
    for (uint32_t i = 0; i < before.count; ++i) {
        const ContactPlane& plane = before.planes[i];
        if (plane.obstacle != obstacle || plane.of != of || plane.outwards.dot(outwards) < nearest) continue;
        nearest = plane.outwards.dot(outwards);
        std::copy_n(plane.force, ContactPlane::most, out->force);
    }
    return out;
}

double distance_of(const ObstacleSet& set, uint32_t obstacle, const Vec3& x) {
    return set[obstacle].evaluate_exactly(x.data(), nullptr, nullptr) - set.clearance();
}

void add_lowest(const CableContacts& all, uint32_t obstacle, ContactPlane::Of of, const Lowest& lowest, const Vec3& a,
                const Vec3& b, const PieceContacts& before, PieceContacts& contacts) {
    ContactPlane* const plane = add_plane(all, obstacle, of, lowest.outwards, lowest.away, before, contacts);
    if (!plane) return;
    plane->at[0] = lowest.at;
    if (of == ContactPlane::Of::piece && all.turn_share == 0) {
        plane->at[0] = 0;
        plane->at[plane->count++] = 1;
    } else if (of == ContactPlane::Of::piece) {
        for (uint32_t end = 0; end < 2; ++end) {
            const double more = distance_of(all.set, obstacle, end == 0 ? a : b) - plane->away;
            plane->at[plane->count] = end;
            plane->drop[plane->count++] =
                std::clamp(all.turn_share * more, 0.0, most_drop * all.set[obstacle].core_depth());
        }
    }
    plane->height = lowest.outwards.dot(a + lowest.at * (b - a)) - lowest.away + contacts.margin;
}

// Whether the obstacle parts pieces from itself; then with the planes that it gives.
Task<bool> add_parting(Pace& pace, const CableContacts& all, uint32_t obstacle, const Buffer<Vec3>& places,
                       uint32_t piece, const PieceContacts& before, PieceContacts& contacts) {
    const double *const a = places[piece].data(), *const b = places[piece + 1].data();
    const double clearance = all.set.clearance();
    Obstacle::Parting parting[PieceContacts::most];
    uint32_t count = 0;
    for (uint32_t found = 0; found < PieceContacts::most; ++found) {
        count = all.set[obstacle].part(a, b, all.reach + clearance, parting, found);
        co_await pace;
        if (count == Obstacle::no_parting) co_return false;
        if (count == found) break;
    }
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 outwards(parting[i].outwards.data());
        ContactPlane* const plane =
            add_plane(all, obstacle, ContactPlane::Of::piece, outwards, parting[i].away - clearance, before, contacts);
        if (!plane) continue;
        plane->height = parting[i].height + clearance + contacts.margin;
        plane->at[plane->count++] = 1;
    }
    co_return true;
}

// Of a solid that is not convex, beside a piece. Returns what that took.
Task<uint32_t> add_planes_beside(Pace& pace, CableContacts& all, const Buffer<Vec3>& places, uint32_t piece, uint32_t i,
                                 const PieceContacts& before) {
    const Vec3 &a = places[piece], &b = places[piece + 1];
    using Of = ContactPlane::Of;
    const ObstacleSet& set = all.set;
    PieceContacts& contacts = all.pieces[piece];
    const double wide = all.reach + std::max(all.length, (b - a).norm());
    const PieceLook look = look_at_piece(set, i, a, b, 0);
    if (look.away > wide) co_return 1;
    if (look.away + set.clearance() > 0) {
        const bool is_parted = co_await add_parting(pace, all, i, places, piece, before, contacts);
        if (is_parted) co_return rough_work;
    }
    // What the piece kept above still parts it from what was near.
    bool is_kept = false;
    const uint32_t kept = contacts.is_refined ? 0 : before.count;
    for (uint32_t k = 0; k < kept && contacts.count < PieceContacts::most; ++k) {
        if (before.planes[k].obstacle != i || before.planes[k].of != Of::piece) continue;
        contacts.planes[contacts.count++] = before.planes[k];
        is_kept = true;
    }
    if (is_kept) co_return 1;
    if (piece > 0) add_lowest(all, i, Of::node, {look.away, 0, look.outwards}, a, b, before, contacts);
    const Lowest lowest = lowest_of_piece(set, i, a, b, all.length, contacts.is_refined);
    if (lowest.away < all.length && lowest.at > 0 && lowest.at < 1)
        add_lowest(all, i, Of::middle, lowest, a, b, before, contacts);
    co_return contacts.is_refined ? refined_work : rough_work;
}

}  // namespace

Task<void> place_planes(Pace& pace, CableContacts& all, const Buffer<Vec3>& places) {
    Slice slice(Cost::microseconds);
    for (uint32_t piece = 0; piece < all.pieces.size(); ++piece) {
        const PieceContacts before = all.pieces[piece];
        all.pieces[piece].count = 0;
        for (uint32_t i = 0; i < all.set.count(); ++i) {
            const Vec3 &a = places[piece], &b = places[piece + 1];
            if (all.set.at_least(i, a.data()) > all.reach + std::max(all.length, (b - a).norm())) continue;
            uint32_t work = 4;
            if (all.set[i].is_convex()) {
                const Lowest lowest = lowest_of_piece(all.set, i, a, b, all.reach, false);
                add_lowest(all, i, ContactPlane::Of::piece, lowest, a, b, before, all.pieces[piece]);
            } else {
                work = co_await add_planes_beside(pace, all, places, piece, i, before);
            }
            if (slice.is_over(work)) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
}

double least_distance(const ObstacleSet& set, uint32_t obstacle, const Vec3& a, const Vec3& b, double* at) {
    *at = 0;
    const Vec3 middle = 0.5 * (a + b);
    if (set.at_least(obstacle, middle.data()) > 0.5 * (b - a).norm()) return HUGE_VAL;
    // With a clearance it is not the boundary that counts.
    const bool is_boundary = set.clearance() == 0;
    if (is_boundary && set[obstacle].meets(a.data(), b.data()) == Obstacle::Meets::no) {
        const double away = set[obstacle].evaluate_exactly(a.data(), nullptr, nullptr);
        if (away >= 0) return away;
    }
    const Lowest lowest = lowest_of_piece(set, obstacle, a, b, 0, true);
    *at = lowest.at;
    return lowest.away;
}

Task<std::pmr::vector<Breach>> find_breaches(Pace& pace, const ObstacleSet& set, const Buffer<Vec3>& places,
                                             double slack) {
    std::pmr::vector<Breach> out(pace.memory());
    const auto pieces = static_cast<uint32_t>(places.size()) - 1;
    Slice slice(Cost::microseconds);
    for (uint32_t i = 0; i < pieces; ++i) {
        for (uint32_t k = 0; k < set.count(); ++k) {
            double at = 0;
            const double least = least_distance(set, k, places[i], places[i + 1], &at);
            if (least < (i == 0 || i + 1 == pieces ? -slack : 0)) out.push_back({i, k, at, -least});
            if (slice.is_over(least < HUGE_VAL ? 4 : 1)) co_await pace;
        }
    }
    co_return out;
}

Task<bool> is_free(Pace& pace, const ObstacleSet& set, const Buffer<Vec3>& places, double slack) {
    const std::pmr::vector<Breach> breaches = co_await find_breaches(pace, set, places, slack);
    const bool none = breaches.empty();
    co_return none;
}

Task<void> keep_farther(Pace& pace, CableContacts& contacts, const std::pmr::vector<Breach>& breaches, double rest) {
    co_await each(pace, breaches.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        const Breach& breach = breaches[i];
        PieceContacts& contact = contacts.pieces[breach.piece];
        if (contact.is_refined || contacts.set[breach.obstacle].is_convex())
            contact.margin += std::min(1.5 * breach.depth, 10 * rest) + 0.1 * rest;
        contact.is_refined = true;
    });
}

}  // namespace flg
