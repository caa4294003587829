// SPDX-License-Identifier: MIT
// Results into the host's buffers: the points of the Thomas attractor, as packed floats and as a vertex of 24 bytes.
// What the memory alone takes is measured beside it: the same bytes, copied.
#include <cstdio>
#include <cstring>

#include "bench/groups.h"
#include "bench/host.h"
#include "filigree/filigree_buffers.h"

namespace flg::bench {
namespace {

constexpr uint32_t kPoints = 369'400;
constexpr double kPackedBar = 1.5, kVertexBarNs = 15.0;
constexpr int kBufferRuns = 25;

struct Vertex {
    float position[3];
    int16_t normal[4];
    uint8_t color[4];
};

FlgBufferColumn column_to(FlgAttribute attribute, FlgNumberFormat format, void* data, uint32_t stride) {
    FlgBufferColumn column = {};
    column.attribute = attribute;
    column.format = format;
    column.data = data;
    column.stride = stride;
    return column;
}

double ns_a_point(const std::function<void()>& write) {
    write();  // touches the pages
    return 1e6 / kPoints * median_ms(kBufferRuns, [&] { return time_ms(write); });
}

}  // namespace

std::vector<Row> run_buffers() {
    Host host;
    const FlgCurveSetView view = host.view(host.add(scenes::make_target("thomas", kPoints)));
    const std::vector<float> normals(size_t{3} * kPoints, 0.5f), colors(size_t{4} * kPoints, 0.5f);
    const FlgColumn columns[] = {view.columns[0],
                                 {FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0},
                                 {FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0}};
    std::vector<Vertex> vertices(kPoints), copy(kPoints);
    FlgBufferOutput output = flgBufferOutputDefaults();
    output.row_capacity = kPoints;
    FlgColumnsWriteDesc desc = flgColumnsWriteDefaults();
    desc.columns = columns;
    desc.column_count = 3;
    desc.row_count = kPoints;
    desc.output = &output;
    const auto copied_ns = [&](size_t bytes) {
        return ns_a_point([&] { std::memcpy(copy.data(), vertices.data(), bytes); });
    };

    const FlgBufferColumn packed = column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, vertices.data(), 0);
    output.columns = &packed;
    output.column_count = 1;
    const double packed_ns = ns_a_point([&] { check(flgColumnsWrite(&desc)); });
    const double packed_copy_ns = copied_ns(size_t{12} * kPoints);

    constexpr uint32_t stride = sizeof(Vertex);
    const FlgBufferColumn interleaved[] = {
        column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, vertices[0].position, stride),
        column_to(FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_SNORM16, vertices[0].normal, stride),
        column_to(FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_UNORM8, vertices[0].color, stride)};
    output.columns = interleaved;
    output.column_count = 3;
    const double vertex_ns = ns_a_point([&] { check(flgColumnsWrite(&desc)); });
    const double vertex_copy_ns = copied_ns(size_t{stride} * kPoints);

    char packed_note[64], vertex_note[64];
    std::snprintf(packed_note, sizeof packed_note, "%.2f ns a point", packed_ns);
    std::snprintf(vertex_note, sizeof vertex_note, "to copy its bytes takes %.2f ns", vertex_copy_ns);
    return {
        below("369,400 positions into a buffer, over memcpy", packed_ns / packed_copy_ns, "x", kPackedBar, packed_note),
        below("position, 16-bit normal, 8-bit colour, a point", vertex_ns, "ns", kVertexBarNs, vertex_note)};
}

}  // namespace flg::bench
