// SPDX-License-Identifier: MIT
#include "splines/mesh_samples.h"

#include <algorithm>
#include <cmath>

#include "surfaces/mesh_measures_normals.h"

namespace flg {

namespace {

// Of the distance of samples: nine of them reach a place where they lie evenly.
constexpr double radius_share = 1.6;
// Of the radius of curvature: as far apart samples may be if the mesh allows it.
constexpr double curvature_share = 0.6;
// Samples that can't be near enough to each other for that bend no more than this, over their distance.
constexpr double most_bent = 0.7;
// Of the mesh's size: as far apart beside sharp edges.
constexpr double crease_share = 1.0 / 24;
// Samples that are not at vertices are at most so many, or so many times the vertices.
constexpr double most_extras = 20000, most_extras_share = 3;
// How far from a sharp edge its rounding begins, of the samples' radius; edges that are a smaller share of that are
// those of thin parts, which would vanish.
constexpr double rounded_share = 0.5, least_edge = 0.4;
constexpr uint32_t most_parts = 4096;  // of an edge
// An edge that is longer than samples may be apart is divided if it is so many times as long.
constexpr double tolerated = 1.8;

// How many parts a length has where samples may be `fine` apart.
uint32_t parts_of(double length, double fine) {
    if (!(length > tolerated * fine)) return 1;
    return static_cast<uint32_t>(std::clamp(std::round(length / fine), 2.0, double{most_parts}));
}

constexpr uint32_t measured_triangles = 1024, units_a_measurement = 16;

}  // namespace

MeshSamplesKernel::MeshSamplesKernel(const Mesh& mesh, Memory* memory)
    : mesh_(mesh), memory_(memory), sectors_(mesh, memory) {}

void MeshSamplesKernel::enter(Pass pass) {
    pass_ = pass;
    at_ = 0;
    place_ = {};
    corners_done_ = 0;
    switch (pass) {
        case Pass::fit:
            fitted_ = Buffer<Fitted>(sectors_.sector_count(), memory_);
            size_ = (sectors_.upper() - sectors_.lower()).norm();
            break;
        case Pass::reach:
            if (spacing_.empty()) {
                spacing_ = Buffer<float>(mesh_.triangle_count(), memory_);
                longest_ = Buffer<float>(mesh_.triangle_count(), memory_);
            }
            break;
        case Pass::count: extra_count_ = 0; break;
        case Pass::vertices:
            samples_ = GrowingBuffer<OrientedSample>(size_t{sectors_.sector_count()} + extra_count_, memory_);
            samples_.resize(0);
            break;
        case Pass::sort: sort_.emplace(std::move(samples_), memory_); break;
        case Pass::measure: surface_.emplace(sort_->take()); break;
        case Pass::done:
            if (deviation_.places > 0) deviation_.mean = deviations_ / deviation_.places;
            break;
        default: break;
    }
}

bool MeshSamplesKernel::run(uint32_t count) {
    while (count > 0 && pass_ != Pass::done) {
        switch (pass_) {
            case Pass::sectors:
                if (!sectors_.run(count)) return false;
                enter(Pass::fit);
                continue;
            case Pass::fit:
                fit_corner();
                if (at_ == sectors_.sector_count()) enter(Pass::reach);
                break;
            case Pass::reach:
                spread_reach();
                if (++at_ == mesh_.triangle_count()) enter(Pass::count);
                break;
            case Pass::count: {
                const double most = std::max(most_extras, most_extras_share * mesh_.vertex_count());
                if (next_extra(nullptr)) {
                    if (++extra_count_ <= most) break;
                    coarseness_ *= 1.4;
                    enter(Pass::reach);
                } else if (at_ == mesh_.triangle_count()) {
                    enter(Pass::vertices);
                }
                break;
            }
            case Pass::vertices:
                emit_vertex();
                if (at_ == sectors_.sector_count()) enter(Pass::extras);
                break;
            case Pass::extras: {
                if (extra_count_ == 0) {
                    enter(Pass::sort);
                    break;
                }
                OrientedSample sample;
                if (next_extra(&sample)) {
                    samples_.push_back(sample);
                } else if (at_ == mesh_.triangle_count()) {
                    enter(Pass::sort);
                }
                break;
            }
            case Pass::sort:
                if (!sort_->run(count)) return false;
                enter(Pass::measure);
                continue;
            case Pass::measure:
                measure();
                count -= std::min(count, units_a_measurement) - 1;
                break;
            case Pass::done: break;
        }
        --count;
    }
    return pass_ == Pass::done;
}

// Normals and positions of the vertices around the sector at_, one corner a step.
void MeshSamplesKernel::fit_corner() {
    const MeshSector& sector = sectors_.sector(at_);
    const auto add = [&](Corner corner) {
        const MeshSector& other = sectors_.sector(sectors_.sector_of(corner));
        const Vec3 normal = load_vec3(other.normal.data()), place = mesh_.position(mesh_.vertex_at(corner));
        fit_->add_point(place);
        if (!normal.isZero()) fit_->add_normal(place, normal);
    };
    if (corners_done_ == 0) {
        corner_ = sector.first;
        const Vec3 normal = load_vec3(sector.normal.data());
        if (normal.isZero() || !(sector.mean > 0)) {
            fitted_[at_++] = {};
            return;
        }
        fit_.emplace(mesh_.position(mesh_.vertex_at(corner_)), normal, sector.mean, true);
    }
    add(next_corner(corner_));
    if (++corners_done_ == sector.corners) {
        if (!sector.closed) add(previous_corner(corner_));
        finish_fit();
    } else {
        corner_ = mesh_.turn(corner_);
    }
}

void MeshSamplesKernel::finish_fit() {
    const MeshSector& sector = sectors_.sector(at_);
    const BentNormal fit = fit_->solve();
    const Vec3 place = mesh_.position(mesh_.vertex_at(sector.first));
    Fitted& fitted = fitted_[at_];
    fitted.sample = {{place.x(), place.y(), place.z()}, {fit.normal.x(), fit.normal.y(), fit.normal.z()}, fit.bend, 0};
    double wanted = sector.longest, least = sector.shortest;
    if (fit.curvature > 0) wanted = std::min(wanted, curvature_share / fit.curvature);
    if (sector.creased) {
        wanted = std::min(wanted, crease_share * size_);
        least = std::min(least, crease_share * size_);
    }
    fitted.spacing = std::max(wanted, least);
    const double bent = fit.curvature * fitted.spacing;
    if (bent > most_bent) {
        for (double& b : fitted.sample.bend) b *= most_bent / bent;
    }
    corners_done_ = 0;
    ++at_;
}

// How far apart samples in the triangle may be; infinite if its corners tell nothing.
double MeshSamplesKernel::spacing(uint32_t triangle) const {
    double least = std::numeric_limits<double>::infinity();
    for (Corner corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        const Fitted& fitted = fitted_[sectors_.sector_of(corner)];
        if (fitted.spacing > 0) least = std::min(least, fitted.spacing * coarseness_);
    }
    return least;
}

// A vertex has to reach across its triangles, or to the samples within them.
void MeshSamplesKernel::spread_reach() {
    double longest = 0;
    for (Corner corner = 3 * at_; corner < 3 * at_ + 3; ++corner) {
        const Vec3 along =
            mesh_.position(mesh_.vertex_at(next_corner(corner))) - mesh_.position(mesh_.vertex_at(corner));
        longest = std::max(longest, along.norm());
    }
    const double fine = spacing(at_);
    spacing_[at_] = static_cast<float>(fine);
    longest_[at_] = static_cast<float>(longest);
    const double reach = radius_share * (parts_of(longest, fine) == 1 ? longest : fine);
    for (Corner corner = 3 * at_; corner < 3 * at_ + 3; ++corner) {
        Fitted& fitted = fitted_[sectors_.sector_of(corner)];
        if (fitted.spacing > 0) fitted.sample.radius = std::max(fitted.sample.radius, reach);
    }
}

// How many parts an edge has, and how long they may be: as the finer of its triangles wants it.
double MeshSamplesKernel::divide(Corner edge, uint32_t& parts) const {
    double fine = spacing_[triangle_of(edge)];
    const uint32_t across = mesh_.neighbour_at(edge);
    if (across != no_index) fine = std::min(fine, double{spacing_[across]});
    const double length =
        (mesh_.position(mesh_.vertex_at(next_corner(edge))) - mesh_.position(mesh_.vertex_at(edge))).norm();
    parts = parts_of(length, fine);
    return fine;
}

// Makes the next sample of the triangle at_ (only counts it if there is no place for it); false if that step made none.
bool MeshSamplesKernel::next_extra(OrientedSample* sample) {
    if (place_.stage == 0 && place_.row == 0) {
        float fine = spacing_[at_];
        for (const uint32_t across : mesh_.neighbours[at_]) {
            if (across != no_index) fine = std::min(fine, spacing_[across]);
        }
        if (!(longest_[at_] > 0.99 * tolerated * fine)) {  // most triangles
            ++at_;
            return false;
        }
    }
    const bool made = place_.stage < 3 ? along_edge(sample) : across_rows(sample);
    if (place_.stage == 4) {
        place_ = {};
        ++at_;
    }
    return made;
}

bool MeshSamplesKernel::along_edge(OrientedSample* sample) {
    const Corner edge = 3 * at_ + place_.stage, other = mesh_.opposite(edge);
    uint32_t parts = 1;
    const bool mine = other == no_index || edge < other;
    const double fine = mine ? divide(edge, parts) : 0;
    if (++place_.row >= parts) {
        place_ = {place_.stage + 1, 0, 0};
        return false;
    }
    double weights[3] = {};
    const double share = double(place_.row) / parts;
    weights[place_.stage] = 1 - share;
    weights[(place_.stage + 1) % 3] = share;
    if (sample && sectors_.sharp(edge) && on_crease(edge, share, radius_share * fine, *sample)) return true;
    return between(weights, radius_share * fine, sample);
}

// Rows are parallel to the shortest edge.
bool MeshSamplesKernel::across_rows(OrientedSample* sample) {
    double lengths[3], longest = 0;
    uint32_t shortest = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        const Corner corner = 3 * at_ + k;
        lengths[k] =
            (mesh_.position(mesh_.vertex_at(next_corner(corner))) - mesh_.position(mesh_.vertex_at(corner))).norm();
        longest = std::max(longest, lengths[k]);
        if (lengths[k] < lengths[shortest]) shortest = k;
    }
    const double fine = spacing_[at_];
    const uint32_t rows = parts_of(longest, fine);
    if (place_.row == 0) place_ = {3, 1, 0};
    if (place_.row >= rows) {
        place_.stage = 4;
        return false;
    }
    const double down = double(place_.row) / rows;  // from the corner that is opposite
    const uint32_t columns = rows == 1 ? 1 : static_cast<uint32_t>(std::ceil(lengths[shortest] * down / fine));
    if (++place_.column >= columns) {
        place_ = {3, place_.row + 1, 0};
        return false;
    }
    double weights[3] = {};
    const double share = double(place_.column) / columns;
    weights[(shortest + 2) % 3] = 1 - down;
    weights[shortest] = down * (1 - share);
    weights[(shortest + 1) % 3] = down * share;
    return between(weights, radius_share * fine, sample);
}

// A vertex of several sectors has one sample that rounds them all, or each sector has its own where that is not
// possible.
void MeshSamplesKernel::emit_vertex() {
    const MeshSector& sector = sectors_.sector(at_);
    const uint32_t vertex = mesh_.vertex_at(sector.first);
    if (!crease_) {
        crease_.emplace(mesh_.position(vertex));
        group_ = at_;
    }
    if (fitted_[at_].spacing > 0) crease_->add_normal(Vec3(fitted_[at_].sample.normal.data()));
    if (sectors_.sharp(sector.first)) crease_->add_edge(convex(sector.first));
    const uint32_t end = ++at_;
    if (end < sectors_.sector_count() && mesh_.vertex_at(sectors_.sector(end).first) == vertex) return;
    double shortest = std::numeric_limits<double>::infinity(), radius = 0;
    for (uint32_t i = group_; i < end; ++i) {
        if (!(fitted_[i].spacing > 0)) continue;
        shortest = std::min(shortest, double{sectors_.sector(i).shortest});
        radius = std::max(radius, fitted_[i].sample.radius);
    }
    OrientedSample sample;
    const double length = rounded_share * radius;
    if (end > group_ + 1 && radius > 0 && shortest > least_edge * length && crease_->round(length, radius, sample)) {
        samples_.push_back(sample);
    } else {
        for (uint32_t i = group_; i < end; ++i) {
            if (fitted_[i].sample.radius > 0) samples_.push_back(fitted_[i].sample);
        }
    }
    crease_.reset();
}

// Whether the triangles at a sharp edge fall away from each other.
bool MeshSamplesKernel::convex(Corner edge) const {
    const Vec3 far = mesh_.position(mesh_.vertex_at(previous_corner(mesh_.opposite(edge))));
    const Vec3 from = mesh_.position(mesh_.vertex_at(edge));
    return vector_area(mesh_, triangle_of(edge)).dot(far - from) < 0;
}

bool MeshSamplesKernel::on_crease(Corner edge, double share, double radius, OrientedSample& sample) const {
    const Corner other = mesh_.opposite(edge);
    const Corner corners[2][2] = {{edge, next_corner(edge)}, {next_corner(other), other}};
    const Vec3 from = mesh_.position(mesh_.vertex_at(edge)), to = mesh_.position(mesh_.vertex_at(other));
    CreaseRounding crease((1 - share) * from + share * to);
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& side : corners) {
        Vec3 normal = Vec3::Zero();
        for (const size_t k : {0u, 1u}) {
            const uint32_t sector = sectors_.sector_of(side[k]);
            if (!(fitted_[sector].spacing > 0)) return false;
            normal += (k == 0 ? 1 - share : share) * Vec3(fitted_[sector].sample.normal.data());
            shortest = std::min(shortest, double{sectors_.sector(sector).shortest});
        }
        crease.add_normal(normal.normalized());
    }
    crease.add_edge(convex(edge));
    const double length = rounded_share * radius;
    return shortest > least_edge * length && crease.round(length, radius, sample);
}

// A sample in the triangle at_: what its corners know, in between. False if they know no normal.
bool MeshSamplesKernel::between(const double* weights, double radius, OrientedSample* sample) const {
    Vec3 place = Vec3::Zero(), normal = Vec3::Zero();
    std::array<double, 6> bend{};
    for (uint32_t k = 0; k < 3; ++k) {
        const Corner corner = 3 * at_ + k;
        const Fitted& fitted = fitted_[sectors_.sector_of(corner)];
        place += weights[k] * mesh_.position(mesh_.vertex_at(corner));
        if (!(fitted.spacing > 0)) continue;
        normal += weights[k] * Vec3(fitted.sample.normal.data());
        for (size_t i = 0; i < 6; ++i) bend[i] += weights[k] * fitted.sample.bend[i];
    }
    const double length = normal.norm();
    if (!(length > 1e-3)) return false;
    normal /= length;
    if (sample) *sample = {{place.x(), place.y(), place.z()}, {normal.x(), normal.y(), normal.z()}, bend, radius};
    return true;
}

void MeshSamplesKernel::measure() {
    const uint32_t triangles = mesh_.triangle_count(),
                   stride = (triangles + measured_triangles - 1) / measured_triangles;
    const Triple& corners = mesh_.triangles[at_ * stride];
    const Vec3 a = mesh_.position(corners[0]), b = mesh_.position(corners[1]), c = mesh_.position(corners[2]);
    for (const Vec3& place : {a, Vec3((a + b + c) / 3)}) {
        double away = 0;
        if (!surface_->distance_estimate(place, &away)) {
            ++deviation_.uncovered;
            continue;
        }
        deviation_.largest = std::max(deviation_.largest, away);
        deviations_ += away;
        ++deviation_.places;
    }
    if (++at_ * uint64_t{stride} >= triangles) enter(Pass::done);
}

}  // namespace flg
