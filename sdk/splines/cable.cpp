// SPDX-License-Identifier: MIT
#include "splines/cable.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "core/failure.h"
#include "linear/block_tridiagonal.h"
#include "splines/catenary.h"
#include "splines/obstacles/obstacle_path.h"

namespace flg {

namespace {

constexpr double depth_tolerance = 1e-6;  // of the scene's size: how deep a cable may be beside its ends
constexpr double rest_share = 0.5;        // of that: so far above solids it is laid
constexpr double first_stiffness = 100, most_stiffness = 2e3, stiffer = 4;  // of the tension over a segment
constexpr double length_tolerance = 3e-9;                                   // of a segment
constexpr double contact_tolerance = 0.1;                                   // of the height that it is laid above
constexpr double first_force = 1e-2, force_tolerance = 1e-6;                // of the weight of a segment
constexpr double least_damping = 1e-12, first_damping = 1e-5;               // of the stiffness
constexpr uint32_t cable_rounds = 60, damping_rounds = 14, multiplier_rounds = 120;
constexpr uint32_t swept_steps = 12;                      // of a fall
constexpr uint32_t piece_looks = 48;                      // at a piece, at most
constexpr uint32_t rough_parts = 8, refined_parts = 32;   // of a piece, where distances are not convex
constexpr uint32_t rough_work = 16, refined_work = 40;    // of Cost::microseconds
constexpr double least_folded = 1e-7;                     // of the length: more than so much shorter it lies in folds
constexpr uint32_t most_planes = 6;                       // of a piece
constexpr double reach_share = 0.1;                       // of the length
constexpr double step_share = 0.25, move_share = 0.5;     // of the reach
constexpr uint32_t settle_rounds = 24, again_rounds = 2;  // in which planes are placed; after a breach
constexpr double move_tolerance = 1e-5;                   // of a segment

using ForceRates = Eigen::Matrix3d;

// What a piece keeps above: the plane of an obstacle, where that is nearest to it. Of a convex one it parts all of the
// piece from it, so both ends keep above; else a place of the piece does.
struct Plane {
    enum class Of : uint8_t { piece, node, middle };

    uint32_t obstacle = 0;
    Of of = Of::piece;
    uint8_t ends = 1;
    double at[2] = {0, 1};
    Vec3 outwards = Vec3::Zero();
    double height = 0;         // metres, along that
    double away = 0;           // metres: how far the piece was when it was placed
    double force[2] = {0, 0};  // over the weight of a metre: metres
};

struct Contacts {
    Plane planes[most_planes];
    uint32_t count = 0;
    double margin = 0;        // metres
    bool is_refined = false;  // more places are looked at
};

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

struct HangingChain {
    HangingChain(const ObstacleSet& solids, uint32_t count, double length_of_each, const Vec3& downwards,
                 Memory* memory)
        : set(solids),
          pieces(count),
          length(length_of_each),
          down(downwards),
          places(count + 1, memory),
          trial(count + 1, memory),
          gradient(count + 1, memory),
          diagonal(count + 1, memory),
          coupling(count + 1, memory),
          tension(count, memory),
          contacts(memory) {}

    Vec3 at(const Buffer<Vec3>& of, uint32_t piece, double t) const { return (1 - t) * of[piece] + t * of[piece + 1]; }

    const ObstacleSet& set;
    uint32_t pieces;
    double length;  // of a piece, metres
    Vec3 down;
    Buffer<Vec3> places, trial, gradient;
    Buffer<ForceRates> diagonal, coupling;
    Buffer<double> tension;              // over the weight of a metre: metres
    std::pmr::deque<Contacts> contacts;  // one a piece; blocks, which go back one by one
    double stiffness = 0;                // metres a metre
    double reach = 0;                    // metres: so near obstacles have planes
    double damping = 0;
    bool is_equal = false;  // pieces have their length; else at most that
};

// How hard an end of a plane pushes.
double push_of(const HangingChain& chain, const Buffer<Vec3>& places, uint32_t piece, const Plane& plane,
               uint32_t end) {
    const double above = plane.outwards.dot(chain.at(places, piece, plane.at[end])) - plane.height;
    return std::max(plane.force[end] - chain.stiffness * above, 0.0);
}

double add_contacts(HangingChain& chain, const Buffer<Vec3>& places, uint32_t a, bool with_derivatives) {
    double energy = 0;
    const Contacts& contacts = chain.contacts[a];
    for (uint32_t i = 0; i < contacts.count; ++i) {
        const Plane& plane = contacts.planes[i];
        for (uint32_t end = 0; end < plane.ends; ++end) {
            const double force = plane.force[end], push = push_of(chain, places, a, plane, end);
            energy += (push * push - force * force) / (2 * chain.stiffness);
            if (!with_derivatives || push == 0) continue;
            const ForceRates second = chain.stiffness * plane.outwards * plane.outwards.transpose();
            const double t = plane.at[end], s = 1 - t;
            chain.gradient[a] -= s * push * plane.outwards;
            chain.gradient[a + 1] -= t * push * plane.outwards;
            chain.diagonal[a] += s * s * second;
            chain.diagonal[a + 1] += t * t * second;
            chain.coupling[a] += s * t * second;
        }
    }
    return energy;
}

double add_piece(HangingChain& chain, const Buffer<Vec3>& places, uint32_t i, bool with_derivatives) {
    const Vec3 along = (places[i + 1] - places[i]) / chain.length;
    const double longer = 0.5 * chain.length * (along.squaredNorm() - 1), before = chain.tension[i];
    double tension = before + chain.stiffness * longer;
    const bool is_slack = !chain.is_equal && tension <= 0;
    if (is_slack) tension = 0;
    const double energy = (tension * tension - before * before) / (2 * chain.stiffness);
    if (!with_derivatives || is_slack) return energy;
    chain.gradient[i] -= tension * along;
    chain.gradient[i + 1] += tension * along;
    const ForceRates second =
        chain.stiffness * along * along.transpose() + std::max(tension, 0.0) / chain.length * ForceRates::Identity();
    chain.diagonal[i] += second;
    chain.diagonal[i + 1] += second;
    chain.coupling[i] -= second;
    return energy;
}

// What is minimized: the potential energy, and what lengths and contacts add.
Task<double> evaluate_chain(Pace& pace, HangingChain& chain, const Buffer<Vec3>& places, bool with_derivatives) {
    double energy = 0;
    co_await each(pace, size_t{chain.pieces} + 1, Cost::tens_of_ns, [&](uint32_t i) {
        energy -= chain.length * chain.down.dot(places[i] - places[0]);
        if (!with_derivatives) return;
        chain.gradient[i] = -chain.length * chain.down;
        chain.diagonal[i].setZero();
        chain.coupling[i].setZero();
    });
    co_await each(pace, chain.pieces, Cost::tens_of_ns,
                  [&](uint32_t i) { energy += add_piece(chain, places, i, with_derivatives); });
    co_await each(pace, chain.pieces, Cost::hundreds_of_ns,
                  [&](uint32_t i) { energy += add_contacts(chain, places, i, with_derivatives); });
    co_return energy;
}

// To `trial`: Newton's step with a damping, no longer than places may move.
Task<void> take_step(Pace& pace, HangingChain& chain, double damping) {
    const uint32_t blocks = chain.pieces - 1;
    BlockTridiagonal system(blocks, 3, false, pace.memory());
    co_await each(pace, blocks, Cost::hundreds_of_ns, [&](uint32_t i) {
        const ForceRates& own = chain.diagonal[i + 1];
        double* const diagonal = system.diagonal(i);
        double* const coupling = system.coupling(i);
        double* const right = system.right_side(i);
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) {
                diagonal[3 * r + c] = own(r, c) + (r == c ? damping : 0);
                coupling[3 * r + c] = chain.coupling[i + 1](r, c);
            }
            right[r] = -chain.gradient[i + 1][r];
        }
    });
    co_await each(pace, blocks, Cost::hundreds_of_ns, [&](uint32_t i) { system.eliminate(i); });
    co_await each(pace, blocks, Cost::hundreds_of_ns, [&](uint32_t i) { system.substitute(i); });
    double farthest = 0;
    co_await each(pace, blocks, Cost::some_ns,
                  [&](uint32_t i) { farthest = std::max(farthest, Vec3(system.solution(i)).norm()); });
    const double most = step_share * chain.reach, share = farthest > most ? most / farthest : 1;
    chain.trial[0] = chain.places[0];
    chain.trial[chain.pieces] = chain.places[chain.pieces];
    co_await each(pace, blocks, Cost::some_ns,
                  [&](uint32_t i) { chain.trial[i + 1] = chain.places[i + 1] + share * Vec3(system.solution(i)); });
}

// With the force of the one before it, if there was one. Where there are too many the farthest goes.
void add_plane(const HangingChain& chain, uint32_t piece, uint32_t obstacle, Plane::Of of, const Lowest& lowest,
               const Contacts& before, Contacts& contacts) {
    if (!(lowest.away < chain.reach)) return;
    Plane* const end = contacts.planes + contacts.count;
    Plane* out = end;
    if (contacts.count == most_planes) {
        out = std::max_element(contacts.planes, end, [](const Plane& p, const Plane& q) { return p.away < q.away; });
        if (out->away <= lowest.away) return;
    }
    Plane plane;
    plane.obstacle = obstacle;
    plane.of = of;
    plane.away = lowest.away;
    if (of == Plane::Of::piece) {
        plane.ends = 2;
    } else {
        plane.at[0] = lowest.at;
    }
    plane.outwards = lowest.outwards;
    plane.height = lowest.outwards.dot(chain.at(chain.places, piece, lowest.at)) - lowest.away + contacts.margin;
    for (uint32_t i = 0; i < before.count; ++i)
        if (before.planes[i].obstacle == obstacle && before.planes[i].of == of)
            std::copy_n(before.planes[i].force, 2, plane.force);
    if (out == end) ++contacts.count;
    *out = plane;
}

// Of an obstacle, beside a piece. Returns what that took.
uint32_t add_planes(HangingChain& chain, uint32_t piece, uint32_t i, const Contacts& before) {
    const ObstacleSet& set = chain.set;
    Contacts& contacts = chain.contacts[piece];
    const Vec3 &a = chain.places[piece], &b = chain.places[piece + 1];
    if (set.at_least(i, a.data()) > chain.reach + chain.length) return 0;
    if (set[i].is_convex()) {
        add_plane(chain, piece, i, Plane::Of::piece, lowest_of_piece(set, i, a, b, chain.reach, false), before,
                  contacts);
        return 1;
    }
    const PieceLook look = look_at_piece(set, i, a, b, 0);
    if (piece > 0) add_plane(chain, piece, i, Plane::Of::node, {look.away, 0, look.outwards}, before, contacts);
    if (look.away > chain.reach + chain.length) return 1;
    const Lowest lowest = lowest_of_piece(set, i, a, b, chain.length, contacts.is_refined);
    if (lowest.away < chain.length && lowest.at > 0 && lowest.at < 1)
        add_plane(chain, piece, i, Plane::Of::middle, lowest, before, contacts);
    return contacts.is_refined ? refined_work : rough_work;
}

// The planes of what is near, as the chain is now.
Task<void> place_planes(Pace& pace, HangingChain& chain) {
    Slice slice(Cost::microseconds);
    for (uint32_t piece = 0; piece < chain.pieces; ++piece) {
        const Contacts before = chain.contacts[piece];
        chain.contacts[piece].count = 0;
        for (uint32_t i = 0; i < chain.set.count(); ++i) {
            const uint32_t work = add_planes(chain, piece, i, before);
            if (work > 0 && slice.is_over(work)) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
}

// By Newton's method, until forces are in balance or places are so far away that planes are to be placed anew. Returns
// the largest force that is not in balance, and how far places moved.
struct Descent {
    double unbalanced, moved;  // metres both
};

Task<Descent> descend_chain(Pace& pace, HangingChain& chain, double wanted, uint32_t& rounds) {
    const double scale = chain.stiffness;
    Descent out{0, 0};
    for (uint32_t round = 0; round < cable_rounds; ++round) {
        const double energy = co_await evaluate_chain(pace, chain, chain.places, true);
        out.unbalanced = 0;
        co_await each(pace, 1, chain.pieces, Cost::some_ns,
                      [&](uint32_t i) { out.unbalanced = std::max(out.unbalanced, chain.gradient[i].norm()); });
        if (out.unbalanced <= wanted || out.moved > move_share * chain.reach) break;
        ++rounds;
        bool is_lower = false;
        for (uint32_t attempt = 0; attempt < damping_rounds && !is_lower; ++attempt) {
            co_await take_step(pace, chain, chain.damping * scale);
            const double next = co_await evaluate_chain(pace, chain, chain.trial, false);
            is_lower = next <= energy + 1e-13 * std::abs(energy);
            chain.damping = is_lower ? std::max(0.1 * chain.damping, least_damping) : 8 * chain.damping;
        }
        if (!is_lower) {
            chain.damping = first_damping;
            break;
        }
        double step = 0;
        co_await each(pace, 1, chain.pieces, Cost::some_ns,
                      [&](uint32_t i) { step = std::max(step, (chain.trial[i] - chain.places[i]).norm()); });
        out.moved += step;
        std::swap(chain.places, chain.trial);
    }
    co_return out;
}

// Tensions and pushes as the chain is now. Returns by how much lengths (of a piece) and distances (of `rest`) fail.
Task<double> take_multipliers(Pace& pace, HangingChain& chain, double rest) {
    double worst = 0;
    co_await each(pace, chain.pieces, Cost::tens_of_ns, [&](uint32_t i) {
        const Vec3 along = (chain.places[i + 1] - chain.places[i]) / chain.length;
        const double longer = 0.5 * chain.length * (along.squaredNorm() - 1);
        double tension = chain.tension[i] + chain.stiffness * longer;
        if (!chain.is_equal) tension = std::max(tension, 0.0);
        worst =
            std::max(worst, std::abs(tension - chain.tension[i]) / (chain.stiffness * chain.length) / length_tolerance);
        chain.tension[i] = tension;
    });
    co_await each(pace, chain.pieces, Cost::hundreds_of_ns, [&](uint32_t k) {
        Contacts& contacts = chain.contacts[k];
        for (uint32_t i = 0; i < contacts.count; ++i) {
            Plane& plane = contacts.planes[i];
            for (uint32_t end = 0; end < plane.ends; ++end) {
                // What can't move is not pushed.
                const bool is_fixed = (k == 0 && plane.at[end] == 0) || (k + 1 == chain.pieces && plane.at[end] == 1);
                const double force = plane.force[end],
                             push = is_fixed ? 0 : push_of(chain, chain.places, k, plane, end);
                plane.force[end] = push;
                worst = std::max(worst, std::abs(push - force) / chain.stiffness / (contact_tolerance * rest));
            }
        }
    });
    co_return worst;
}

// The least distance of a straight piece from an obstacle, if it may be below 0, and where that is.
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

struct Breach {
    uint32_t piece, obstacle;
    double at, depth;  // metres
};

// Where pieces are inside. Beside the ends they may be, by `slack`.
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

// What is inside keeps farther away.
Task<void> keep_farther(Pace& pace, HangingChain& chain, const std::pmr::vector<Breach>& breaches, double rest) {
    co_await each(pace, breaches.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        const Breach& breach = breaches[i];
        Contacts& contact = chain.contacts[breach.piece];
        if (contact.is_refined || chain.set[breach.obstacle].is_convex())
            contact.margin += std::min(1.5 * breach.depth, 10 * rest) + 0.1 * rest;
        contact.is_refined = true;
    });
}

Task<bool> is_free(Pace& pace, const ObstacleSet& set, const Buffer<Vec3>& places, double slack) {
    const std::pmr::vector<Breach> breaches = co_await find_breaches(pace, set, places, slack);
    const bool none = breaches.empty();
    co_return none;
}

// Whether a cable that falls freely from the straight way meets nothing: neither what falls with a node nor shorter
// catenaries do.
Task<bool> is_swept_free(Pace& pace, const ObstacleSet& set, const std::pmr::vector<Vec3>& places, double length,
                         Vec3 down, double slack) {
    const Vec3 &from = places.front(), &to = places.back();
    const auto pieces = static_cast<uint32_t>(places.size()) - 1;
    const double straight = (to - from).norm();
    Buffer<Vec3> between(places.size(), pace.memory());
    for (uint32_t k = 1; k < swept_steps; ++k) {
        // Sags grow by equal steps.
        const double share = static_cast<double>(k) / swept_steps, own = straight + (length - straight) * share * share;
        const Catenary catenary(from, to, own, down);
        co_await each(pace, places.size(), Cost::hundreds_of_ns,
                      [&](uint32_t i) { between[i] = catenary.place(own * i / pieces); });
        const bool free = co_await is_free(pace, set, between, slack);
        if (!free) co_return false;
    }
    Slice slice(Cost::microseconds);
    for (uint32_t i = 1; i < pieces; ++i) {
        const Vec3 above = from + (to - from) * (static_cast<double>(i) / pieces);
        for (uint32_t k = 0; k < set.count(); ++k) {
            double at = 0;
            const double least = least_distance(set, k, above, places[i], &at);
            if (least < -slack) co_return false;
            if (slice.is_over(least < HUGE_VAL ? 4 : 1)) co_await pace;
        }
    }
    co_return true;
}

// Along a polyline, evenly.
Task<void> lay_along(Pace& pace, const std::pmr::vector<Vec3>& line, HangingChain& chain) {
    double length = 0;
    for (size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
    size_t piece = 0;
    double before = 0;
    co_await each(pace, size_t{chain.pieces} + 1, Cost::tens_of_ns, [&](uint32_t i) {
        const double target = length * i / chain.pieces;
        double own = (line[piece + 1] - line[piece]).norm();
        while (piece + 2 < line.size() && before + own < target) {
            before += own;
            ++piece;
            own = (line[piece + 1] - line[piece]).norm();
        }
        const double t = own > 0 ? std::clamp((target - before) / own, 0.0, 1.0) : 0;
        chain.places[i] = line[piece] + t * (line[piece + 1] - line[piece]);
    });
    chain.places[0] = line.front();
    chain.places[chain.pieces] = line.back();
}

Task<std::optional<ObstaclePath>> path_over(Pace& pace, const ObstacleSet& set, std::span<const double> ends,
                                            std::span<const ObstacleSide> sides) {
    std::optional<ObstaclePath> path;
    try {
        path.emplace(co_await obstacle_path(pace, set, ends, false, sides));
    } catch (const Failure& failure) {
        if (failure.result() != FLG_ERROR_INVALID_ARGUMENT) throw;
    }
    co_return path;
}

double line_length(const std::pmr::vector<Vec3>& line) {
    double length = 0;
    for (size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
    return length;
}

// Where the straight way is blocked: above what blocks it or, if the cable is too short for that, the shortest way.
// None if it is too short for that too, but `hangs_free`.
Task<std::pmr::vector<Vec3>> way_over(Pace& pace, const HangingChain& chain, const std::pmr::vector<Breach>& breaches,
                                      double length, bool hangs_free, uint32_t number) {
    double ends[6];
    std::copy_n(chain.places[0].data(), 3, ends);
    std::copy_n(chain.places[chain.pieces].data(), 3, ends + 3);
    std::pmr::vector<ObstacleSide> sides(pace.memory());
    for (const Breach& breach : breaches) {
        const bool is_new = std::none_of(sides.begin(), sides.end(),
                                         [&](const ObstacleSide& side) { return side.obstacle == breach.obstacle; });
        if (is_new && chain.set[breach.obstacle].bounded())
            sides.push_back({breach.obstacle, {-chain.down[0], -chain.down[1], -chain.down[2]}});
    }
    std::pmr::vector<Vec3> line(pace.memory());
    double shortest = HUGE_VAL;
    for (uint32_t attempt = sides.empty() ? 1 : 0; attempt < 2; ++attempt) {
        const std::span<const ObstacleSide> own(sides.data(), attempt == 0 ? sides.size() : 0);
        const std::optional<ObstaclePath> path = co_await path_over(pace, chain.set, ends, own);
        if (!path) continue;
        line.clear();
        for (size_t i = 0; i + 2 < path->points.size(); i += 3) line.push_back(Vec3(&path->points[i]));
        shortest = std::min(shortest, line_length(line));
        if (line_length(line) <= length) co_return line;
    }
    if (hangs_free) {
        line.clear();
        co_return line;
    }
    if (shortest == HUGE_VAL)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no way leads from point %u to point %u around the obstacles", number,
                      number + 1);
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "the cable from point %u to point %u is %g m long, too short for the shortest way that was found "
                  "around the obstacles, %g m",
                  number, number + 1, length, shortest);
}

// What lies loose gets its length in folds to both sides.
Task<void> fold_loose(Pace& pace, HangingChain& chain, double tension) {
    const Vec3 chord = chain.places[chain.pieces] - chain.places[0];
    Vec3 aside = chain.down.cross(chord);
    if (!(aside.norm() > 1e-9 * chord.norm())) aside = chain.down.unitOrthogonal();
    aside.normalize();
    co_await each(pace, 1, chain.pieces, Cost::tens_of_ns, [&](uint32_t i) {
        if (chain.tension[i] > least_folded * tension || chain.tension[i - 1] > least_folded * tension) return;
        chain.places[i] += 0.1 * chain.length * std::sin(0.25 * M_PI * (i + 0.5)) * aside;
    });
    chain.is_equal = true;
}

double chain_length(const Buffer<Vec3>& places) {
    double length = 0;
    for (size_t i = 0; i + 1 < places.size(); ++i) length += (places[i + 1] - places[i]).norm();
    return length;
}

}  // namespace

Task<HungCable> hang_cable(Pace& pace, const ObstacleSet* obstacles, Vec3 from, Vec3 to, double length,
                           uint32_t segments, Vec3 down, double size, uint32_t number) {
    HungCable out(pace.memory());
    const Catenary catenary(from, to, length, down);
    out.places.resize(size_t{segments} + 1);
    co_await each(pace, size_t{segments} + 1, Cost::hundreds_of_ns,
                  [&](uint32_t i) { out.places[i] = catenary.place(length * i / segments); });
    out.places.front() = from;
    out.places.back() = to;
    if (!obstacles) co_return out;
    const double slack = depth_tolerance * size, rest = rest_share * slack;
    HangingChain chain(*obstacles, segments, length / segments, down, pace.memory());
    co_await each(pace, size_t{segments} + 1, Cost::some_ns, [&](uint32_t i) { chain.places[i] = out.places[i]; });
    const bool hangs_free = co_await is_free(pace, *obstacles, chain.places, slack);
    std::pmr::vector<Vec3> line({from, to}, pace.memory());
    co_await lay_along(pace, line, chain);
    std::pmr::vector<Breach> breaches = co_await find_breaches(pace, *obstacles, chain.places, slack);
    if (!breaches.empty()) {
        line = co_await way_over(pace, chain, breaches, length, hangs_free, number);
        if (line.empty()) co_return out;
        co_await lay_along(pace, line, chain);
    } else if (hangs_free) {
        const bool falls_free = co_await is_swept_free(pace, *obstacles, out.places, length, down, slack);
        if (falls_free) co_return out;
    }
    const double tension = std::max(catenary.tension(), length);
    chain.stiffness = first_stiffness * tension / chain.length;
    chain.reach = std::max(reach_share * length, chain.length);
    chain.damping = first_damping;
    co_await each(pace, segments, Cost::some_ns, [&](uint32_t i) { chain.tension[i] = 0; });
    co_await each(pace, segments, Cost::hundreds_of_ns, [&](uint32_t i) {
        const bool is_end = i == 0 || i + 1 == segments;
        chain.contacts.emplace_back().margin = is_end ? 0 : rest;
    });
    double before = HUGE_VAL, wanted = first_force * chain.length;
    // Planes that are placed anew turn with the chain, so it goes on to move; in the end they stay.
    for (uint32_t round = 0, placed = 0; round < multiplier_rounds; ++round) {
        if (placed < settle_rounds) {
            co_await place_planes(pace, chain);
            ++placed;
        }
        const auto [unbalanced, moved] = co_await descend_chain(pace, chain, wanted, out.rounds);
        if (moved > move_share * chain.reach) {
            placed -= placed > 0 ? 1 : 0;
            continue;
        }
        const double worst = co_await take_multipliers(pace, chain, rest);
        if (unbalanced <= wanted && worst > 0.25 * before && chain.stiffness < most_stiffness * tension / chain.length)
            chain.stiffness *= stiffer;
        before = worst;
        wanted = std::max(0.1 * wanted, force_tolerance * chain.length);
        if (worst > 1 || unbalanced > force_tolerance * chain.length) continue;
        if (moved > move_tolerance * chain.length && placed < settle_rounds) continue;
        if (!chain.is_equal && chain_length(chain.places) < length * (1 - least_folded)) {
            co_await fold_loose(pace, chain, tension);
            before = HUGE_VAL;
            continue;
        }
        breaches = co_await find_breaches(pace, *obstacles, chain.places, slack);
        if (breaches.empty()) {
            co_await each(pace, size_t{segments} + 1, Cost::some_ns,
                          [&](uint32_t i) { out.places[i] = chain.places[i]; });
            Slice slice(Cost::hundreds_of_ns);
            for (; !chain.contacts.empty(); chain.contacts.pop_back())
                if (slice.is_over()) co_await pace;
            co_return out;
        }
        co_await keep_farther(pace, chain, breaches, rest);
        placed = std::min(placed, settle_rounds - again_rounds);
        before = HUGE_VAL;
    }
    breaches = co_await find_breaches(pace, *obstacles, chain.places, slack);
    if (breaches.empty())
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "the cable from point %u to point %u does not come to rest on the obstacles", number, number + 1);
    const Breach worst = *std::max_element(breaches.begin(), breaches.end(),
                                           [](const Breach& a, const Breach& b) { return a.depth < b.depth; });
    const Vec3 at = chain.at(chain.places, worst.piece, worst.at);
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "the cable from point %u to point %u can't keep out of obstacle %u near (%g, %g, %g): it is %g deep",
                  number, number + 1, worst.obstacle, at.x(), at.y(), at.z(), worst.depth);
}

Task<void> hang_cables(Pace& pace, CableRequest request) {
    pace.stage("hang");
    std::optional<PlacedObstacles> placed;
    const ObstacleSet* set = nullptr;
    double size = 0;
    const auto points = static_cast<uint32_t>(request.points.size() / 3);
    const auto point = [&](uint32_t i) { return Vec3(&request.points[size_t{3} * i]); };
    if (request.obstacles) {
        set = &placed.emplace(request.obstacles, request.out->origin, 0, pace.memory()).set();
        co_await refuse_inside(pace, *set, {request.points.data(), request.points.size()}, 0);
        Obstacle::Box box;
        const bool has_box = set->box(box);
        Vec3 low = has_box ? Vec3(box.lower.data()) : point(0), high = has_box ? Vec3(box.upper.data()) : point(0);
        co_await each(pace, points, Cost::some_ns, [&](uint32_t i) {
            low = low.cwiseMin(point(i));
            high = high.cwiseMax(point(i));
        });
        size = (high - low).norm();
    }
    const auto cables = static_cast<uint32_t>(request.offsets.size()) - 1;
    CurveSet& out = *request.out;
    out.allocate_curves(cables);
    out.offsets()[0] = 0;
    for (uint32_t k = 0; k < cables; ++k) {
        const uint32_t spans = request.offsets[k + 1] - request.offsets[k] - 1;
        out.offsets()[k + 1] = out.offsets()[k] + spans * request.segments + 1;
        out.begin_curve(k, 0);
    }
    out.allocate_columns(std::pmr::vector<CurveSet::ColumnLayout>(
        {{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TIME, 1}}, pace.memory()));
    float* const positions = out.find(FLG_ATTRIBUTE_POSITION)->values.data();
    float* const times = out.find(FLG_ATTRIBUTE_TIME)->values.data();
    uint32_t span = 0;
    for (uint32_t k = 0; k < cables; ++k) {
        double before = 0;
        uint32_t row = out.offsets()[k];
        for (uint32_t p = request.offsets[k]; p + 1 < request.offsets[k + 1]; ++p, ++span) {
            const double length = request.lengths[span];
            const HungCable hung =
                co_await hang_cable(pace, set, point(p), point(p + 1), length, request.segments, request.down, size, p);
            co_await each(pace, size_t{request.segments} + 1, Cost::some_ns, [&](uint32_t i) {
                store_vec3(hung.places[i], positions + size_t{3} * (row + i));
                times[row + i] = static_cast<float>(before + length * i / request.segments);
            });
            row += request.segments;
            before += length;
            co_await pace;
        }
        out.complete_curve(k);
    }
}

}  // namespace flg
