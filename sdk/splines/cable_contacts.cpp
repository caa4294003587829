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

// Where a distance that is convex between two places of the piece is least: by its tangents there, which bound it from
// below, and where they meet. If that is no less than `enough`, it is not looked for.
//
//     while (search.asks()) search.take(look_at_piece(set, obstacle, a, b, search.at));
class LowestSearch {
public:
    LowestSearch(double length, double low, double high, double enough)
        : at(low), low_(low), high_(high), enough_(enough), fine_(1e-13 * length) {}

    double at;  // what is asked for

    const Lowest& found() const { return out_; }
    bool asks() {
        if (looks_ < 2) {
            at = looks_ == 0 ? low_ : high_;
            return true;
        }
        if (is_found_ || looks_ == piece_looks + 2 || !(below_.slope < 0 && above_.slope > 0)) return false;
        const double fall = above_.slope - below_.slope;
        const double meet =
            std::clamp((below_.away - above_.away + above_.slope * high_ - below_.slope * low_) / fall, low_, high_);
        const double bound =
            std::max(below_.away + below_.slope * (meet - low_), above_.away + above_.slope * (meet - high_));
        // Both tangents pass there.
        is_found_ = out_.away - bound <= fine_ || high_ - low_ < 1e-9 || (bound >= enough_ && out_.away >= enough_);
        if (is_found_) {
            out_.at = meet;
            out_.away = std::min(out_.away, std::max(bound, out_.away - fine_));
            out_.outwards = (above_.slope * below_.outwards - below_.slope * above_.outwards) / fall;
            return false;
        }
        const double least_step = 1e-3 * (high_ - low_);
        at = std::clamp(meet, low_ + least_step, high_ - least_step);
        return true;
    }
    void take(const PieceLook& look) {
        if (look.away < out_.away) out_ = {look.away, at, look.outwards};
        const bool is_below = looks_ == 0 || (looks_ > 1 && look.slope < 0);
        (is_below ? low_ : high_) = at;
        (is_below ? below_ : above_) = look;
        is_found_ = looks_ > 1 && look.slope == 0;
        ++looks_;
    }

private:
    double low_, high_, enough_, fine_;
    PieceLook below_{}, above_{};
    Lowest out_;
    uint32_t looks_ = 0;
    bool is_found_ = false;
};

// Of a convex solid.
Lowest lowest_of_piece(const ObstacleSet& set, uint32_t obstacle, const Vec3& a, const Vec3& b, double enough) {
    if (!may_be_below(set, obstacle, a, b, enough)) return {};
    LowestSearch search((b - a).norm(), 0, 1, enough);
    while (search.asks()) search.take(look_at_piece(set, obstacle, a, b, search.at));
    return search.found();
}

// Of any: one look at a large mesh may take some ten microseconds.
Task<Lowest> lowest_of_any_piece(Pace& pace, const ObstacleSet& set, uint32_t obstacle, Vec3 a, Vec3 b, double enough,
                                 bool is_refined) {
    const double length = (b - a).norm();
    if (!may_be_below(set, obstacle, a, b, enough)) co_return Lowest();
    if (set[obstacle].is_convex()) co_return lowest_of_piece(set, obstacle, a, b, enough);
    const uint32_t parts = is_refined ? refined_parts : rough_parts;
    double least = HUGE_VAL, at = 0;
    for (double t = 0;;) {
        const Vec3 place = a + t * (b - a);
        const double limit = set.clearance() + enough + length / parts;
        const double away = set[obstacle].evaluate_exactly(place.data(), nullptr, nullptr, limit) - set.clearance();
        co_await pace;
        if (away < least) least = away, at = t;
        if (t >= 1 || length == 0) break;
        t = std::min(t + std::max((away - enough) / length, 1.0 / parts), 1.0);
    }
    if (least >= enough + 0.5 * length / parts) co_return Lowest();
    LowestSearch search(length, std::max(at - 1.0 / parts, 0.0), std::min(at + 1.0 / parts, 1.0), enough);
    while (search.asks()) {
        search.take(look_at_piece(set, obstacle, a, b, search.at));
        co_await pace;
    }
    co_return search.found();
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
    const Lowest lowest = co_await lowest_of_any_piece(pace, set, i, a, b, all.length, contacts.is_refined);
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
                const Lowest lowest = lowest_of_piece(all.set, i, a, b, all.reach);
                add_lowest(all, i, ContactPlane::Of::piece, lowest, a, b, before, all.pieces[piece]);
            } else {
                work = co_await add_planes_beside(pace, all, places, piece, i, before);
            }
            if (slice.is_over(work)) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
}

Task<Clearest> least_distance(Pace& pace, const ObstacleSet& set, uint32_t obstacle, Vec3 a, Vec3 b) {
    // With a clearance it is not the boundary that counts.
    const bool is_boundary = set.clearance() == 0;
    if (is_boundary && set[obstacle].meets(a.data(), b.data()) == Obstacle::Meets::no) {
        const double away = set[obstacle].evaluate_exactly(a.data(), nullptr, nullptr);
        co_await pace;
        if (away >= 0) {
            const Clearest clear{away, 0};
            co_return clear;
        }
    }
    const Lowest lowest = co_await lowest_of_any_piece(pace, set, obstacle, a, b, 0, true);
    const Clearest least{lowest.away, lowest.at};
    co_return least;
}

Task<std::pmr::vector<Breach>> find_breaches(Pace& pace, const ObstacleSet& set, const Buffer<Vec3>& places,
                                             double slack) {
    std::pmr::vector<Breach> out(pace.memory());
    const auto pieces = static_cast<uint32_t>(places.size()) - 1;
    Slice slice(Cost::tens_of_ns);
    for (uint32_t i = 0; i < pieces; ++i) {
        for (uint32_t k = 0; k < set.count(); ++k) {
            if (slice.is_over()) co_await pace;
            if (!may_be_below(set, k, places[i], places[i + 1], 0)) continue;
            const Clearest least = co_await least_distance(pace, set, k, places[i], places[i + 1]);
            if (least.away < (i == 0 || i + 1 == pieces ? -slack : 0)) out.push_back({i, k, least.at, -least.away});
            co_await pace;
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
