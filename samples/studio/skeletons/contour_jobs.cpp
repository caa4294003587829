// SPDX-License-Identifier: MIT
#include "skeletons/contour_jobs.h"

#include <algorithm>

#include "shell/studio_error.h"

namespace flg::studio {
namespace {

ContourPtr contour_of(const double* points, const uint32_t* offsets, size_t ring_count) {
    auto contour = std::make_shared<Contour>();
    for (size_t r = 0; r < ring_count; ++r) {
        Ring& ring = contour->rings.emplace_back();
        for (size_t i = offsets[r]; i < offsets[r + 1]; ++i) ring.emplace_back(points[2 * i], points[2 * i + 1]);
    }
    return contour;
}

}  // namespace

void ContourJobs::repair(const ContourPtr& contour, std::function<void(ContourPtr)> done) {
    std::vector<double> points;
    std::vector<uint32_t> offsets = {0};
    for (const Ring& ring : contour->rings) {
        for (const glm::dvec2& p : ring) points.insert(points.end(), {p.x, p.y});
        offsets.push_back(static_cast<uint32_t>(points.size() / 2));
    }
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.repair = 1;
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = points.data();
    drawn.point_count = offsets.back();
    drawn.ring_offsets = offsets.data();
    drawn.ring_count = static_cast<uint32_t>(offsets.size()) - 1;
    desc.contour = &drawn;
    filigree::Job job;
    repairs_.push_back({context_.straight_skeleton(desc, &job), std::move(done)});
    jobs_.add("Repairing the line", std::move(job));
}

void ContourJobs::trace(const filigree::Surface& surface,
                        std::function<void(ContourPtr, const std::array<double, 12>&)> done) {
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = surface.get();
    desc.direction[2] = 1.0f;
    FlgOutline outline{};
    FlgJob job{};
    filigree::check(flgOutlineCreate(context_.get(), &desc, &outline, &job));
    outlines_.push_back({OutlineOwner(context_.get(), outline), std::move(done)});
    jobs_.add("Tracing the mesh", filigree::Job(context_.get(), job));
}

void ContourJobs::update() {
    // What fails is said by the jobs' list.
    for (auto it = repairs_.begin(); it != repairs_.end();) {
        FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
        const FlgResult result = flgStraightSkeletonGetView(context_.get(), it->skeleton.get(), &view);
        if (result == FLG_NOT_READY) {
            ++it;
            continue;
        }
        std::list<Repair> ended;
        ended.splice(ended.begin(), repairs_, it++);
        if (result != FLG_OK) continue;
        const filigree::StraightSkeleton::Rings rings = ended.front().skeleton.offset(0.0);
        ended.front().done(contour_of(rings.points.data(), rings.offsets.data(), rings.offsets.size() - 1));
    }
    for (auto it = outlines_.begin(); it != outlines_.end();) {
        FlgOutlineView view = flgOutlineViewDefaults();
        const FlgResult result = flgOutlineGetView(context_.get(), it->outline.get(), &view);
        if (result == FLG_NOT_READY) {
            ++it;
            continue;
        }
        std::list<Outline> ended;
        ended.splice(ended.begin(), outlines_, it++);
        if (result != FLG_OK) continue;
        std::array<double, 12> placement;
        std::copy_n(view.placement, 12, placement.begin());
        const uint32_t whole[] = {0, view.contour->point_count};
        const uint32_t* offsets = view.contour->ring_offsets ? view.contour->ring_offsets : whole;
        ended.front().done(contour_of(view.contour->points, offsets, view.contour->ring_count), placement);
    }
}

}  // namespace flg::studio
