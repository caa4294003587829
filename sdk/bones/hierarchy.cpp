// SPDX-License-Identifier: MIT
#include "bones/hierarchy.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "bones/earlier_joints.h"
#include "bones/joint_labels.h"
#include "runtime/each.h"
#include "skeletons/node_clusters.h"

namespace flg {
namespace {

constexpr double same_joint = 0.05;  // of a part's length: joints of a redrawn part that are farther apart are others
constexpr double middle_at_joint = 0.75;  // of the radius: a joint so near to the trunk's middle is it
constexpr double middle_at_tip = 0.25;    // likewise, an end of the trunk

double area_of(const ModelPart& part) {
    return part.part->area * part.scale * part.scale;
}

MirrorPlane mirror_of(const ModelPart& part) {
    if (!part.part->mirror) return {};
    const MirrorAxis& axis = *part.part->mirror;
    return {part.place(axis.at),
            (part.placement.col(1) * axis.along.x - part.placement.col(0) * axis.along.y).normalized()};
}

// What may be a root: best a part that the host made one, then one that is not there twice, then the largest.
bool is_better_root(const HeldModel& model, uint32_t a, uint32_t b) {
    const ModelPart &x = model.parts[a], &y = model.parts[b];
    if ((x.parent == a) != (y.parent == b)) return x.parent == a;
    if ((x.parent == no_number) != (y.parent == no_number)) return y.parent != no_number && y.parent != b;
    if ((x.twin == no_number) != (y.twin == no_number)) return x.twin == no_number;
    return area_of(x) > area_of(y);
}

class Builder {
public:
    Builder(Pace& pace, HeldModel& model, BoneGraph& graph, std::span<const uint32_t> first_joints, double collapse)
        : pace_(pace),
          model_(model),
          graph_(graph),
          first_(first_joints),
          collapse_(collapse),
          out_(pace.memory()),
          edges_(pace.memory()),
          own_bones_(pace.memory()),
          shapes_(pace.memory()),
          mirrors_(pace.memory()),
          outline_(pace.memory()),
          groups_(model.parts.size(), pace.memory()),
          is_placed_(model.parts.size(), pace.memory()),
          may_meet_(model.parts.size(), pace.memory()),
          hung_(pace.memory()) {}

    Task<Hierarchy> build() {
        co_await look_at_parts();
        co_await connect_all();
        co_await direct();
        co_return std::move(out_);
    }

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

private:
    uint32_t part_count() const { return static_cast<uint32_t>(model_.parts.size()); }
    uint32_t own_end() const { return first_.back(); }

    Task<void> look_at_parts() {
        shapes_.reserve(part_count());
        mirrors_.reserve(part_count());
        co_await each(pace_, part_count(), Cost::tens_of_ns, [&](uint32_t p) {
            const ModelPart& part = model_.parts[p];
            const HeldPart& drawn = *part.part;
            groups_.begin(p);
            is_placed_[p] = 0;
            WidePart shape;
            if (is_wide(drawn.area, drawn.length)) shape.outline = &drawn.outline;
            shape.placement = part.placement, shape.scale = part.scale, shape.thickness = part.thickness;
            shape.widest = drawn.widest;
            shapes_.push_back(shape);
            mirrors_.push_back(mirror_of(part));
        });
        hung_.resize(part_count());
        out_.links.resize(part_count());
        co_await each(pace_, own_end(), Cost::some_ns,
                      [&](uint32_t j) { graph_.joints()[j].own_degree = graph_.joints()[j].degree; });
        co_await each(pace_, graph_.bones().size(), Cost::some_ns, [&](uint32_t b) {
            if (!graph_.bones()[b].gone)
                own_bones_.push_back({graph_.bones()[b].joints[0], graph_.bones()[b].joints[1]});
        });
        own_ends_ = co_await group_by(pace_, 2 * own_bones_.size(), own_end(),
                                      [&](uint32_t end) { return own_bones_[end / 2][end % 2]; });
    }

    uint32_t trunk() const {
        if (model_.root != no_number) return model_.root;
        uint32_t best = 0;
        for (uint32_t p = 1; p < part_count(); ++p)
            if (is_better_root(model_, p, best)) best = p;
        return best;
    }

    // A part comes after the one that the host hung it on.
    void put_in_order(uint32_t part, std::pmr::vector<uint32_t>& order, std::pmr::vector<bool>& is_in) const {
        const size_t begin = order.size();
        for (uint32_t p = part; p != no_number && !is_in[p]; p = model_.parts[p].parent) {
            is_in[p] = true;
            order.push_back(p);
        }
        std::reverse(order.begin() + static_cast<ptrdiff_t>(begin), order.end());
    }

    Task<void> connect_all() {
        std::pmr::vector<uint32_t> order(pace_.memory());
        std::pmr::vector<bool> is_in(part_count(), false, pace_.memory());
        trunk_ = trunk();
        put_in_order(trunk_, order, is_in);
        co_await each(pace_, part_count(), Cost::tens_of_ns, [&](uint32_t p) { put_in_order(p, order, is_in); });
        for (const uint32_t p : order) {
            is_placed_[p] = 1;
            co_await place_outline(p);
            const ModelPart& part = model_.parts[p];
            if (part.parent == no_number) {
                for (bool goes_on = co_await may_meet(p); goes_on;) {
                    const PartLink link = co_await connect_part(pace_, graph_, new_part(p), others());
                    goes_on = add(link);
                    if (goes_on) goes_on = co_await may_meet(p);
                }
            } else if (part.parent != p) {
                co_await hang(p, part);
            }
            // What the host hung somewhere stays there.
            bool goes_on = part.parent != p;
            if (goes_on) goes_on = co_await may_meet(p, true);
            while (goes_on) {
                const PartLink link = co_await connect_to_part(pace_, graph_, new_part(p), others());
                goes_on = add(link);
                if (goes_on) goes_on = co_await may_meet(p, true);
            }
        }
        // Now that all are there, across a gap: what came later might have closed it.
        for (const uint32_t p : order) {
            if (model_.parts[p].parent == p || hung_[p].event != PartLink::Event::root) continue;
            if (groups_.first(p) == groups_.first(trunk_)) continue;
            const bool any = co_await may_meet(p);
            if (!any) continue;
            const PartLink link = co_await connect_across_gap(pace_, graph_, new_part(p), others());
            add(link);
        }
    }

    NewPart new_part(uint32_t p) const {
        NewPart part{p, first_[p], first_[p + 1], outline_};
        if (model_.parts[p].twin != no_number)
            part.twin = {model_.mirror_offset * model_.mirror_normal, model_.mirror_normal};
        return part;
    }
    OtherParts others() const { return {may_meet_, hung_, shapes_, mirrors_}; }

    bool add(const PartLink& link) {
        if (link.event == PartLink::Event::root) return false;
        groups_.join(link.child, link.parent);
        if (hung_[link.child].event == PartLink::Event::root) hung_[link.child] = link;
        edges_.push_back(link);
        return true;
    }

    // Parts that do not hang together with this one yet; returns whether there are any.
    Task<bool> may_meet(uint32_t part, bool as_children = false) {
        const uint32_t own = groups_.first(part), twin = model_.parts[part].twin;
        bool any = false;
        co_await each(pace_, part_count(), Cost::tens_of_ns, [&](uint32_t p) {
            may_meet_[p] = is_placed_[p] != 0 && p != twin && groups_.first(p) != own &&
                           !(as_children && model_.parts[p].parent != no_number);
            any = any || may_meet_[p] != 0;
        });
        co_return any;
    }

    // Where the host says. A joint is found once the parent's are numbered.
    Task<void> hang(uint32_t p, const ModelPart& part) {
        if (!part.parent_joint.empty()) {
            groups_.join(p, part.parent);
            edges_.push_back({PartLink::Event::joint_connect, part.parent, no_number, no_number, p});
            co_return;
        }
        co_await each(pace_, part_count(), Cost::some_ns, [&](uint32_t q) { may_meet_[q] = q == part.parent; });
        const PartLink link = co_await connect_anyway(pace_, graph_, new_part(p), others());
        add(link);
    }

    // Its points, and those half-way between them.
    Task<void> place_outline(uint32_t p) {
        const ModelPart& part = model_.parts[p];
        const Contour& contour = part.part->outline;
        outline_.clear();
        outline_.reserve(2 * static_cast<size_t>(contour.size()));
        co_await each(pace_, contour.size(), Cost::tens_of_ns, [&](uint32_t i) {
            outline_.push_back(part.place(contour.points[i]));
            outline_.push_back(part.place(mix(contour.points[i], contour.points[contour.next(i)], 0.5)));
        });
    }

    // From the roots on.
    Task<void> direct() {
        std::pmr::vector<uint32_t> roots(pace_.memory());
        Buffer<uint32_t> root_of(part_count(), pace_.memory());  // by group
        co_await each(pace_, part_count(), Cost::some_ns, [&](uint32_t p) { root_of[p] = no_number; });
        co_await each(pace_, part_count(), Cost::tens_of_ns, [&](uint32_t p) {
            uint32_t& root = root_of[groups_.first(p)];
            if (root == no_number || p == trunk_ || (root != trunk_ && is_better_root(model_, p, root))) root = p;
        });
        roots.push_back(trunk_);
        co_await each(pace_, part_count(), Cost::tens_of_ns, [&](uint32_t p) {
            if (p != trunk_ && root_of[groups_.first(p)] == p) roots.push_back(p);
        });
        const Groups edges = co_await group_by(pace_, 2 * edges_.size(), part_count(), [&](uint32_t end) {
            return end % 2 == 0 ? edges_[end / 2].child : edges_[end / 2].parent;
        });
        earlier_ = co_await EarlierParts::find(pace_, model_);
        model_.own_joints.resize(own_end());
        model_.own_numbers.resize(own_end());
        Buffer<uint32_t> start(part_count(), pace_.memory());
        std::pmr::vector<bool> is_seen(part_count(), false, pace_.memory());
        std::pmr::vector<uint32_t> queue(pace_.memory());
        for (const uint32_t root : roots) {
            queue.push_back(root);
            is_seen[root] = true;
            start[root] = co_await nearest_own(root, middle_of(root));
        }
        for (size_t at = 0; at < queue.size(); ++at) {
            const uint32_t p = queue[at];
            co_await number(p, start[p]);
            for (const uint32_t end : edges.of(p)) co_await find_joint(edges_[end / 2], p);
            for (const uint32_t end : edges.of(p)) {
                const PartLink& edge = edges_[end / 2];
                const bool is_parent = edge.parent == p;
                const uint32_t q = is_parent ? edge.child : edge.parent;
                if (is_seen[q]) continue;
                is_seen[q] = true;
                queue.push_back(q);
                if (edge.joint == no_number) {
                    start[q] = first_own(q);
                    continue;
                }
                const uint32_t joint = is_parent ? edge.joint : edge.parent_joint;
                start[q] = joint;
                if (joint >= own_end()) start[q] = co_await nearest_own(q, graph_.joints()[joint].at);
            }
        }
        co_await set_links(queue);
        co_await label_meetings(queue);
        for (const uint32_t root : roots) out_.roots.push_back(co_await root_joint(root));
    }

    Vec3 middle_of(uint32_t p) const { return model_.parts[p].place(model_.parts[p].part->centroid); }

    uint32_t first_own(uint32_t p) const {
        uint32_t joint = first_[p];
        while (!graph_.is_there(joint)) ++joint;
        return joint;
    }

    // Of a part that is its own mirror image only what lies on the axis can be its middle.
    bool may_be_middle(uint32_t p, uint32_t joint) const {
        return !model_.parts[p].part->mirror || graph_.joints()[joint].hold != BoneGraph::Hold::none;
    }

    Task<uint32_t> nearest_own(uint32_t p, Vec3 at, bool is_middle = false) {
        uint32_t nearest = no_number;
        double least = 0;
        co_await each(pace_, first_[p], first_[p + 1], Cost::some_ns, [&](uint32_t j) {
            if (!graph_.is_there(j) || (is_middle && !may_be_middle(p, j))) return;
            const double distance = (graph_.joints()[j].at - at).norm();
            if (nearest == no_number || distance < least) nearest = j, least = distance;
        });
        co_return nearest;
    }

    // Numbers and labels of a part's own joints: along it, from one of them.
    Task<void> number(uint32_t p, uint32_t start) {
        const ModelPart& part = model_.parts[p];
        std::pmr::vector<uint32_t> way(pace_.memory()), order(pace_.memory());
        std::pmr::vector<uint32_t> before(first_[p + 1] - first_[p], no_joint_before, pace_.memory());
        std::pmr::vector<uint32_t> place(before.size(), no_joint_before, pace_.memory());
        way.push_back(start);
        Slice slice(Cost::tens_of_ns);
        while (!way.empty()) {
            const uint32_t joint = way.back();
            way.pop_back();
            place[joint - first_[p]] = static_cast<uint32_t>(order.size());
            order.push_back(joint);
            const auto ends = own_ends_.of(joint);
            for (size_t e = ends.size(); e-- > 0;) {
                const uint32_t next = neighbour_of(ends[e]);
                if (slice.is_over()) co_await pace_;
                if (place[next - first_[p]] != no_joint_before) continue;
                before[next - first_[p]] = place[joint - first_[p]];
                way.push_back(next);
            }
            if (slice.is_over()) co_await pace_;
        }
        const auto own = std::span(model_.own_joints).subspan(first_[p], order.size());
        model_.own_counts[p] = static_cast<uint32_t>(order.size());
        model_.own_begins[p] = first_[p];
        const auto numbers = std::span(model_.own_numbers).subspan(first_[p], order.size());
        co_await each(pace_, order.size(), Cost::tens_of_ns, [&](uint32_t i) {
            own[i] = {part.drawn(graph_.joints()[order[i]].at), before[order[i] - first_[p]]};
        });
        co_await number_joints(pace_, own, earlier_.of(part), same_joint * part.part->length, numbers);
        co_await each(pace_, order.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
            graph_.joints()[order[i]].label = add_label();
            JointLabel& label = out_.labels.back();
            char number[16] = "_";
            *std::to_chars(number + 1, number + sizeof number - 1, numbers[i]).ptr = 0;
            label.key.append(part.name).append(number).append(part.suffix);
        });
    }

    uint32_t add_label() {
        out_.labels.emplace_back(pace_.memory());
        return static_cast<uint32_t>(out_.labels.size()) - 1;
    }

    // The joint that a host hung a part on, now that its part's are numbered.
    Task<void> find_joint(PartLink& edge, uint32_t parent) {
        if (edge.parent != parent || edge.joint != no_number) co_return;
        const ModelPart& part = model_.parts[edge.child];
        uint32_t joint = no_number;
        co_await each(pace_, first_[parent], first_[parent + 1], Cost::tens_of_ns, [&](uint32_t j) {
            if (graph_.is_there(j) && std::string_view(out_.labels[graph_.joints()[j].label].key) == part.parent_joint)
                joint = j;
        });
        const NewPart child{edge.child, first_[edge.child], first_[edge.child + 1], {}};
        if (joint == no_number) {
            co_await each(pace_, part_count(), Cost::some_ns, [&](uint32_t q) { may_meet_[q] = q == parent; });
            edge = co_await connect_anyway(pace_, graph_, child, others());
            co_return;
        }
        const Vec3 at = graph_.joints()[joint].at;
        double least = 0;
        co_await each(pace_, child.first_joint, child.end_joint, Cost::some_ns, [&](uint32_t j) {
            if (!graph_.is_there(j) || !graph_.is_end(j)) return;
            const double distance = (graph_.joints()[j].at - at).norm();
            if (edge.joint == no_number || distance < least) edge.joint = j, least = distance;
        });
        edge.parent_joint = joint;
        graph_.add_bone(joint, edge.joint, no_number);
    }

    // Of each part the way towards its root; `order` has parents first.
    Task<void> set_links(std::span<const uint32_t> order) {
        Buffer<uint32_t> place(part_count(), pace_.memory());
        co_await each(pace_, order.size(), Cost::some_ns, [&](uint32_t i) { place[order[i]] = i; });
        co_await each(pace_, edges_.size(), Cost::tens_of_ns, [&](uint32_t e) {
            PartLink link = edges_[e];
            if (place[link.child] < place[link.parent]) {
                std::swap(link.child, link.parent);
                std::swap(link.joint, link.parent_joint);
            }
            out_.links[link.child] = link;
        });
    }

    // Joints that were made where parts meet.
    Task<void> label_meetings(std::span<const uint32_t> order) {
        co_await each(pace_, order.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
            const uint32_t p = order[i];
            const PartLink& link = out_.links[p];
            if (link.event == PartLink::Event::root) return;
            label_meeting(link.parent_joint, link.parent, p);
            label_meeting(link.joint, p, link.parent);
        });
    }
    void label_meeting(uint32_t joint, uint32_t part, uint32_t other) {
        if (joint < own_end()) return;
        const ModelPart &on = model_.parts[part], &with = model_.parts[other];
        uint32_t& label = graph_.joints()[joint].label;
        const bool is_first = label == no_number;
        if (is_first) label = add_label();
        std::pmr::string key(on.name, pace_.memory());
        key.append("_at_").append(with.name);
        std::pmr::string& whole = out_.labels[label].key;
        // Both of two mirror images hang there.
        const bool is_shared = !is_first && with.twin != no_number && whole.starts_with(key);
        if (!is_first && !is_shared) return;
        whole = key;
        whole.append(on.twin != no_number ? on.suffix : is_first ? with.suffix : "");
    }

    // The trunk's middle: one of its joints, or a new one on the nearest of its bones.
    Task<uint32_t> root_joint(uint32_t p) {
        const ModelPart& part = model_.parts[p];
        uint32_t root = no_number;
        if (p == trunk_ && !model_.root_joint.empty()) {
            co_await each(pace_, graph_.joints().size(), Cost::tens_of_ns, [&](uint32_t j) {
                const BoneGraph::Joint& joint = graph_.joints()[j];
                if (joint.part == p && joint.label != no_number &&
                    out_.labels[joint.label].key == std::string_view(model_.root_joint))
                    root = j;
            });
        }
        if (root == no_number) root = co_await middle_joint(p);
        BoneGraph::Joint& joint = graph_.joints()[root];
        joint.hold = BoneGraph::Hold::pinned;
        if (joint.label == no_number) {
            joint.label = add_label();
            out_.labels.back().key.append(part.name).append("_root").append(part.suffix);
        }
        co_return root;
    }

    // Joints where parts meet count: their bones go on.
    bool is_middle_bone(uint32_t p, uint32_t joint) const { return joint >= own_end() || may_be_middle(p, joint); }

    // The part's own joint at one end of a bone, which may have been split where other parts hang.
    uint32_t own_joint_at(uint32_t joint, uint32_t bone) const {
        const uint32_t part = graph_.bones()[bone].part;
        while (joint >= own_end()) {
            uint32_t end = graph_.first_end(joint);
            while (BoneGraph::bone_of(end) == bone || graph_.bones()[BoneGraph::bone_of(end)].part != part)
                end = graph_.next_end(end);
            bone = BoneGraph::bone_of(end);
            joint = graph_.other(bone, joint);
        }
        return joint;
    }

    // At the other end of an own bone.
    uint32_t neighbour_of(uint32_t end) const { return own_bones_[end / 2][1 - end % 2]; }

    // From one of a part's own joints over the next one to an end or where branches meet, as it is alone.
    uint32_t own_way(uint32_t before, uint32_t joint) const {
        for (auto ends = own_ends_.of(joint); ends.size() == 2; ends = own_ends_.of(joint)) {
            const uint32_t first = neighbour_of(ends[0]), after = first == before ? neighbour_of(ends[1]) : first;
            before = joint;
            joint = after;
        }
        return joint;
    }

    // Of a bone of a limb the joint that the limb hangs on, where that is wider.
    uint32_t wider_trunk(uint32_t bone, double radius) const {
        const auto& ends = graph_.bones()[bone].joints;
        const uint32_t a = own_joint_at(ends[0], bone), b = own_joint_at(ends[1], bone);
        for (const auto& [from, to] : {std::array{a, b}, std::array{b, a}}) {
            const uint32_t tip = own_way(from, to), trunk = own_way(to, from);
            if (own_ends_.of(tip).size() == 1 && own_ends_.of(trunk).size() > 2 &&
                graph_.joints()[trunk].radius > radius)
                return trunk;
        }
        return no_number;
    }

    Task<uint32_t> middle_joint(uint32_t p) {
        const Vec3 middle = middle_of(p);
        uint32_t bone = no_number;
        double least = 0, share = 0;
        co_await each(pace_, graph_.bones().size(), Cost::tens_of_ns, [&](uint32_t b) {
            if (graph_.bones()[b].gone || graph_.bones()[b].part != p) return;
            const auto& ends = graph_.bones()[b].joints;
            if (!is_middle_bone(p, ends[0]) || !is_middle_bone(p, ends[1])) return;
            const Vec3 from = graph_.joints()[ends[0]].at, along = graph_.joints()[ends[1]].at - from;
            const double length2 = along.squaredNorm();
            const double s = length2 > 0 ? std::clamp((middle - from).dot(along) / length2, 0.0, 1.0) : 0;
            const double distance = (from + s * along - middle).norm();
            if (bone == no_number || distance < least) bone = b, least = distance, share = s;
        });
        if (bone == no_number) {
            const uint32_t joint = co_await nearest_own(p, middle, true);
            if (joint != no_number) co_return joint;
            co_return co_await nearest_own(p, middle);
        }
        const auto ends = graph_.bones()[bone].joints;
        const BoneGraph::Joint &a = graph_.joints()[ends[0]], &b = graph_.joints()[ends[1]];
        const Vec3 at = a.at + share * (b.at - a.at);
        const double radius = std::lerp(a.radius, b.radius, share);
        const ModelPart& part = model_.parts[p];
        const double depth = co_await depth_in(pace_, part.part->outline, part.drawn(at));
        const uint32_t trunk = wider_trunk(bone, depth * part.radius_scale());
        if (trunk != no_number) co_return trunk;
        // Where other parts hang is not asked: what is in the middle must not depend on them. Between two girdles the
        // middle is on the spine.
        const uint32_t own = co_await nearest_own(p, at, true);
        const bool is_spine = graph_.is_junction(ends[0]) && graph_.is_junction(ends[1]);
        // No tip of a limb, as of a large head, swings all the rest.
        const bool is_tip = own != no_number && own_ends_.of(own).size() == 1 &&
                            own_ends_.of(neighbour_of(own_ends_.of(own)[0])).size() > 1;
        const double near = is_spine ? 0 : (is_tip ? middle_at_tip : middle_at_joint) * radius;
        if (own != no_number && (graph_.joints()[own].at - at).norm() <= std::max(collapse_, near)) co_return own;
        if (share <= 0 || share >= 1) co_return ends[share <= 0 ? 0 : 1];
        const uint32_t joint = graph_.split(bone, at, radius);
        co_return joint;
    }

    Pace& pace_;
    HeldModel& model_;
    BoneGraph& graph_;
    std::span<const uint32_t> first_;
    double collapse_;
    Hierarchy out_;
    uint32_t trunk_ = 0;
    std::pmr::vector<PartLink> edges_;  // as they were connected
    std::pmr::vector<std::array<uint32_t, 2>> own_bones_;
    Groups own_ends_;
    std::pmr::vector<WidePart> shapes_;
    std::pmr::vector<MirrorPlane> mirrors_;
    std::pmr::vector<Vec3> outline_;
    NodeClusters groups_;        // parts that hang together
    Buffer<uint8_t> is_placed_;  // by part: it has come
    Buffer<uint8_t> may_meet_;
    std::pmr::vector<PartLink> hung_;
    EarlierParts earlier_{pace_.memory()};
};

}  // namespace

Task<Hierarchy> connect_parts(Pace& pace, HeldModel& model, BoneGraph& graph, std::span<const uint32_t> first_joints,
                              double collapse) {
    Builder builder(pace, model, graph, first_joints, collapse);
    co_return co_await builder.build();
}

}  // namespace flg
