// SPDX-License-Identifier: MIT
// Results into the host's buffers: columns and sizes checked whole before anything is written.
#include <algorithm>

#include "api/columns.h"
#include "api/descriptors.h"
#include "api/host_buffers.h"
#include "api/inputs.h"
#include "bones/part_body.h"
#include "bones/skin.h"
#include "buffers/buffer_writer.h"
#include "core/number_formats.h"
#include "surfaces/field.h"

namespace flg {

namespace {

constexpr uint32_t max_output_columns = 16;

FlgBufferOutput default_output() {
    auto output = sized<FlgBufferOutput>();
    output.row_count = output.triangle_count = FLG_UNLIMITED;
    output.index_format = output.region_format = FLG_NUMBER_FORMAT_UINT32;
    return output;
}

// What the host asked for, copied: its structs live for the call only.
class Request {
public:
    explicit Request(const FlgBufferOutput* output) : output_(read_struct(output, default_output(), "output")) {
        check_range(output_.column_count <= max_output_columns, "output.column_count", output_.column_count, "0 to 16");
        if (output_.column_count > 0) require(output_.columns, "output.columns");
        for (uint32_t i = 0; i < output_.column_count; ++i) {
            check_buffer_column(output_.columns, i);
            columns_[i] = output_.columns[i];
        }
        if (output_.origin) {
            double origin[3];
            std::copy(output_.origin, output_.origin + 3, origin);
            origin_ = read_origin(origin, "output.origin");
        }
        if (output_.regions) {
            const int32_t format = number_of(output_.region_format);
            if (format != FLG_NUMBER_FORMAT_UINT8)
                check_enum(output_.region_format, FLG_NUMBER_FORMAT_UINT16, FLG_NUMBER_FORMAT_UINT32,
                           "output.region_format", "FLG_NUMBER_FORMAT_UINT");
            check_aligned(output_.regions, bytes_of(format), "output.regions");
        }
        // The sizes come later.
        if (output_.indices) check_indices(output_.indices, output_.index_format, output_.index_capacity, 0, 0);
    }

    // Of arrays that sentences call `argument`; their indices are below `vertices`.
    BufferPlan plan(const ResultArrays& arrays, uint64_t vertices, const char* argument) const {
        BufferPlan plan;
        plan.first_row = output_.first_row;
        plan.row_count = part(output_.first_row, output_.row_count, arrays.rows, "row");
        plan.column_count = output_.column_count;
        for (uint32_t i = 0; i < plan.column_count; ++i) plan.columns[i] = copy_of(arrays, i, argument);
        if (plan.column_count > 0) check_capacity(output_.row_capacity, plan.row_count, "output.row_capacity");
        plan.left_handed = output_.left_handed != 0;
        plan.base_vertex = output_.base_vertex;
        if (output_.origin) {
            for (uint32_t k = 0; k < 3; ++k) {
                plan.shift[k] = arrays.origin[k] - origin_[k];
                plan.shifted |= plan.shift[k] != 0;
            }
        }
        if (output_.indices || output_.regions) add_triangles(arrays, vertices, argument, plan);
        check_apart(arrays, argument, plan);
        return plan;
    }

private:
    // How many there are of the part that was asked for.
    static uint32_t part(uint32_t first, uint32_t count, uint32_t all, const char* what) {
        if (first <= all && count == FLG_UNLIMITED) return all - first;
        if (first > all || count > all - first) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "output.first_%s is %u and output.%s_count %u, but there are %u %ss", what, first, what,
                          count, all, what);
        }
        return count;
    }
    ColumnCopy copy_of(const ResultArrays& arrays, uint32_t i, const char* argument) const {
        ColumnCopy copy{{}, columns_[i]};
        FlgBufferColumn& to = copy.to;
        const auto* const end = arrays.columns.data() + arrays.column_count;
        const auto* const found = std::find_if(arrays.columns.data(), end, [&](const ResultColumn& column) {
            return column.attribute == to.attribute && column.data;
        });
        if (found != end) {
            copy.from = *found;
        } else if (!to.optional) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "output.columns[%u].attribute is %d, of which %s has no column; `optional` would fill it", i,
                          static_cast<int>(to.attribute), argument);
        }
        if (to.components == 0) {
            const auto own = static_cast<uint32_t>(components_of(to.attribute));
            to.components = found != end ? copy.from.components : own ? own : 1;
        }
        if (is_whole(to.format) && to.components > copy.from.components) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "output.columns[%u].components is %u, but there are %u whole numbers, which can't be filled",
                          i, to.components, copy.from.components);
        }
        to.stride = checked_stride(to.stride, bytes_of(to.format), row_size(to.format, to.components),
                                   BlockName("output.columns[%u].stride", i).text);
        return copy;
    }
    void add_triangles(const ResultArrays& arrays, uint64_t vertices, const char* argument, BufferPlan& plan) const {
        const auto refuse = [&](const char* what) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "output.%s is set, but %s has none", what, argument);
        };
        if (output_.indices && !arrays.triangles) refuse("indices");
        if (output_.regions && !arrays.regions) refuse("regions");
        plan.triangle_count = part(output_.first_triangle, output_.triangle_count, arrays.triangle_count, "triangle");
        plan.indices = output_.indices;
        plan.index_format = output_.index_format;
        plan.labels = output_.regions;
        plan.label_format = output_.region_format;
        if (plan.indices) {
            plan.triangles = arrays.triangles + size_t{3} * output_.first_triangle;
            check_indices(plan.indices, plan.index_format, output_.index_capacity, uint64_t{3} * plan.triangle_count,
                          vertices == 0 ? 0 : vertices + plan.base_vertex);
        }
        if (plan.labels) {
            plan.regions = arrays.regions + output_.first_triangle;
            check_capacity(output_.region_capacity, plan.triangle_count, "output.region_capacity");
        }
    }
    static void check_apart(const ResultArrays& arrays, const char* argument, const BufferPlan& plan) {
        Blocks blocks;
        for (uint32_t i = 0; i < plan.column_count; ++i) {
            const FlgBufferColumn& to = plan.columns[i].to;
            blocks.add_output({BlockName("output.columns[%u]", i), to.data, to.stride,
                               row_size(to.format, to.components), plan.row_count});
        }
        const auto add_packed = [&](void* data, FlgNumberFormat format, uint64_t count, const char* name) {
            const uint32_t size = bytes_of(format);
            if (data) blocks.add_output({BlockName("%s", name), data, size, size, count});
        };
        add_packed(plan.indices, plan.index_format, uint64_t{3} * plan.triangle_count, "output.indices");
        add_packed(plan.labels, plan.label_format, plan.triangle_count, "output.regions");
        for (uint32_t c = 0; c < arrays.column_count; ++c) {
            const ResultColumn& from = arrays.columns[c];
            if (!from.data) continue;
            const uint64_t size = from.components * bytes_of(from.format);
            blocks.add_input({BlockName("%s.columns[%u]", argument, c), from.data, from.stride, size, arrays.rows});
        }
        constexpr uint64_t word = sizeof(uint32_t);
        const uint64_t corners = uint64_t{3} * arrays.triangle_count;
        if (arrays.triangles)
            blocks.add_input({BlockName("%s.triangles", argument), arrays.triangles, word, word, corners});
        if (arrays.regions)
            blocks.add_input({BlockName("%s.regions", argument), arrays.regions, word, word, arrays.triangle_count});
        blocks.check_apart();
    }

    FlgBufferOutput output_;
    std::array<FlgBufferColumn, max_output_columns> columns_;
    Origin origin_{};
};

// The arrays of results, once they are made; not as views, which the host sees later.

ResultArrays arrays_of(const CurveSet& set) {
    ResultArrays arrays;
    for (const Column& column : set.columns()) arrays.add(column.attribute, column.components, column.values.data());
    arrays.rows = set.point_count();
    arrays.origin = set.origin;
    return arrays;
}

ResultArrays arrays_of(const Surface& surface) {
    const Mesh& mesh = surface.mesh();
    ResultArrays arrays;
    arrays.add(FLG_ATTRIBUTE_POSITION, 3, mesh.positions.data()->data());
    for (size_t c = 0; c < surface.attributes.size(); ++c)
        arrays.add(surface.attributes[c], surface.columns[c].components, surface.columns[c].values.data());
    arrays.rows = mesh.vertex_count();
    arrays.triangle_count = mesh.triangle_count();
    arrays.triangles = mesh.triangles.data()->data();
    arrays.regions = mesh.regions.data();
    arrays.origin = surface.origin;
    return arrays;
}

ResultArrays arrays_of(const Field& field) {
    ResultArrays arrays;
    arrays.add(FLG_ATTRIBUTE_VALUE, 1, field.data.distances.data());
    arrays.add(FLG_ATTRIBUTE_LABEL, 1, field.data.labels.data());
    arrays.rows = static_cast<uint32_t>(field.data.distances.size());
    return arrays;
}

ResultArrays arrays_of(const HeldSkin& skin) {
    ResultArrays arrays;
    arrays.add(FLG_ATTRIBUTE_POSITION, 3, skin.positions());
    arrays.add(FLG_ATTRIBUTE_NORMAL, 3, skin.normals());
    arrays.add(FLG_ATTRIBUTE_JOINTS, 4, skin.weights.joints.data()->data());
    arrays.add(FLG_ATTRIBUTE_WEIGHTS, 4, skin.weights.weights.data()->data());
    arrays.add(FLG_ATTRIBUTE_PART, 1, skin.mesh.parts.data());
    arrays.rows = static_cast<uint32_t>(skin.mesh.positions.size());
    arrays.triangle_count = static_cast<uint32_t>(skin.mesh.triangles.size());
    arrays.triangles = skin.mesh.triangles.data()->data();
    arrays.origin = skin.origin;
    return arrays;
}

ResultArrays arrays_of(const HeldPartMesh& mesh) {
    ResultArrays arrays;
    arrays.add(FLG_ATTRIBUTE_POSITION, 3, mesh.positions());
    arrays.rows = static_cast<uint32_t>(mesh.surface.positions.size());
    arrays.triangle_count = static_cast<uint32_t>(mesh.surface.triangles.size());
    arrays.triangles = mesh.surface.triangles.data()->data();
    return arrays;
}

template <class Result>
Task<void> write_result(Pace& pace, std::shared_ptr<const Result> result, Request request, const char* argument) {
    const ResultArrays arrays = arrays_of(*result);
    const BufferPlan plan = request.plan(arrays, arrays.rows, argument);
    co_await write_buffers(pace, plan);
}

void read(Submission& submission, const std::shared_ptr<Surface>& surface, const char* argument) {
    submission.read_surface(surface, argument);
}
template <class Result>
void read(Submission& submission, const std::shared_ptr<Result>& result, const char* argument) {
    submission.read(*result, argument);
}

bool at_rest(const Surface& surface) {
    return surface.visible_result() == FLG_OK && !surface.order.is_changing();
}
// Partial results can be seen before their job is done.
bool at_rest(const Product& product) {
    const std::shared_ptr<Job> producer = product.producer.lock();
    return product.visible_result() == FLG_OK && (!producer || producer->status.result != FLG_NOT_READY);
}

// The whole of an entry point that starts a job.
template <class Result>
FlgResult start_writing(FlgContext context, HandleTable<Result> Context::*table, uint64_t id, const char* argument,
                        const FlgBufferOutput* output, const FlgJobOptions* job, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const auto result = (self.*table).get(id, argument);
        const Request request(output);
        if (at_rest(*result)) {
            const ResultArrays arrays = arrays_of(*result);
            request.plan(arrays, arrays.rows, argument);
        }
        Submission submission(self, job);
        read(submission, result, argument);
        submission.job().strand.start(write_result<Result>(submission.pace(), result, request, argument));
        submission.commit(nullptr, MemoryKind::scratch, out_job);
    });
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgBufferOutputInit(FlgBufferOutput* output, uint32_t struct_size) {
    return init(output, struct_size, default_output(), "output");
}

FlgResult flgColumnsWriteDescInit(FlgColumnsWriteDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgColumnsWriteDesc>());
}

FlgResult flgColumnsWrite(const FlgColumnsWriteDesc* desc) {
    return guarded([&] {
        const FlgColumnsWriteDesc read = read_struct(desc, sized<FlgColumnsWriteDesc>(), "desc");
        check_columns(read.columns, read.column_count, "desc", ColumnsOf::any);
        const Request request(read.output);
        ResultArrays arrays;
        for (uint32_t c = 0; c < read.column_count; ++c) {
            const FlgColumn& column = read.columns[c];
            arrays.add(column.attribute, column.components, column.data);
            if (column.stride) arrays.columns[c].stride = column.stride;
        }
        arrays.rows = read.row_count;
        arrays.origin = read_origin(read.origin, "desc.origin");
        write_buffers(request.plan(arrays, 0, "desc"));
    });
}

FlgResult flgIndicesWrite(const uint32_t* indices, uint32_t index_count, const FlgBufferOutput* output) {
    return guarded([&] {
        require(indices, "indices");
        check_range(index_count % 3 == 0, "index_count", index_count, "a multiple of 3");
        const Request request(output);
        ResultArrays arrays;
        arrays.triangles = indices;
        arrays.triangle_count = index_count / 3;
        uint32_t largest = 0;
        for (uint32_t i = 0; i < index_count; ++i) largest = std::max(largest, indices[i]);
        write_buffers(request.plan(arrays, uint64_t{largest} + 1, "indices"));
    });
}

FlgResult flgCurveSetWrite(FlgContext context, FlgCurveSet curves, const FlgBufferOutput* output,
                           const FlgJobOptions* job, FlgJob* out_job) {
    return start_writing(context, &Context::curve_sets, curves.id, "curves", output, job, out_job);
}

FlgResult flgSurfaceWrite(FlgContext context, FlgSurface surface, const FlgBufferOutput* output,
                          const FlgJobOptions* job, FlgJob* out_job) {
    return start_writing(context, &Context::surfaces, surface.id, "surface", output, job, out_job);
}

FlgResult flgFieldWrite(FlgContext context, FlgField field, const FlgBufferOutput* output, const FlgJobOptions* job,
                        FlgJob* out_job) {
    return start_writing(context, &Context::fields, field.id, "field", output, job, out_job);
}

FlgResult flgSkinWrite(FlgContext context, FlgSkin skin, const FlgBufferOutput* output, const FlgJobOptions* job,
                       FlgJob* out_job) {
    return start_writing(context, &Context::skins, skin.id, "skin", output, job, out_job);
}

FlgResult flgPartMeshWrite(FlgContext context, FlgPartMesh mesh, const FlgBufferOutput* output,
                           const FlgJobOptions* job, FlgJob* out_job) {
    return start_writing(context, &Context::part_meshes, mesh.id, "mesh", output, job, out_job);
}

}  // extern "C"
