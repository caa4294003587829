// SPDX-License-Identifier: MIT
#include "surfaces/region_loops.h"

namespace flg {

RegionLoopsKernel::RegionLoopsKernel(const Mesh& mesh, const RegionSet& regions, RegionLoops& out, Memory* memory)
    : mesh_(mesh),
      regions_(regions),
      out_(out),
      visited_((3 * size_t{mesh.triangle_count()} + 63) / 64, memory),
      cursor_(mesh, regions) {}

bool RegionLoopsKernel::is_border(Corner edge) const {
    if (!regions_.contains(mesh_.regions[triangle_of(edge)])) return false;
    const uint32_t across = mesh_.neighbour_at(edge);
    return across == no_index || !regions_.contains(mesh_.regions[across]);
}

// The next edge of the triangle that begins a loop, or the next triangle.
void RegionLoopsKernel::find() {
    for (; at_ < end_; ++at_) {
        if ((visited_[at_ / 64] >> at_ % 64 & 1) != 0 || !is_border(at_)) continue;
        turning_ = at_;
        length_ = -1;
        pass_ = Pass::walk;
        return;
    }
    if (cursor_.at_end()) {
        pass_ = Pass::done;
        return;
    }
    const uint32_t triangle = cursor_.next();
    if (triangle == no_index) return;
    at_ = 3 * triangle;
    end_ = at_ + 3;
}

// Takes the edge, then turns about its end, through the regions' triangles, until it meets the next one.
void RegionLoopsKernel::walk() {
    if (!is_border(turning_)) {
        turning_ = next_corner(mesh_.opposite(turning_));
        return;
    }
    if (turning_ == at_ && length_ >= 0) {
        out_.offsets.push_back(static_cast<uint32_t>(out_.edges.size()));
        out_.lengths.push_back(length_);
        pass_ = Pass::find;
        return;
    }
    length_ = (length_ < 0 ? 0 : length_) + edge_length(mesh_, turning_);
    visited_[turning_ / 64] |= uint64_t{1} << turning_ % 64;
    out_.edges.push_back(turning_);
    turning_ = next_corner(turning_);
}

bool RegionLoopsKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::clear:
                if (cleared_ < visited_.size()) {
                    visited_[cleared_++] = 0;
                } else {
                    pass_ = Pass::find;
                }
                break;
            case Pass::find: find(); break;
            case Pass::walk: walk(); break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
