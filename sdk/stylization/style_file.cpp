// SPDX-License-Identifier: MIT
#include "stylization/style_file.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/failure.h"
#include "core/random.h"
#include "stylization/prepare_style.h"

namespace flg {

namespace {

// ---- What loaded styles must fulfil before any job may use them. Each check throws FLG_ERROR_FORMAT.

// The counts that all else is sized by.
struct StyleCounts {
    uint32_t nodes = 0, curves = 0, patch = 0, jumps = 0, attributes = 0, flow_steps = 0;
};

constexpr uint32_t patch_max = 1024;

// Coordinates of curve sets are at most 1e30; displacements are differences of them.
constexpr double coordinate_max = 1e30;
constexpr double displacement_max = 1e31;
constexpr double unit_tolerance = 1e-3;

[[noreturn]] void refuse(const char* what) {
    throw Failure(FLG_ERROR_FORMAT, "data holds no usable style: %s", what);
}

void require_that(bool holds, const char* what) {
    if (!holds) refuse(what);
}

template <class Values>
bool all_at_most(const Values& values, double bound) {
    for (const auto value : values) {
        if (!(std::abs(static_cast<double>(value)) <= bound)) return false;
    }
    return true;
}

bool all_units(const Buffer<float>& vectors) {
    for (size_t i = 0; i < vectors.size(); i += 3) {
        if (!(std::abs(load_vec3(vectors.data() + i).norm() - 1) <= unit_tolerance)) return false;
    }
    return true;
}

uint32_t components_of(FlgAttribute attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_COLOR: return 4;
        case FLG_ATTRIBUTE_RADII: return 3;
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_ANGLE:
        case FLG_ATTRIBUTE_WIDTH:
        case FLG_ATTRIBUTE_SPEED: return 1;
        default: return 0;
    }
}

bool finite_and_not_below(double value, double least) {
    return std::isfinite(value) && value >= least;
}

// What a node is to the graph.
enum class Role : uint8_t { none, centre, last_centre };

void check_counts(const StyleCounts& counts) {
    require_that(counts.curves >= 1 && counts.curves <= style_curves_max, "its number of curves is out of range");
    require_that(counts.nodes >= 2 * counts.curves && counts.nodes <= style_points_max,
                 "its number of points is out of range");
    require_that(counts.patch >= 1 && counts.patch <= patch_max, "its patch size is out of range");
    require_that(counts.jumps <= counts.nodes * (successors_kept + counts.curves), "it has too many jumps");
    require_that(counts.attributes <= style_attributes_max, "it has too many attributes");
}

// From 0, at least two points a curve, `nodes` in the end.
void check_offsets(const Buffer<uint32_t>& offsets, uint32_t nodes) {
    bool good = offsets[0] == 0 && offsets[offsets.size() - 1] == nodes;
    for (size_t c = 0; good && c + 1 < offsets.size(); ++c) {
        good = offsets[c] <= nodes && offsets[c + 1] <= nodes && offsets[c + 1] >= offsets[c] + 2;
    }
    require_that(good, "its curves do not follow one another");
}

// All numbers but the graph's; guide and matching curve by curve.
void check_values(const PreparedStyle& style) {
    require_that(std::isfinite(style.guide_length) && style.guide_length > 0, "its guide has no length");
    require_that(std::isfinite(style.style_length) && style.style_length > 0, "its style curve has no length");
    require_that(finite_and_not_below(style.displacement_rms, 0) && finite_and_not_below(style.matching_energy, 0),
                 "its displacement or energy is no size");
    require_that(finite_and_not_below(style.graph.temperature_unit, 0), "its temperature unit is no size");
    const auto& columns = style.guide->columns();
    require_that(all_at_most(columns[0].values, coordinate_max), "a position is out of range");
    require_that(all_units(columns[1].values) && all_units(columns[2].values), "a frame is not of unit vectors");
    const Displacement& d = style.displacement;
    require_that(all_at_most(d.along_tangent, displacement_max) && all_at_most(d.along_normal, displacement_max) &&
                     all_at_most(d.along_binormal, displacement_max),
                 "a displacement is out of range");
    const Buffer<uint32_t>& offsets = style.guide->offsets();
    for (uint32_t c = 0; c < style.guide->curve_count(); ++c) {
        double before = 0;
        for (uint32_t i = offsets[c]; i < offsets[c + 1]; ++i) {
            require_that(finite_and_not_below(style.matching[i], before), "its matching runs backwards");
            before = style.matching[i];
        }
    }
}

// An attribute's kind and metric are ones that there are.
void check_attribute(const PreparedStyle& style, size_t index) {
    const StyleAttribute& attribute = style.attributes[index];
    const FlgAttribute kind = attribute.attribute;
    const uint32_t components = components_of(kind);
    require_that(attribute.components >= 1 && attribute.components <= attribute_components_max &&
                     (components == 0 || attribute.components == components),
                 "an attribute has a wrong number of components");
    require_that(metric_fits(kind, attribute.components, attribute.metric), "an attribute's metric does not fit it");
    require_that(finite_and_not_below(attribute.weight, 0), "an attribute's weight is out of range");
    for (size_t before = 0; before < index; ++before) {
        require_that(style.attributes[before].attribute != kind, "an attribute occurs twice");
    }
    for (size_t i = 0; i < attribute.values.size(); ++i) {
        const float value = attribute.values[i];
        const bool size = kind == FLG_ATTRIBUTE_RADIUS || kind == FLG_ATTRIBUTE_WIDTH ||
                          (kind == FLG_ATTRIBUTE_RADII && i % attribute.components < 2);
        require_that(std::isfinite(value) && (!size || value >= 0) && (kind != FLG_ATTRIBUTE_SPEED || value > 0),
                     "an attribute's value is out of range");
    }
}

// Fills in what follows from the jumps, the curves and the patch, and checks the jumps: sorted, between centres of
// patches, and every destination within reach.
void complete_graph(PatchGraph& graph, const Buffer<uint32_t>& offsets, Memory* memory) {
    const uint32_t nodes = graph.node_count;
    require_that(graph.start_cap < offsets[1] && graph.end_cap < nodes - offsets[offsets.size() - 2],
                 "its caps are longer than its curves");
    const StyleScene scene{.displacement = nullptr,
                           .boundaries = {offsets.data(), offsets.size()},
                           .patch = graph.patch,
                           .sizes = {},
                           .channels = {},
                           .start_cap = graph.start_cap,
                           .end_cap = graph.end_cap};
    std::pmr::vector<Role> roles(nodes, Role::none, memory);
    uint32_t last_centres = 0, destinations = 0;
    for (uint32_t c = 0; c < scene.curve_count(); ++c) {
        const uint32_t first = scene.first_patch(c), end = scene.end_patch(c);
        if (end == first) continue;
        for (uint32_t i = first; i < end; ++i) roles[i] = Role::centre;
        roles[end - 1] = Role::last_centre;
        ++last_centres;
        destinations += end - first - 1;
    }
    require_that(destinations > 0, "no curve is long enough for its patch size");
    graph.curve_end = Buffer<uint32_t>(nodes, memory);
    graph.destinations = Buffer<uint16_t>(destinations, memory);
    destinations = 0;
    require_that(graph.in_begin[0] == 0 && graph.in_begin[nodes] == graph.jump_count(), "its jumps are not in order");
    for (uint32_t c = 0, j = 0; j < nodes; ++j) {
        if (j == offsets[c + 1]) ++c;
        graph.curve_end[j] = offsets[c + 1];
        const uint32_t begin = graph.in_begin[j], end = graph.in_begin[j + 1];
        require_that(begin <= end && end <= graph.jump_count(), "its jumps are not in order");
        const bool destination = j > scene.first_patch(c) && j < scene.end_patch(c);
        if (destination) graph.destinations[destinations++] = static_cast<uint16_t>(j);
        uint32_t from_last = 0;
        for (uint32_t k = begin; k < end; ++k) {
            const uint32_t source = graph.in_source[k];
            require_that(destination && source < nodes && roles[source] != Role::none && source + 1 != j &&
                             (k == begin || source > graph.in_source[k - 1]),
                         "a jump leads where none may");
            require_that(graph.in_cost[k] >= 0 && graph.in_cost[k] <= PatchGraph::cost_max,
                         "a jump's cost is out of range");
            if (roles[source] == Role::last_centre) ++from_last;
        }
        require_that(!destination || from_last == last_centres, "a destination is out of reach");
    }
}

static_assert(std::endian::native == std::endian::little, "style files are written as they lie in memory");

constexpr char magic[8] = {'F', 'L', 'G', 'S', 'T', 'Y', 'L', 'E'};
constexpr uint32_t version = 1;
constexpr uint32_t version_with_caps = 2;  // the same, with the caps' points at its end

// Puts values one after the other; without memory to put them in, counts.
class Writer {
public:
    explicit Writer(std::byte* out) : out_(out) {}

    template <class T>
    void value(const T& value) {
        bytes(&value, sizeof value);
    }
    template <class T>
    void array(const Buffer<T>& values) {
        bytes(values.data(), values.size() * sizeof(T));
    }
    size_t size() const { return size_; }

private:
    void bytes(const void* data, size_t size) {
        if (out_ && size > 0) std::memcpy(out_ + size_, data, size);
        size_ += size;
    }

    std::byte* out_;
    size_t size_ = 0;
};

// Takes them again; takes memory for arrays only once their bytes are known to be there.
class Reader {
public:
    Reader(std::span<const std::byte> data, Memory* memory) : data_(data), memory_(memory) {}

    template <class T>
    void value(T& value) {
        bytes(&value, sizeof value);
    }
    template <class T>
    T value() {
        T result;
        bytes(&result, sizeof result);
        return result;
    }
    template <class T>
    Buffer<T> array(size_t count) {
        check_left(count * sizeof(T));
        Buffer<T> values(count, memory_);
        bytes(values.data(), count * sizeof(T));
        return values;
    }
    void check_left(size_t size) const {
        if (size > data_.size()) throw Failure(FLG_ERROR_FORMAT, "data ends within the style's arrays");
    }
    size_t left() const { return data_.size(); }

private:
    void bytes(void* out, size_t size) {
        check_left(size);
        if (size > 0) std::memcpy(out, data_.data(), size);
        data_ = data_.subspan(size);
    }

    std::span<const std::byte> data_;
    Memory* memory_;
};

void write_content(const PreparedStyle& style, Writer& out) {
    const PatchGraph& graph = style.graph;
    out.value(StyleCounts{.nodes = style.point_count(),
                          .curves = style.guide->curve_count(),
                          .patch = graph.patch,
                          .jumps = graph.jump_count(),
                          .attributes = static_cast<uint32_t>(style.attributes.size()),
                          .flow_steps = style.flow_steps});
    out.value(style.style_length);
    out.value(style.guide_length);
    out.value(style.displacement_rms);
    out.value(style.matching_energy);
    out.array(style.guide->offsets());
    for (const Column& column : style.guide->columns()) out.array(column.values);
    out.array(style.displacement.along_tangent);
    out.array(style.displacement.along_normal);
    out.array(style.displacement.along_binormal);
    out.array(style.matching);
    for (const StyleAttribute& attribute : style.attributes) {
        out.value(static_cast<int32_t>(attribute.attribute));
        out.value(attribute.components);
        out.value(static_cast<int32_t>(attribute.metric));
        out.value(attribute.weight);
        out.array(attribute.values);
    }
    out.value(graph.temperature_unit);
    out.array(graph.in_begin);
    out.array(graph.in_source);
    out.array(graph.in_cost);
    if (graph.caps() == 0) return;
    out.value(graph.start_cap);
    out.value(graph.end_cap);
}

std::shared_ptr<CurveSet> read_guide(Reader& in, const StyleCounts& counts, Memory* memory) {
    auto guide = std::allocate_shared<CurveSet>(std::pmr::polymorphic_allocator<CurveSet>(memory), memory);
    Buffer<uint32_t> offsets = in.array<uint32_t>(size_t{counts.curves} + 1);
    check_offsets(offsets, counts.nodes);
    in.check_left(size_t{counts.nodes} * 3 * 3 * sizeof(float));
    guide->allocate_curves(counts.curves);
    guide->offsets() = std::move(offsets);
    for (uint32_t c = 0; c < counts.curves; ++c) guide->begin_curve(c, 0);
    guide->allocate_columns(std::pmr::vector<CurveSet::ColumnLayout>(
        {{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TANGENT, 3}, {FLG_ATTRIBUTE_NORMAL, 3}}, memory));
    for (Column& column : guide->columns()) {
        // The set's view shows the memory that it took for the column.
        const Buffer<float> values = in.array<float>(column.values.size());
        std::memcpy(column.values.data(), values.data(), values.size() * sizeof(float));
    }
    return guide;
}

void read_attribute(Reader& in, uint32_t nodes, PreparedStyle& style) {
    StyleAttribute& attribute = style.attributes.emplace_back();
    const auto kind = in.value<int32_t>();
    in.value(attribute.components);
    const auto metric = in.value<int32_t>();
    if (!can_transfer(kind) || metric < FLG_METRIC_EUCLIDEAN || metric > FLG_METRIC_PROJECTIVE ||
        attribute.components > attribute_components_max) {
        throw Failure(FLG_ERROR_FORMAT, "data holds no usable style: attribute %d with metric %d and %u components",
                      kind, metric, attribute.components);
    }
    attribute.attribute = static_cast<FlgAttribute>(kind);
    attribute.metric = static_cast<FlgMetric>(metric);
    in.value(attribute.weight);
    attribute.values = in.array<float>(size_t{nodes} * attribute.components);
    check_attribute(style, style.attributes.size() - 1);
    for (uint32_t node = 0; node < nodes; ++node) attribute.extend_ranges(node);
}

void read_content(Reader& in, bool has_caps, PreparedStyle& style, Memory* memory) {
    const auto counts = in.value<StyleCounts>();
    check_counts(counts);
    style.flow_steps = counts.flow_steps;
    in.value(style.style_length);
    in.value(style.guide_length);
    in.value(style.displacement_rms);
    in.value(style.matching_energy);
    style.guide = read_guide(in, counts, memory);
    style.displacement.along_tangent = in.array<double>(counts.nodes);
    style.displacement.along_normal = in.array<double>(counts.nodes);
    style.displacement.along_binormal = in.array<double>(counts.nodes);
    style.matching = in.array<float>(counts.nodes);
    style.attributes.reserve(counts.attributes);
    for (uint32_t a = 0; a < counts.attributes; ++a) read_attribute(in, counts.nodes, style);
    PatchGraph& graph = style.graph;
    graph.node_count = counts.nodes;
    graph.curve_count = counts.curves;
    graph.patch = counts.patch;
    in.value(graph.temperature_unit);
    graph.in_begin = in.array<uint32_t>(size_t{counts.nodes} + 1);
    graph.in_source = in.array<uint16_t>(counts.jumps);
    graph.in_cost = in.array<float>(counts.jumps);
    if (has_caps) {
        in.value(graph.start_cap);
        in.value(graph.end_cap);
    }
    if (in.left() > 0) throw Failure(FLG_ERROR_FORMAT, "data goes on for %zu bytes behind the style", in.left());
    check_values(style);
    complete_graph(graph, style.guide->offsets(), memory);
    double sum = 0;
    for (uint32_t point = 0; point < style.point_count(); ++point) sum += style.squared_bend(point);
    style.bend = std::sqrt(sum / style.point_count());
}

}  // namespace

size_t style_file_size(const PreparedStyle& style) {
    Writer counter(nullptr);
    write_content(style, counter);
    return style_file_content_offset + counter.size();
}

void write_style_file(const PreparedStyle& style, std::span<std::byte> out) {
    Writer content(out.data() + style_file_content_offset);
    write_content(style, content);
    Writer header(out.data());
    header.value(magic);
    header.value(style.graph.caps() == 0 ? version : version_with_caps);
    header.value(uint32_t{0});
    header.value(static_cast<uint64_t>(out.size()));
    header.value(style_file_hash(out.subspan(style_file_content_offset)));
}

void read_style_file(std::span<const std::byte> data, PreparedStyle& style, Memory* memory) {
    if (data.size() < style_file_content_offset || std::memcmp(data.data(), magic, sizeof magic) != 0) {
        throw Failure(FLG_ERROR_FORMAT, "data is no prepared style: it does not begin as one");
    }
    Reader in(data.subspan(sizeof magic), memory);
    const auto its_version = in.value<uint32_t>();
    if (its_version != version && its_version != version_with_caps) {
        throw Failure(FLG_ERROR_FORMAT, "data is a prepared style of format %u, this library reads formats %u and %u",
                      its_version, version, version_with_caps);
    }
    const auto reserved = in.value<uint32_t>();
    const auto size = in.value<uint64_t>();
    if (reserved != 0 || size != data.size()) {
        throw Failure(FLG_ERROR_FORMAT, "data has %zu bytes, the style has %llu", data.size(),
                      static_cast<unsigned long long>(size));
    }
    if (in.value<uint64_t>() != style_file_hash(data.subspan(style_file_content_offset))) {
        throw Failure(FLG_ERROR_FORMAT, "data is damaged: its hash does not fit");
    }
    read_content(in, its_version == version_with_caps, style, memory);
}

// Eight bytes at a time through SplitMix64's finalizer, a bijection: any single change of up to eight bytes shows.
uint64_t style_file_hash(std::span<const std::byte> content) {
    uint64_t hash = mix64(content.size());
    while (!content.empty()) {
        uint64_t word = 0;
        const size_t size = std::min(content.size(), sizeof word);
        std::memcpy(&word, content.data(), size);
        hash = mix64(hash ^ word);
        content = content.subspan(size);
    }
    return hash;
}

}  // namespace flg
