// SPDX-License-Identifier: MIT
#include "splines/hanging_chain.h"

#include <algorithm>
#include <cmath>

#include "linear/block_tridiagonal.h"
#include "runtime/each.h"

namespace flg {

namespace {

using Joint = Eigen::Vector4d;  // a place, and what slid past it
using ForceRates = Eigen::Matrix4d;

constexpr double first_stiffness = 100, most_stiffness = 2e3, stiffer = 4;  // of the tension over a segment
constexpr double length_tolerance = 3e-9;                                   // of a segment
constexpr double contact_tolerance = 0.1;                                   // of the height that it is laid above
constexpr double first_force = 1e-2, force_tolerance = 1e-6;                // of the weight of a segment
constexpr double least_damping = 1e-12, first_damping = 1e-5;               // of the stiffness
constexpr uint32_t cable_rounds = 60, damping_rounds = 14, multiplier_rounds = 120;
constexpr double least_folded = 1e-7;                     // of the length: more than so much shorter it lies in folds
constexpr double step_share = 0.25, move_share = 0.5;     // of the reach
constexpr uint32_t settle_rounds = 24, again_rounds = 2;  // in which planes are placed; after a breach
constexpr uint32_t still_rounds = 6;                      // the last of these, in which pieces do not turn
constexpr double turn_share = 0.5;                        // of an end's way to the solid, in a round
constexpr double move_tolerance = 1e-5;                   // of a segment
constexpr double bent = 0.3;                              // radians, at both joints of a piece that lies on an edge
constexpr double first_barrier = 1, last_barrier = 1e-2, barrier_fall = 0.3;  // of the tension

// How hard an end of a plane pushes.
double push_of(const HangingChain& chain, const Buffer<Vec3>& places, uint32_t piece, const ContactPlane& plane,
               uint32_t end) {
    const double t = plane.at[end];
    const double above =
        plane.outwards.dot((1 - t) * places[piece] + t * places[piece + 1]) - plane.height + plane.drop[end];
    return std::max(plane.force[end] - chain.stiffness * above, 0.0);
}

double add_contacts(HangingChain& chain, const Buffer<Vec3>& places, uint32_t a, bool with_derivatives) {
    double energy = 0;
    const PieceContacts& contacts = chain.contacts.pieces[a];
    for (uint32_t i = 0; i < contacts.count; ++i) {
        const ContactPlane& plane = contacts.planes[i];
        for (uint32_t end = 0; end < plane.count; ++end) {
            const double force = plane.force[end], push = push_of(chain, places, a, plane, end);
            energy += (push * push - force * force) / (2 * chain.stiffness);
            if (!with_derivatives || push == 0) continue;
            Joint outwards;
            outwards << plane.outwards, 0;
            const ForceRates second = chain.stiffness * outwards * outwards.transpose();
            const double t = plane.at[end], s = 1 - t;
            chain.gradient[a] -= s * push * outwards;
            chain.gradient[a + 1] -= t * push * outwards;
            chain.diagonal[a] += s * s * second;
            chain.diagonal[a + 1] += t * t * second;
            chain.coupling[a] += s * t * second;
        }
    }
    return energy;
}

// Half the square of its length less that which it is to have, over `length`: what a tension is the multiplier of.
double excess_of(const HangingChain& chain, const Buffer<Vec3>& places, const Buffer<double>& slid, uint32_t i) {
    const double share = chain.share(slid, i);
    return 0.5 * chain.length *
           ((places[i + 1] - places[i]).squaredNorm() / (chain.length * chain.length) - share * share);
}

double add_piece(HangingChain& chain, const Buffer<Vec3>& places, const Buffer<double>& slid, uint32_t i,
                 bool with_derivatives) {
    const double share = chain.share(slid, i), own = share * chain.length, before = chain.tension[i];
    if (!(share > 0)) return HUGE_VAL;
    double tension = before + chain.stiffness * excess_of(chain, places, slid, i);
    const bool is_slack = !chain.is_equal && tension <= 0;
    if (is_slack) tension = 0;
    const double high = chain.down.dot(places[0] - 0.5 * (places[i] + places[i + 1]));
    double energy = (tension * tension - before * before) / (2 * chain.stiffness) + own * high;
    if (chain.slides) energy += chain.barrier * chain.length * (share - 1 - std::log(share));
    if (!with_derivatives) return energy;
    Joint along, weight, flow = Joint::Zero();
    along << (places[i + 1] - places[i]) / chain.length, -share;
    weight << -0.5 * own * chain.down, 0;
    flow[3] = high + chain.barrier * (1 - 1 / share);
    chain.gradient[i] += weight - flow - tension * along;
    chain.gradient[i + 1] += weight + flow + tension * along;
    const double turn = std::max(tension, 0.0) / chain.length;
    ForceRates second = Joint(turn, turn, turn, chain.barrier / (chain.length * share * share) - turn).asDiagonal();
    if (!is_slack) second += chain.stiffness * along * along.transpose();
    ForceRates falls = ForceRates::Zero();
    falls.col(3).head<3>() = 0.5 * chain.down;
    chain.diagonal[i] += second + falls + falls.transpose();
    chain.diagonal[i + 1] += second - falls - falls.transpose();
    chain.coupling[i] += falls.transpose() - falls - second;
    return energy;
}

// What is minimized: the potential energy, and what lengths and contacts add.
Task<double> evaluate_chain(Pace& pace, HangingChain& chain, const Buffer<Vec3>& places, const Buffer<double>& slid,
                            bool with_derivatives) {
    double energy = 0;
    if (with_derivatives) {
        co_await each(pace, size_t{chain.pieces} + 1, Cost::tens_of_ns, [&](uint32_t i) {
            chain.gradient[i].setZero();
            chain.diagonal[i].setZero();
            chain.coupling[i].setZero();
        });
    }
    co_await each(pace, chain.pieces, Cost::hundreds_of_ns,
                  [&](uint32_t i) { energy += add_piece(chain, places, slid, i, with_derivatives); });
    co_await each(pace, chain.pieces, Cost::hundreds_of_ns,
                  [&](uint32_t i) { energy += add_contacts(chain, places, i, with_derivatives); });
    co_return energy;
}

// To `trial`: Newton's step with a damping, no longer than places may move. Returns how many directions the energy
// curves down in, as far as the damping lets it.
Task<uint32_t> take_step(Pace& pace, HangingChain& chain, double damping) {
    const uint32_t blocks = chain.pieces - 1, size = chain.slides ? 4 : 3;
    BlockTridiagonal system(blocks, size, false, pace.memory());
    co_await each(pace, blocks, Cost::hundreds_of_ns, [&](uint32_t i) {
        const ForceRates& own = chain.diagonal[i + 1];
        double* const diagonal = system.diagonal(i);
        double* const coupling = system.coupling(i);
        double* const right = system.right_side(i);
        for (uint32_t r = 0; r < size; ++r) {
            for (uint32_t c = 0; c < size; ++c) {
                diagonal[size * r + c] = own(r, c) + (r == c ? damping : 0);
                coupling[size * r + c] = chain.coupling[i + 1](r, c);
            }
            right[r] = -chain.gradient[i + 1][r];
        }
    });
    co_await each(pace, blocks, Cost::hundreds_of_ns, [&](uint32_t i) { system.eliminate(i); });
    co_await each(pace, blocks, Cost::hundreds_of_ns, [&](uint32_t i) { system.substitute(i); });
    const auto slide_of = [&](uint32_t i) { return size == 4 ? system.solution(i)[3] : 0; };
    double farthest = 0;
    co_await each(pace, blocks, Cost::some_ns, [&](uint32_t i) {
        farthest = std::max({farthest, Vec3(system.solution(i)).norm(), std::abs(slide_of(i))});
    });
    const double most = step_share * chain.contacts.reach, share = farthest > most ? most / farthest : 1;
    for (const uint32_t end : {0u, chain.pieces}) {
        chain.trial[end] = chain.places[end];
        chain.slid_trial[end] = 0;
    }
    co_await each(pace, blocks, Cost::some_ns, [&](uint32_t i) {
        chain.trial[i + 1] = chain.places[i + 1] + share * Vec3(system.solution(i));
        chain.slid_trial[i + 1] = chain.slid[i + 1] + share * slide_of(i);
    });
    co_return system.negative_pivots();
}

double force_on(const HangingChain& chain, uint32_t i) {
    return chain.slides ? chain.gradient[i].norm() : chain.gradient[i].head<3>().norm();
}

// By Newton's method, until forces are in balance or places are so far away that planes are to be placed anew. Returns
// the largest force that is not in balance, and how far places moved.
struct Descent {
    double unbalanced, moved;  // metres both
};

Task<Descent> descend_chain(Pace& pace, HangingChain& chain, double wanted) {
    Descent out{0, 0};
    for (uint32_t round = 0; round < cable_rounds; ++round) {
        const double energy = co_await evaluate_chain(pace, chain, chain.places, chain.slid, true);
        out.unbalanced = 0;
        co_await each(pace, 1, chain.pieces, Cost::some_ns,
                      [&](uint32_t i) { out.unbalanced = std::max(out.unbalanced, force_on(chain, i)); });
        if (out.unbalanced <= wanted || out.moved > move_share * chain.contacts.reach) break;
        ++chain.rounds;
        bool is_lower = false;
        for (uint32_t attempt = 0; attempt < damping_rounds && !is_lower; ++attempt) {
            co_await take_step(pace, chain, chain.damping * chain.stiffness);
            const double next = co_await evaluate_chain(pace, chain, chain.trial, chain.slid_trial, false);
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
        std::swap(chain.slid, chain.slid_trial);
    }
    co_return out;
}

// Tensions and pushes as the chain is now. Returns by how much lengths (of a piece) and distances (of `rest`) fail.
Task<double> take_multipliers(Pace& pace, HangingChain& chain, double rest) {
    double worst = 0;
    co_await each(pace, chain.pieces, Cost::tens_of_ns, [&](uint32_t i) {
        double tension = chain.tension[i] + chain.stiffness * excess_of(chain, chain.places, chain.slid, i);
        if (!chain.is_equal) tension = std::max(tension, 0.0);
        worst =
            std::max(worst, std::abs(tension - chain.tension[i]) / (chain.stiffness * chain.length) / length_tolerance);
        chain.tension[i] = tension;
    });
    co_await each(pace, chain.pieces, Cost::hundreds_of_ns, [&](uint32_t k) {
        PieceContacts& contacts = chain.contacts.pieces[k];
        for (uint32_t i = 0; i < contacts.count; ++i) {
            ContactPlane& plane = contacts.planes[i];
            for (uint32_t end = 0; end < plane.count; ++end) {
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

// What it is short of its length, over that.
double shortness(const HangingChain& chain) {
    double length = 0;
    for (uint32_t i = 0; i < chain.pieces; ++i) length += (chain.places[i + 1] - chain.places[i]).norm();
    return 1 - length / (chain.length * chain.pieces);
}

}  // namespace

HangingChain::HangingChain(const ObstacleSet& solids, uint32_t count, double length_of_each, const Vec3& downwards,
                           Memory* memory)
    : pieces(count),
      length(length_of_each),
      down(downwards),
      places(count + 1, memory),
      trial(count + 1, memory),
      slid(count + 1, memory),
      slid_trial(count + 1, memory),
      gradient(count + 1, memory),
      diagonal(count + 1, memory),
      coupling(count + 1, memory),
      tension(count, memory),
      contacts(solids, memory) {
    contacts.length = length_of_each;
}

double HangingChain::greatest_tension() const {
    double most = 0;
    for (uint32_t i = 0; i < pieces; ++i) most = std::max(most, tension[i] * share(slid, i));
    return most;
}

double HangingChain::energy() const {
    double sum = 0;
    for (uint32_t i = 0; i < pieces; ++i)
        sum += share(slid, i) * length * down.dot(places[0] - 0.5 * (places[i] + places[i + 1]));
    return sum;
}

double HangingChain::unevenness() const {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (uint32_t i = 0; i < pieces; ++i) {
        const double own = tension[i] * share(slid, i) + down.dot(0.5 * (places[i] + places[i + 1]) - places[0]);
        least = std::min(least, own);
        most = std::max(most, own);
    }
    return most - least;
}

Task<bool> settle_chain(Pace& pace, HangingChain& chain, ChainScale scale) {
    if (!chain.slides) chain.stiffness = first_stiffness * scale.tension / chain.length;
    chain.damping = first_damping;
    chain.barrier = chain.slides ? first_barrier * scale.tension : 0;
    double before = HUGE_VAL, wanted = first_force * chain.length;
    // Planes that are placed anew turn with the chain, so it goes on to move; in the end they stay.
    for (uint32_t round = 0, placed = 0; round < multiplier_rounds; ++round) {
        if (placed < settle_rounds) {
            const bool turns = chain.slides && placed + still_rounds < settle_rounds;
            chain.contacts.turn_share = turns ? turn_share : 0;
            co_await place_planes(pace, chain.contacts, chain.places);
            ++placed;
        }
        const auto [unbalanced, moved] = co_await descend_chain(pace, chain, wanted);
        if (moved > move_share * chain.contacts.reach) {
            placed -= placed > 0 ? 1 : 0;
            continue;
        }
        const double worst = co_await take_multipliers(pace, chain, scale.rest);
        const double most = most_stiffness * scale.tension / chain.length;
        if (unbalanced <= wanted && worst > 0.25 * before && chain.stiffness < most) chain.stiffness *= stiffer;
        before = worst;
        wanted = std::max(0.1 * wanted, force_tolerance * chain.length);
        if (chain.slides && chain.barrier > last_barrier * scale.tension) {
            chain.barrier = std::max(barrier_fall * chain.barrier, last_barrier * scale.tension);
            continue;
        }
        if (worst > 1 || unbalanced > force_tolerance * chain.length) continue;
        if (moved > move_tolerance * chain.length && placed < settle_rounds) continue;
        if (!chain.is_equal && shortness(chain) > least_folded) {
            co_await fold_loose(pace, chain, scale.tension);
            before = HUGE_VAL;
            continue;
        }
        const std::pmr::vector<Breach> breaches =
            co_await find_breaches(pace, chain.contacts.set, chain.places, scale.slack);
        if (breaches.empty()) co_return true;
        co_await keep_farther(pace, chain.contacts, breaches, scale.rest);
        placed = std::min(placed, settle_rounds - again_rounds);
        before = HUGE_VAL;
    }
    co_return false;
}

Task<bool> push_from_saddle(Pace& pace, HangingChain& chain) {
    bool is_on_edge = false;
    const double least = bent * chain.greatest_tension();
    co_await each(pace, chain.pieces, Cost::some_ns, [&](uint32_t k) {
        const PieceContacts& contacts = chain.contacts.pieces[k];
        for (uint32_t i = 0; i < contacts.count; ++i)
            is_on_edge |= contacts.planes[i].force[0] > least && contacts.planes[i].force[1] > least;
    });
    if (!is_on_edge) {
        co_await evaluate_chain(pace, chain, chain.places, chain.slid, true);
        const uint32_t downs = co_await take_step(pace, chain, 0);
        if (downs == 0) co_return false;
    }
    co_await each(pace, 1, chain.pieces, Cost::tens_of_ns,
                  [&](uint32_t i) { chain.slid[i] += 0.5 * chain.length * std::sin(M_PI * i / chain.pieces); });
    co_return true;
}

}  // namespace flg
