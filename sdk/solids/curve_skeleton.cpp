// SPDX-License-Identifier: MIT
#include "solids/curve_skeleton.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <queue>
#include <span>

#include "runtime/each.h"
#include "solids/solid_steps.h"

namespace flg {

namespace {

constexpr uint32_t nowhere = UINT32_MAX;
constexpr float centred = 3;           // power of the depth that steps cost less by
constexpr double root_is_near = 1.5;   // of the depth, by the diagonal: how much the root is near the middle
constexpr double filled = 1.4;         // of the radius, around a branch
constexpr double filled_more = 1.5;    // cells
constexpr double stands_out = 2.6;     // of its own radius: so far a branch leaves what it begins in
constexpr double in_the_middle = 0.4;  // of the radius: so near to the plane a branch runs along it
constexpr double sees_around = 4;      // of the radius: how far a branch looks to know a sheet
constexpr double widest_limb = 3.1;    // its volume there by that of a tube; that of a sheet is `sees_around`
constexpr double least_look = 1.5, longest_look = 60;  // cells
constexpr uint32_t most_branches = 512;
constexpr uint32_t smoothings = 12;

struct Entry {
    float way;
    uint32_t cell;
    bool operator<(const Entry& other) const { return way != other.way ? way > other.way : cell > other.cell; }
};
using Queue = std::priority_queue<Entry, std::pmr::deque<Entry>>;

class Skeletonizer {
public:
    Skeletonizer(Pace& pace, const SolidGrid& grid, const Buffer<float>& depths, double shortest)
        : pace_(pace),
          grid_(grid),
          depths_(depths),
          shortest_(shortest),
          count_(static_cast<uint32_t>(grid.count())),
          first_x_(grid.frame.is_mirrored ? grid.size[0] / 2 : 0),
          neighbours_(grid),
          ways_(count_, pace.memory()),
          costs_(count_, pace.memory()),
          next_(count_, pace.memory()),
          node_of_(count_, pace.memory()),
          is_done_(count_, pace.memory()),
          seen_(count_, pace.memory()),
          order_(count_, pace.memory()),
          look_(count_, pace.memory()),
          out_(pace.memory()) {}

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

    Task<CurveSkeleton> run() {
        pace_.stage("curves");
        const uint32_t root = co_await find_root();
        co_await each(pace_, count_, Cost::some_ns, [&](uint32_t i) {
            is_done_[i] = !may_enter(i);
            seen_[i] = 0;
            node_of_[i] = nowhere;
        });
        co_await spread(
            root, ways_, [](uint32_t) { return 1.0f; }, true);
        co_await spread(
            root, costs_, [&](uint32_t to) { return std::pow(depths_[to] + 0.5f, -centred); }, false);
        out_.nodes.push_back({place(root), depths_[root] * grid_.cell, no_curve_node, grid_.frame.is_mirrored});
        node_of_[root] = 0;
        if (grid_.frame.is_mirrored) out_.nodes[0].at = on_plane(out_.nodes[0].at);
        co_await fill(out_.nodes[0].at, depths_[root]);
        uint32_t branches = 0;
        Slice slice(Cost::some_ns);
        for (uint32_t i = settled_; i-- > 0 && branches < most_branches;) {
            if (slice.is_over()) co_await pace_;
            if (is_done_[order_[i]]) continue;
            co_await add_branch(order_[i]);
            ++branches;
        }
        for (Buffer<uint32_t>* large : {&next_, &node_of_, &order_, &look_}) {
            *large = {};
            co_await pace_;
        }
        for (Buffer<float>* large : {&ways_, &costs_}) {
            *large = {};
            co_await pace_;
        }
        co_return std::move(out_);
    }

private:
    bool may_enter(uint32_t cell) const { return grid_.inside[cell] && cell % grid_.size[0] >= first_x_; }
    Vec3 place(uint32_t cell) const { return grid_.middle_of(cell); }
    double beside(const Vec3& at) const { return grid_.frame.axes.col(0).dot(at - grid_.frame.middle); }
    Vec3 on_plane(const Vec3& at) const { return at - beside(at) * grid_.frame.axes.col(0); }

    // The deepest cell that is near the middle of the solid.
    Task<uint32_t> find_root() {
        Vec3 sum = Vec3::Zero(), low = Vec3::Constant(HUGE_VAL), high = -low;
        double inside = 0;
        float deepest = 0;
        co_await each(pace_, count_, Cost::tens_of_ns, [&](uint32_t i) {
            if (!may_enter(i)) return;
            const Vec3 at = place(i);
            sum += at;
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
            inside += 1;
            deepest = std::max(deepest, depths_[i]);
        });
        Vec3 middle = sum / inside;
        if (grid_.frame.is_mirrored) middle = on_plane(middle);
        const double size = std::max((high - low).norm(), grid_.cell), scale = deepest > 0 ? deepest : 1;
        uint32_t best = nowhere;
        double best_score = 0;
        co_await each(pace_, count_, Cost::tens_of_ns, [&](uint32_t i) {
            if (!may_enter(i) || (grid_.frame.is_mirrored && i % grid_.size[0] != first_x_)) return;
            const double score = depths_[i] / scale - root_is_near * (place(i) - middle).norm() / size;
            if (best == nowhere || score > best_score) best = i, best_score = score;
        });
        // A mirror with nothing in its plane.
        if (best == nowhere)
            co_await each(pace_, count_, Cost::some_ns, [&](uint32_t i) {
                if (best == nowhere && may_enter(i)) best = i;
            });
        co_return best;
    }

    // Cheapest ways from the root (Dijkstra). Ways of equal cost go over the cell with the lower number.
    template <class Price>
    Task<void> spread(uint32_t root, Buffer<float>& costs, Price price, bool is_first) {
        co_await each(pace_, count_, Cost::some_ns, [&](uint32_t i) { costs[i] = HUGE_VALF; });
        Queue queue(std::less<Entry>(), std::pmr::deque<Entry>(pace_.memory()));
        costs[root] = 0;
        next_[root] = nowhere;
        queue.push({0, root});
        Slice slice(Cost::tens_of_ns);
        while (!queue.empty()) {
            const Entry entry = queue.top();
            queue.pop();
            if (slice.is_over(2)) co_await pace_;
            if (entry.way > costs[entry.cell]) continue;
            if (is_first) order_[settled_++] = entry.cell;
            for (size_t k = 0; k < neighbours_.cells.size(); ++k) {
                const uint32_t to = entry.cell + neighbours_.cells[k];
                if (!may_enter(to)) continue;
                const float way = entry.way + neighbours_.lengths[k] * price(to);
                if (way >= costs[to]) continue;
                costs[to] = way;
                next_[to] = entry.cell;
                queue.push({way, to});
            }
            if (slice.is_over(26)) co_await pace_;
        }
    }

    // What a branch fills is done.
    Task<void> fill(Vec3 at, double depth) {
        const Vec3 middle = grid_.local(at);
        const double reach = filled * depth + filled_more;
        uint32_t low[3], high[3];
        for (int k = 0; k < 3; ++k) {
            low[k] = static_cast<uint32_t>(std::clamp(std::ceil(middle[k] - reach - 0.5), 0.0, grid_.size[k] - 1.0));
            high[k] = static_cast<uint32_t>(std::clamp(std::floor(middle[k] + reach - 0.5), 0.0, grid_.size[k] - 1.0));
        }
        const uint32_t rows = high[1] + 1 - low[1];
        co_await each_by_work(pace_, size_t{rows} * (high[2] + 1 - low[2]), Cost::some_ns, [&](uint32_t i) {
            const uint32_t y = low[1] + i % rows, z = low[2] + i / rows;
            const double dy = y + 0.5 - middle.y(), dz = z + 0.5 - middle.z(), left = reach * reach - dy * dy - dz * dz;
            if (left < 0) return 4u;
            for (uint32_t x = low[0]; x <= high[0]; ++x) {
                const double dx = x + 0.5 - middle.x();
                if (dx * dx <= left) is_done_[grid_.number(x, y, z)] = 1;
            }
            return 4 + high[0] - low[0];
        });
    }

    Task<void> add_branch(uint32_t tip) {
        // From the tip to the tree.
        std::pmr::vector<CurveNode> way(pace_.memory());
        std::pmr::vector<uint32_t> cells(pace_.memory());
        Slice slice(Cost::tens_of_ns);
        uint32_t cell = tip;
        for (; node_of_[cell] == nowhere; cell = next_[cell]) {
            way.push_back({place(cell), depths_[cell] * grid_.cell, no_curve_node, false});
            cells.push_back(cell);
            if (slice.is_over()) co_await pace_;
        }
        const uint32_t begin = node_of_[cell];
        const CurveNode from = out_.nodes[begin];
        for (size_t i = 0; i < way.size(); ++i) co_await fill(way[i].at, way[i].radius / grid_.cell);

        // It ends where its ball reaches the tip.
        size_t end = 0;
        while (end + 1 < way.size() && (way[end].at - way[0].at).norm() < way[end].radius + grid_.cell) {
            ++end;
            if (slice.is_over()) co_await pace_;
        }
        double out_by = -from.radius, radius = 0;
        for (size_t i = 0; i < way.size(); ++i) {
            out_by += (way[i].at - (i + 1 < way.size() ? way[i + 1].at : from.at)).norm();
            radius += way[i].radius;
            if (slice.is_over()) co_await pace_;
        }
        radius /= static_cast<double>(way.size());
        if (!is_limb(out_by, radius) || co_await is_sheet(way, cells, end)) co_return;
        const size_t leaves = where_it_leaves_the_middle(from, way, 0.5 * radius);
        if (leaves > end && leaves < way.size()) {
            // What goes on beside the plane is there twice, or is none.
            double beyond = -way[leaves].radius, wide = 0;
            for (size_t i = 0; i < leaves; ++i) beyond += (way[i + 1].at - way[i].at).norm(), wide += way[i].radius;
            if (!is_limb(beyond, wide / static_cast<double>(leaves))) end = leaves;
        }

        const auto first = static_cast<uint32_t>(out_.nodes.size());
        for (size_t i = way.size(); i-- > end;) {
            CurveNode node = way[i];
            node.parent = i + 1 == way.size() ? begin : static_cast<uint32_t>(out_.nodes.size()) - 1;
            node.is_middle = i >= leaves;
            node_of_[cells[i]] = static_cast<uint32_t>(out_.nodes.size());
            out_.nodes.push_back(node);
            if (slice.is_over()) co_await pace_;
        }
        // Cells beyond the end stand for it.
        for (size_t i = 0; i < end; ++i) node_of_[cells[i]] = static_cast<uint32_t>(out_.nodes.size()) - 1;
        co_await smooth(first);
    }

    bool is_limb(double out_by, double radius) const { return out_by >= std::max(shortest_, stands_out * radius); }

    // Whether a branch lies in a sheet: what is around it, beyond what it begins in, is more than a limb that is as
    // thick has. Three places are asked, and the second widest counts.
    Task<bool> is_sheet(std::span<const CurveNode> way, std::span<const uint32_t> cells, size_t end) {
        size_t begin = way.size() - 1;
        while (begin > end && (way[begin].at - way.back().at).norm() < way.back().radius) --begin;
        std::array<double, 3> wide{};
        for (size_t k = 0; k < wide.size(); ++k) {
            const size_t i = end + (k + 1) * (begin - end) / 4;
            const double radius = std::max(way[i].radius / grid_.cell + 0.25, least_look);
            const double reach = std::min(sees_around * radius, longest_look);
            const double length = std::min(reach, (way[i].at - way[begin].at).norm() / grid_.cell) +
                                  std::min(reach, (way[i].at - way[0].at).norm() / grid_.cell);
            wide[k] = co_await volume_around(cells[i], reach, ways_[cells[begin]]) /
                      (std::numbers::pi * radius * radius * length);
        }
        std::sort(wide.begin(), wide.end());
        if (wide[1] <= widest_limb) co_return false;
        // The sheet needs no more looks there.
        co_await each(pace_, count_, Cost::some_ns, [&](uint32_t i) {
            if (seen_[i] + uint32_t{3} > looks_ && seen_[i] != 0) is_done_[i] = 1;
        });
        co_return true;
    }

    // In cells: of what hangs together around one and is not nearer to the root than `way`.
    Task<double> volume_around(uint32_t cell, double reach, float way) {
        const Vec3 middle = grid_.local(place(cell));
        ++looks_;
        seen_[cell] = looks_;
        look_[0] = cell;
        Slice slice(Cost::some_ns);
        uint32_t next = 0, found = 1;
        for (; next < found; ++next) {
            for (const int32_t step : neighbours_.cells) {
                const uint32_t to = look_[next] + step;
                if (!may_enter(to) || seen_[to] == looks_ || ways_[to] < way) continue;
                const auto [x, y, z] = grid_.place(to);
                if ((Vec3(x + 0.5, y + 0.5, z + 0.5) - middle).squaredNorm() > reach * reach) continue;
                seen_[to] = looks_;
                look_[found++] = to;
            }
            if (slice.is_over(64)) co_await pace_;
        }
        co_return static_cast<double>(next);
    }

    // The last place of a way, from its tip, where it still runs along the mirror's plane; its size: nowhere.
    size_t where_it_leaves_the_middle(const CurveNode& from, std::span<const CurveNode> way, double wide) const {
        size_t leaves = way.size();
        if (!grid_.frame.is_mirrored || !from.is_middle) return leaves;
        while (leaves > 0 &&
               beside(way[leaves - 1].at) <= std::max({in_the_middle * way[leaves - 1].radius, grid_.cell, wide}))
            --leaves;
        return leaves;
    }

    // Ways go from cell to cell: a few means of neighbours along the branch.
    Task<void> smooth(uint32_t first) {
        const auto last = static_cast<uint32_t>(out_.nodes.size());
        for (uint32_t i = first; i < last; ++i)
            if (out_.nodes[i].is_middle) out_.nodes[i].at = on_plane(out_.nodes[i].at);
        for (uint32_t round = 0; round < smoothings; ++round) {
            Vec3 before = out_.nodes[out_.nodes[first].parent].at;
            co_await each(pace_, first, last, Cost::tens_of_ns, [&](uint32_t i) {
                CurveNode& node = out_.nodes[i];
                const Vec3 own = node.at;
                if (i + 1 < last) node.at = 0.25 * before + 0.5 * own + 0.25 * out_.nodes[i + 1].at;
                if (node.is_middle) node.at = on_plane(node.at);
                before = own;
            });
        }
    }

    Pace& pace_;
    const SolidGrid& grid_;
    const Buffer<float>& depths_;
    double shortest_;
    uint32_t count_, first_x_;
    SolidSteps neighbours_;
    Buffer<float> ways_, costs_;
    Buffer<uint32_t> next_, node_of_;  // by cell: the next one on the way to the root; the node there
    Buffer<uint8_t> is_done_;
    Buffer<uint16_t> seen_;  // by the number of the last look that saw a cell
    uint16_t looks_ = 0;
    Buffer<uint32_t> order_, look_;  // cells, the nearest to the root first; those of a look
    uint32_t settled_ = 0;
    CurveSkeleton out_;
};

}  // namespace

Task<CurveSkeleton> curve_skeleton(Pace& pace, const SolidGrid& grid, const Buffer<float>& depths, double shortest) {
    Skeletonizer skeletonizer(pace, grid, depths, shortest);
    co_return co_await skeletonizer.run();
}

}  // namespace flg
