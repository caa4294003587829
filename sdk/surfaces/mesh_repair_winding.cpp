// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_winding.h"

namespace flg {

WindingKernel::WindingKernel(GrowingBuffer<Triple>& triangles, Mates& mates, Memory* memory)
    : triangles_(triangles),
      mates_(mates),
      states_(triangles.size(), memory),
      flood_(triangles.size(), memory),
      crossings_(memory) {}

void WindingKernel::begin_component() {
    states_[first_] = State::kept;
    flood_[0] = first_;
    flood_size_ = 1;
    turned_size_ = 0;
    at_ = 0;
}

bool WindingKernel::agrees(Corner corner) const {
    const Corner mate = mates_[corner];
    return triangles_[mate / 3][mate % 3] != triangles_[corner / 3][corner % 3];
}

void WindingKernel::spread(uint32_t triangle) {
    for (Corner corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        if (mates_[corner] == no_index) continue;
        const uint32_t other = triangle_of(mates_[corner]);
        if (!agrees(corner)) {
            crossings_.push_back(corner);
        } else if (states_[other] == State::unseen) {
            states_[other] = states_[triangle];
            flood_[flood_size_++] = other;
            turned_size_ += states_[other] == State::turned;
        }
    }
}

void WindingKernel::cross(Corner corner) {
    if (mates_[corner] == no_index) return;  // cut from the other side
    const uint32_t triangle = triangle_of(corner), other = triangle_of(mates_[corner]);
    if (states_[other] == State::unseen) {
        states_[other] = states_[triangle] == State::kept ? State::turned : State::kept;
        flood_[flood_size_++] = other;
        turned_size_ += states_[other] == State::turned;
    } else if (states_[other] == states_[triangle]) {
        mates_.cut(corner);
        ++cut_count_;
    }
}

// The corners 1 and 2 change places, and so the edges 0 and 2.
void WindingKernel::flip(uint32_t triangle) {
    std::swap(triangles_[triangle][1], triangles_[triangle][2]);
    const Corner first = 3 * triangle, last = first + 2;
    const Corner first_mate = mates_[first], last_mate = mates_[last];
    mates_.leave_open(first);
    mates_.leave_open(last);
    if (last_mate != no_index) mates_.join(first, last_mate);
    if (first_mate != no_index) mates_.join(last, first_mate);
    ++flipped_count_;
}

bool WindingKernel::run(uint32_t count) {
    const uint32_t triangles = static_cast<uint32_t>(triangles_.size());
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::clear:
                states_[at_++] = State::unseen;
                if (at_ < triangles) break;
                begin_component();
                pass_ = Pass::flood;
                break;
            case Pass::flood:
                if (at_ < flood_size_) {
                    spread(flood_[at_++]);
                } else if (!crossings_.empty()) {
                    cross(crossings_.front());
                    crossings_.pop_front();
                } else {
                    at_ = 0;
                    pass_ = Pass::flip;
                }
                break;
            case Pass::flip: {
                const State minority = 2 * turned_size_ > flood_size_ ? State::kept : State::turned;
                if (at_ < flood_size_) {
                    const uint32_t triangle = flood_[at_++];
                    if (states_[triangle] == minority) flip(triangle);
                    break;
                }
                if (++first_ == triangles) {
                    pass_ = Pass::done;
                } else if (states_[first_] == State::unseen) {
                    begin_component();
                    pass_ = Pass::flood;
                }
                break;
            }
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
