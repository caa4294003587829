// SPDX-License-Identifier: MIT
#include "splines/manifolds/mesh_samples.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "splines/manifolds/quadric_fit.h"
#include "splines/manifolds/smoothed_samples.h"
#include "surfaces/mesh/mesh_measures.h"

namespace flg {

namespace {

// Edges across which normals turn by more than 40 degrees are sharp.
constexpr double sharp_cosine = 0.766;
// Of the distance of samples: nine of them reach a place where they lie evenly.
constexpr double radius_share = 1.6;
// Of the radius of curvature: as far apart samples may be if the mesh allows it.
constexpr double curvature_share = 0.6;
// Samples that can't be near enough to each other for that bend no more than this, over their distance.
constexpr double max_bent = 0.7;
// Of the mesh's size: as far apart beside sharp edges.
constexpr double crease_share = 1.0 / 24;
// Samples that are not at vertices are at most so many, or so many times the vertices.
constexpr double max_extras = 20000, max_extras_share = 3;
// How far from a sharp edge its rounding begins, of the samples' radius; edges that are a smaller share of that are
// those of thin parts, which would vanish.
constexpr double rounded_share = 0.5, min_edge = 0.4;
constexpr uint32_t max_parts = 4096;  // of an edge
// An edge that is longer than samples may be apart is divided if it is so many times as long.
constexpr double tolerated = 1.8;

constexpr uint32_t measured_triangles = 1024;
// Of the largest one: a smaller eigenvalue is that of a direction along the crease.
constexpr double min_spread = 0.05;
// A crease is a knife if its middle normal leans against its sides' by more than 75 degrees: 1 / cosine.
constexpr double max_lean = 3.9;

// ---- Sectors: the corners of a mesh, gathered around each vertex between sharp edges. A sector is a place of the
// surface that has one normal. A vertex of a smooth part has one, one on a crease has two, the corner of a cube three.

struct MeshSector {
    Position normal;   // the mean of its triangles' normals by their angles there; 0 if they have no area
    uint32_t corners;  // so many, counter-clockwise from the first
    Corner first;
    float shortest, longest, mean;  // metres, of the edges there
    bool creased;                   // there is a sharp edge at its side
    bool closed;                    // all around
};

struct MeshSectors {
    MeshSectors(const Mesh& of, Memory* memory)
        : mesh(of), face_normals(of.triangle_count(), memory), sector_of(size_t{3} * of.triangle_count(), memory) {}

    // Not so at a border.
    bool sharp(Corner edge) const {
        const uint32_t across = mesh.neighbour_at(edge);
        if (across == no_index) return false;
        const Vec3 a = load_vec3(face_normals[edge / 3].data()), b = load_vec3(face_normals[across].data());
        if (a.isZero() || b.isZero()) return false;
        return a.dot(b) < sharp_cosine;
    }
    const MeshSector& at(Corner corner) const { return sectors[sector_of[corner]]; }
    uint32_t count() const { return static_cast<uint32_t>(sectors.size()); }

    const Mesh& mesh;
    Buffer<Position> face_normals;
    Buffer<uint32_t> sector_of;  // of each corner
    GrowingBuffer<MeshSector> sectors;
    double size = 0;  // of the mesh: the diagonal of its box
};

// A sector while its corners are gathered.
struct SectorSum {
    void add(const MeshSectors& all, Corner corner) {
        const Mesh& mesh = all.mesh;
        const Vec3 origin = mesh.position(mesh.vertex_at(corner));
        const Vec3 a = mesh.position(mesh.vertex_at(next_corner(corner))) - origin;
        const Vec3 b = mesh.position(mesh.vertex_at(previous_corner(corner))) - origin;
        const Vec3 across = a.cross(b);
        const double across_size = across.norm();
        if (across_size > 0) normals += across * (std::atan2(across_size, a.dot(b)) / across_size);
        for (const double length : {a.norm(), b.norm()}) {
            const auto rounded = static_cast<float>(length);
            sector.shortest = edges == 0 ? rounded : std::min(sector.shortest, rounded);
            sector.longest = std::max(sector.longest, rounded);
            lengths += length;
            ++edges;
        }
        if (sector.corners++ == 0 && all.sharp(corner)) sector.creased = true;
    }
    MeshSector finish(bool closed) {
        sector.closed = closed;
        store_vec3(normals.stableNormalized(), sector.normal.data());
        sector.mean = static_cast<float>(lengths / edges);
        return sector;
    }

    MeshSector sector{};
    Vec3 normals = Vec3::Zero();
    double lengths = 0;
    uint32_t edges = 0;
};

SectorSum sector_from(Corner corner) {
    SectorSum sum;
    sum.sector.first = corner;
    return sum;
}

// Crossing the edge before a corner leads on counter-clockwise around its vertex, crossing the one after it leads back.
Task<void> gather_sectors(Pace& pace, MeshSectors& all) {
    const Mesh& mesh = all.mesh;
    Slice slice(Cost::tens_of_ns);
    for (uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
        // Where a sector begins.
        Corner corner = mesh.corner_of_vertex[vertex], start = corner;
        for (;;) {
            if (slice.is_over()) co_await pace;
            if (mesh.opposite(corner) == no_index || all.sharp(corner)) break;
            corner = mesh.turn(corner);
            if (corner == start) break;
        }
        start = corner;
        SectorSum sum = sector_from(corner);
        for (;;) {
            if (slice.is_over()) co_await pace;
            all.sector_of[corner] = all.count();
            sum.add(all, corner);
            const Corner next = mesh.turn(corner), edge = previous_corner(corner);
            const bool creased = all.sharp(edge), last = next == no_index || next == start;
            sum.sector.creased = sum.sector.creased || creased;
            corner = next;
            if (last || creased) all.sectors.push_back(sum.finish(last && next == start && !creased));
            if (last) break;
            if (creased) sum = sector_from(corner);
        }
    }
}

Task<void> find_sectors(Pace& pace, MeshSectors& all) {
    const Mesh& mesh = all.mesh;
    Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        store_vec3(triangle_normal(mesh, t), all.face_normals[t].data());
        for (const uint32_t vertex : mesh.triangles[t]) {
            const Vec3 p = mesh.position(vertex);
            lower = t == 0 ? p : lower.cwiseMin(p);
            upper = t == 0 ? p : upper.cwiseMax(p);
        }
    });
    all.size = (upper - lower).norm();
    uint32_t sharp_edges = 0;
    co_await each(pace, size_t{3} * mesh.triangle_count(), Cost::tens_of_ns, [&](Corner edge) {
        if (all.sharp(edge)) ++sharp_edges;
    });
    // A sharp edge is seen from both sides: it adds a sector at each end.
    all.sectors = GrowingBuffer<MeshSector>(size_t{mesh.vertex_count()} + sharp_edges, pace.memory());
    all.sectors.resize(0);
    co_await gather_sectors(pace, all);
}

// ---- Creases

// What rounds a sharp edge or corner: a sample of the cylinder or sphere that touches the planes on all its sides.
// Samples of the planes alone would swell there, each counting where another plane is the surface.
class CreaseRounding {
public:
    // Of a place on the crease.
    explicit CreaseRounding(const Vec3& place) : place_(place) {}

    // One of the planes there, by its normal of unit length.
    void add_normal(const Vec3& normal) {
        planes_ += normal * normal.transpose();
        sum_ += normal;
    }
    // `convex`: the sides of an edge there fall away from each other.
    void add_edge(bool convex) { (convex ? convex_ : concave_) = true; }

    // The sample, of so large a radius of curvature that it touches the planes no farther than `length` away from an
    // edge, nor is that radius longer; metres, > 0. About 0.5 us. False where edges are of both kinds, or as sharp as
    // knives.
    bool round(double length, double radius, OrientedSample& sample) const;

private:
    Vec3 place_;
    Eigen::Matrix3d planes_ = Eigen::Matrix3d::Zero();
    Vec3 sum_ = Vec3::Zero();
    bool convex_ = false, concave_ = false;
};

// The middle c = place - rho u of what touches all planes n_i . (x - place) = 0 from below has n_i . u = 1, along the
// normals' span; the surface then has the normal u / |u|.
bool CreaseRounding::round(double length, double radius, OrientedSample& sample) const {
    if (convex_ == concave_) return false;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(planes_);
    const Vec3 spread = solver.eigenvalues();
    Vec3 middle = Vec3::Zero();
    Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
    int rank = 0;
    for (int i = 0; i < 3; ++i) {
        if (!(spread[i] > min_spread * spread[2])) continue;
        const Vec3 axis = solver.eigenvectors().col(i);
        middle += axis * (axis.dot(sum_) / spread[i]);
        across += axis * axis.transpose();
        ++rank;
    }
    const double lean = middle.norm();
    if (rank < 2 || !(lean > 1) || lean > max_lean) return false;
    const double tangent = std::sqrt((lean * lean - 1) / (rank - 1));
    const double rho = length / std::max(1.0, tangent);
    const double side = convex_ ? 1 : -1;
    const Vec3 normal = middle / lean, at = place_ - side * rho * (lean - 1) * normal;
    const Eigen::Matrix3d bend = side / rho * across;
    sample = {{at.x(), at.y(), at.z()},
              {normal.x(), normal.y(), normal.z()},
              {bend(0, 0), bend(0, 1), bend(0, 2), bend(1, 1), bend(1, 2), bend(2, 2)},
              radius};
    return true;
}

// ---- Samples

// How many parts a length has where samples may be `fine` apart.
uint32_t parts_of(double length, double fine) {
    if (!(length > tolerated * fine)) return 1;
    return static_cast<uint32_t>(std::clamp(std::round(length / fine), 2.0, double{max_parts}));
}

struct Fitted {
    OrientedSample sample;
    double spacing;  // how far samples may be apart here
};

// What the samples are made of: a sample fitted at each sector.
struct Sampling {
    Sampling(const MeshSectors& of, Memory* memory)
        : mesh(of.mesh),
          sectors(of),
          fitted(of.count(), memory),
          spacing(of.mesh.triangle_count(), memory),
          longest(of.mesh.triangle_count(), memory) {}

    const Fitted& at(Corner corner) const { return fitted[sectors.sector_of[corner]]; }
    double length(Corner edge) const {
        return (mesh.position(mesh.vertex_at(next_corner(edge))) - mesh.position(mesh.vertex_at(edge))).norm();
    }
    void add_neighbour(Corner corner, QuadricFit& fit) const {
        const Vec3 normal = load_vec3(sectors.at(corner).normal.data()), place = mesh.position(mesh.vertex_at(corner));
        fit.add_point(place);
        if (!normal.isZero()) fit.add_normal(place, normal);
    }
    void keep_fit(uint32_t number, const BentNormal& fit) {
        const MeshSector& sector = sectors.sectors[number];
        const Vec3 place = mesh.position(mesh.vertex_at(sector.first));
        Fitted& own = fitted[number];
        own.sample = {{place.x(), place.y(), place.z()}, {fit.normal.x(), fit.normal.y(), fit.normal.z()}, fit.bend, 0};
        double wanted = sector.longest, least = sector.shortest;
        if (fit.curvature > 0) wanted = std::min(wanted, curvature_share / fit.curvature);
        if (sector.creased) {
            wanted = std::min(wanted, crease_share * sectors.size);
            least = std::min(least, crease_share * sectors.size);
        }
        own.spacing = std::max(wanted, least);
        const double bent = fit.curvature * own.spacing;
        if (bent > max_bent) {
            for (double& b : own.sample.bend) b *= max_bent / bent;
        }
    }

    // How far apart samples in the triangle may be; infinite if its corners tell nothing.
    double wanted_spacing(uint32_t triangle) const {
        double wanted = std::numeric_limits<double>::infinity();
        for (Corner corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
            const Fitted& own = at(corner);
            if (own.spacing > 0) wanted = std::min(wanted, own.spacing * coarseness);
        }
        return wanted;
    }

    // A vertex has to reach across its triangles, or to the samples within them.
    void spread_reach(uint32_t triangle) {
        double own_longest = 0;
        for (Corner edge = 3 * triangle; edge < 3 * triangle + 3; ++edge)
            own_longest = std::max(own_longest, length(edge));
        const double fine = wanted_spacing(triangle);
        spacing[triangle] = static_cast<float>(fine);
        longest[triangle] = static_cast<float>(own_longest);
        const double reach = radius_share * (parts_of(own_longest, fine) == 1 ? own_longest : fine);
        for (Corner corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
            Fitted& own = fitted[sectors.sector_of[corner]];
            if (own.spacing > 0) own.sample.radius = std::max(own.sample.radius, reach);
        }
    }

    // Most triangles get no samples but those at their vertices.
    bool is_divided(uint32_t triangle) const {
        float fine = spacing[triangle];
        for (const uint32_t across : mesh.neighbours[triangle]) {
            if (across != no_index) fine = std::min(fine, spacing[across]);
        }
        return longest[triangle] > 0.99 * tolerated * fine;
    }

    // How long an edge's parts may be: as the finer of its triangles wants it.
    double edge_spacing(Corner edge) const {
        const double fine = spacing[triangle_of(edge)];
        const uint32_t across = mesh.neighbour_at(edge);
        return across == no_index ? fine : std::min(fine, double{spacing[across]});
    }

    // Whether the triangles at a sharp edge fall away from each other.
    bool convex(Corner edge) const {
        const Vec3 far = mesh.position(mesh.vertex_at(previous_corner(mesh.opposite(edge))));
        const Vec3 from = mesh.position(mesh.vertex_at(edge));
        return vector_area(mesh, triangle_of(edge)).dot(far - from) < 0;
    }

    bool on_crease(Corner edge, double share, double radius, OrientedSample& sample) const {
        const Corner other = mesh.opposite(edge);
        const Corner corners[2][2] = {{edge, next_corner(edge)}, {next_corner(other), other}};
        const Vec3 from = mesh.position(mesh.vertex_at(edge)), to = mesh.position(mesh.vertex_at(other));
        CreaseRounding crease((1 - share) * from + share * to);
        double shortest = std::numeric_limits<double>::infinity();
        for (const auto& side : corners) {
            Vec3 normal = Vec3::Zero();
            for (const size_t k : {0u, 1u}) {
                const uint32_t sector = sectors.sector_of[side[k]];
                if (!(fitted[sector].spacing > 0)) return false;
                normal += (k == 0 ? 1 - share : share) * Vec3(fitted[sector].sample.normal.data());
                shortest = std::min(shortest, double{sectors.sectors[sector].shortest});
            }
            crease.add_normal(normal.normalized());
        }
        crease.add_edge(convex(edge));
        const double length = rounded_share * radius;
        return shortest > min_edge * length && crease.round(length, radius, sample);
    }

    // A sample in a triangle: what its corners know, in between. False if they know no normal.
    bool between(uint32_t triangle, const double* weights, double radius, OrientedSample* sample) const {
        Vec3 place = Vec3::Zero(), normal = Vec3::Zero();
        std::array<double, 6> bend{};
        for (uint32_t k = 0; k < 3; ++k) {
            const Corner corner = 3 * triangle + k;
            const Fitted& own = at(corner);
            place += weights[k] * mesh.position(mesh.vertex_at(corner));
            if (!(own.spacing > 0)) continue;
            normal += weights[k] * Vec3(own.sample.normal.data());
            for (size_t i = 0; i < 6; ++i) bend[i] += weights[k] * own.sample.bend[i];
        }
        const double normal_length = normal.norm();
        if (!(normal_length > 1e-3)) return false;
        normal /= normal_length;
        if (sample) *sample = {{place.x(), place.y(), place.z()}, {normal.x(), normal.y(), normal.z()}, bend, radius};
        return true;
    }

    // At a share of an edge of the triangle.
    bool along_edge(Corner edge, double share, double radius, OrientedSample* sample) const {
        if (sample && sectors.sharp(edge) && on_crease(edge, share, radius, *sample)) return true;
        const uint32_t k = edge % 3;
        double weights[3] = {};
        weights[k] = 1 - share;
        weights[(k + 1) % 3] = share;
        return between(triangle_of(edge), weights, radius, sample);
    }

    const Mesh& mesh;
    const MeshSectors& sectors;
    Buffer<Fitted> fitted;           // of sectors
    Buffer<float> spacing, longest;  // metres, of triangles: how far samples may be apart, and the longest edge
    double coarseness = 1;           // of the spacing, where there would be too many samples
};

// Normals and curvatures from the positions and normals of the vertices around each sector.
Task<void> fit_sectors(Pace& pace, Sampling& s) {
    Slice slice(Cost::tens_of_ns);
    for (uint32_t number = 0; number < s.sectors.count(); ++number) {
        const MeshSector& sector = s.sectors.sectors[number];
        const Vec3 normal = load_vec3(sector.normal.data());
        if (slice.is_over(4)) co_await pace;
        if (normal.isZero() || !(sector.mean > 0)) {
            s.fitted[number] = {};
            continue;
        }
        Corner corner = sector.first;
        QuadricFit fit(s.mesh.position(s.mesh.vertex_at(corner)), normal, sector.mean, QuadricKind::through);
        for (uint32_t done = 1;; ++done) {
            s.add_neighbour(next_corner(corner), fit);
            if (slice.is_over()) co_await pace;
            if (done == sector.corners) break;
            corner = s.mesh.turn(corner);
        }
        if (!sector.closed) s.add_neighbour(previous_corner(corner), fit);
        s.keep_fit(number, fit.solve());
    }
}

// Samples that are not at vertices: along the edges of triangles, then in rows across them, parallel to the shortest
// edge. Only counts them if there is no place for them, and not on after `max`.
Task<uint32_t> add_extras(Pace& pace, const Sampling& s, double max, GrowingBuffer<OrientedSample>* out) {
    uint32_t count = 0;
    OrientedSample sample;
    OrientedSample* const made = out ? &sample : nullptr;
    Slice slice(Cost::some_ns);
    for (uint32_t triangle = 0; triangle < s.mesh.triangle_count(); ++triangle) {
        if (slice.is_over()) co_await pace;
        if (!s.is_divided(triangle)) continue;
        double lengths[3], longest = 0;
        uint32_t shortest = 0;
        for (uint32_t k = 0; k < 3; ++k) {
            const Corner edge = 3 * triangle + k, other = s.mesh.opposite(edge);
            lengths[k] = s.length(edge);
            longest = std::max(longest, lengths[k]);
            if (lengths[k] < lengths[shortest]) shortest = k;
            if (other != no_index && edge > other) continue;
            const double fine = s.edge_spacing(edge);
            const uint32_t parts = parts_of(lengths[k], fine);
            for (uint32_t part = 1; part < parts; ++part) {
                if (slice.is_over(64)) co_await pace;
                if (!s.along_edge(edge, double(part) / parts, radius_share * fine, made)) continue;
                if (out) out->push_back(sample);
                if (++count > max) co_return count;
            }
        }
        const double fine = s.spacing[triangle];
        const uint32_t rows = parts_of(longest, fine);
        for (uint32_t row = 1; row < rows; ++row) {
            const double down = double(row) / rows;  // from the corner that is opposite
            const auto columns = static_cast<uint32_t>(std::ceil(lengths[shortest] * down / fine));
            if (slice.is_over(64)) co_await pace;
            for (uint32_t column = 1; column < columns; ++column) {
                if (slice.is_over(64)) co_await pace;
                double weights[3];
                const double share = double(column) / columns;
                weights[(shortest + 2) % 3] = 1 - down;
                weights[shortest] = down * (1 - share);
                weights[(shortest + 1) % 3] = down * share;
                if (!s.between(triangle, weights, radius_share * fine, made)) continue;
                if (out) out->push_back(sample);
                if (++count > max) co_return count;
            }
        }
    }
    co_return count;
}

// A vertex of several sectors has one sample that rounds them all, or each sector has its own where that is not
// possible.
Task<void> add_vertices(Pace& pace, const Sampling& s, GrowingBuffer<OrientedSample>& out) {
    const GrowingBuffer<MeshSector>& sectors = s.sectors.sectors;
    const Fitted* const fitted = s.fitted.data();
    std::optional<CreaseRounding> crease;  // of the vertex whose sectors come
    uint32_t group = 0;                    // its first sector
    double shortest = 0, radius = 0;
    co_await each(pace, s.sectors.count(), Cost::tens_of_ns, [&](uint32_t i) {
        const Corner first = sectors[i].first;
        const uint32_t vertex = s.mesh.vertex_at(first), end = i + 1;
        if (!crease) {
            crease.emplace(s.mesh.position(vertex));
            group = i;
            shortest = std::numeric_limits<double>::infinity();
            radius = 0;
        }
        if (fitted[i].spacing > 0) {
            crease->add_normal(Vec3(fitted[i].sample.normal.data()));
            shortest = std::min(shortest, double{sectors[i].shortest});
            radius = std::max(radius, fitted[i].sample.radius);
        }
        if (s.sectors.sharp(first)) crease->add_edge(s.convex(first));
        if (end < s.sectors.count() && s.mesh.vertex_at(sectors[end].first) == vertex) return;
        OrientedSample sample;
        const double length = rounded_share * radius;
        if (end > group + 1 && radius > 0 && shortest > min_edge * length && crease->round(length, radius, sample)) {
            out.push_back(sample);
        } else {
            for (uint32_t k = group; k < end; ++k) {
                if (fitted[k].sample.radius > 0) out.push_back(fitted[k].sample);
            }
        }
        crease.reset();
    });
}

}  // namespace

Task<SampledSurface> sample_mesh(Pace& pace, const Mesh& mesh, double smoothing_scale) {
    const uint32_t triangles = mesh.triangle_count();
    MeshSectors sectors(mesh, pace.memory());
    co_await find_sectors(pace, sectors);
    Sampling sampling(sectors, pace.memory());
    co_await fit_sectors(pace, sampling);
    const double max = std::max(max_extras, max_extras_share * mesh.vertex_count());
    uint32_t extras = 0;
    for (;; sampling.coarseness *= 1.4) {
        co_await each(pace, triangles, Cost::tens_of_ns, [&](uint32_t t) { sampling.spread_reach(t); });
        extras = co_await add_extras(pace, sampling, max, nullptr);
        if (extras <= max) break;
    }
    GrowingBuffer<OrientedSample> samples(size_t{sectors.count()} + extras, pace.memory());
    samples.resize(0);
    co_await add_vertices(pace, sampling, samples);
    if (extras > 0) co_await add_extras(pace, sampling, HUGE_VAL, &samples);
    sampling.fitted = {};
    co_await pace;
    sectors.sectors = {};
    co_await pace;
    sectors.face_normals = {};
    co_await pace;
    sectors.sector_of = {};
    co_await pace;
    OrientedSamples surface = co_await oriented_samples(pace, samples);
    if (smoothing_scale > 0) surface = co_await smoothed_samples(pace, std::move(surface), smoothing_scale);
    SampledSurface out{.surface = std::move(surface), .deviation = {}, .extras = extras};
    const uint32_t stride = (triangles + measured_triangles - 1) / measured_triangles;
    co_await each(pace, (triangles + stride - 1) / stride, Cost::microseconds, [&](uint32_t i) {
        const Triple& corners = mesh.triangles[i * stride];
        const Vec3 a = mesh.position(corners[0]), b = mesh.position(corners[1]), c = mesh.position(corners[2]);
        out.deviation.add(out.surface, a);
        out.deviation.add(out.surface, (a + b + c) / 3);
    });
    co_return out;
}

}  // namespace flg
