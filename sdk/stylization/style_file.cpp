// SPDX-License-Identifier: MIT
#include "stylization/style_file.h"

#include <bit>
#include <cstring>

#include "core/failure.h"
#include "core/random.h"
#include "stylization/style_file_checks.h"

namespace flg {

namespace {

static_assert(std::endian::native == std::endian::little, "style files are written as they lie in memory");

constexpr char magic[8] = {'F', 'L', 'G', 'S', 'T', 'Y', 'L', 'E'};
constexpr uint32_t version = 1;

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

void read_content(Reader& in, PreparedStyle& style, Memory* memory) {
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
    if (in.left() > 0) throw Failure(FLG_ERROR_FORMAT, "data goes on for %zu bytes behind the style", in.left());
    check_values(style);
    complete_graph(graph, style.guide->offsets(), memory);
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
    header.value(version);
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
    if (its_version != version) {
        throw Failure(FLG_ERROR_FORMAT, "data is a prepared style of format %u, this library reads format %u",
                      its_version, version);
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
    read_content(in, style, memory);
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
