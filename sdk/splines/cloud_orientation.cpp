// SPDX-License-Identifier: MIT
#include "splines/cloud_orientation.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

double dot(const Position& a, const Position& b) {
    return double{a[0]} * b[0] + double{a[1]} * b[1] + double{a[2]} * b[2];
}

}  // namespace

CloudOrientationKernel::CloudOrientationKernel(const Buffer<Position>& places, const Buffer<uint32_t>& neighbours,
                                               uint32_t per_point, Buffer<Position>& normals, Memory* memory)
    : places_(places),
      neighbours_(neighbours),
      points_(static_cast<uint32_t>(places.size())),
      per_point_(per_point),
      normals_(normals),
      nodes_(points_, memory),
      ends_(size_t{points_} + 1, memory),
      back_(neighbours.size(), memory),
      order_(points_, memory) {
    heads_.fill(no_index);
}

// A counting sort of the neighbours by whose they are, and then the tree.
bool CloudOrientationKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        uint32_t end = points_ * per_point_;
        switch (pass_) {
            case Pass::clear:
                nodes_[at_] = {no_index, no_index, no_index, buckets};
                ends_[at_ + 1] = ends_[0] = 0;
                end = points_;
                break;
            case Pass::count:
                if (neighbours_[at_] != no_index) ++ends_[neighbours_[at_] + 1];
                break;
            case Pass::sum:
                ends_[at_ + 1] += ends_[at_];
                end = points_;
                break;
            case Pass::place:
                if (neighbours_[at_] != no_index) back_[ends_[neighbours_[at_]]++] = at_ / per_point_;
                break;
            case Pass::grow:
                step_grow();
                if (pass_ == Pass::grow) continue;
                break;
            case Pass::done: break;
        }
        if (pass_ == Pass::done || ++at_ < end) continue;
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    return pass_ == Pass::done;
}

void CloudOrientationKernel::step_grow() {
    if (turning_) {  // the part that is done
        if (turned_ < visited_) {
            for (float& n : normals_[order_[turned_]]) n = -n;
            ++turned_;
        } else {
            turning_ = false;
        }
    } else if (current_ != no_index) {
        const uint32_t back_begin = current_ == 0 ? 0 : ends_[current_ - 1], back_end = ends_[current_];
        if (edge_ < per_point_) {
            relax(neighbours_[size_t{current_} * per_point_ + edge_]);
        } else if (back_begin + (edge_ - per_point_) < back_end) {
            relax(back_[back_begin + (edge_ - per_point_)]);
        } else {
            current_ = no_index;
            return;
        }
        ++edge_;
    } else if (!take_next()) {
        if (visited_ > first_) {
            ++parts_;
            turning_ = normals_[top_][2] < 0;
            turned_ = first_;
            first_ = visited_;
        } else if (seed_ == points_) {
            pass_ = Pass::done;
        } else if (nodes_[seed_].bucket == no_index) {
            ++seed_;
        } else {
            visit(seed_);
        }
    }
}

// The neighbour whose normal turns least. False if there is none left.
bool CloudOrientationKernel::take_next() {
    while (lowest_ < buckets && heads_[lowest_] == no_index) ++lowest_;
    if (lowest_ == buckets) return false;
    const uint32_t point = heads_[lowest_];
    unlink(point);
    if (dot(normals_[point], normals_[nodes_[point].from]) < 0) {
        for (float& n : normals_[point]) n = -n;
    }
    visit(point);
    return true;
}

void CloudOrientationKernel::visit(uint32_t point) {
    if (visited_ == first_ || places_[point][2] > places_[top_][2]) top_ = point;
    nodes_[point].bucket = no_index;
    order_[visited_++] = point;
    current_ = point;
    edge_ = 0;
}

void CloudOrientationKernel::relax(uint32_t point) {
    if (point == no_index) return;
    Node& node = nodes_[point];
    if (node.bucket == no_index) return;
    const double cosine = std::min(1.0, std::abs(dot(normals_[point], normals_[current_])));
    const auto bucket = std::min(buckets - 1, static_cast<uint32_t>(buckets * std::sqrt(1 - cosine)));
    if (bucket >= node.bucket) return;
    if (node.bucket < buckets) unlink(point);
    node = {heads_[bucket], no_index, current_, bucket};
    if (node.next != no_index) nodes_[node.next].previous = point;
    heads_[bucket] = point;
    lowest_ = std::min(lowest_, bucket);
}

void CloudOrientationKernel::unlink(uint32_t point) {
    const Node& node = nodes_[point];
    if (node.previous == no_index) {
        heads_[node.bucket] = node.next;
    } else {
        nodes_[node.previous].next = node.next;
    }
    if (node.next != no_index) nodes_[node.next].previous = node.previous;
}

}  // namespace flg
