// SPDX-License-Identifier: MIT
// The C ABI of picking: checks, and failures as results.
#include <cmath>

#include "core/guard.h"
#include "core/host_memory.h"
#include "core/sized_struct.h"
#include "pick/pick_scene.h"

using flg::Failure;
using flg::Longer;
using flg::require;
using flg::sized;
using flg::pick::PickScene;

struct FlgPickSceneT {
    FlgPickSceneT(const FlgPickSceneDesc& desc, const FlgAllocator& allocator, const flg::Origin& origin)
        : memory(allocator), embree{desc.embree_memory, desc.user_data}, scene(desc.threads, origin, embree, &memory) {}
    flg::HostMemory memory;
    flg::pick::EmbreeMemory embree;
    PickScene scene;
};

namespace {

thread_local char last_error[512] = "no error";

FlgPickSceneDesc default_desc() {
    auto desc = sized<FlgPickSceneDesc>();
    desc.threads = 1;
    return desc;
}

template <class Body>
FlgResult guarded(Body&& body) noexcept {
    return flg::guarded(std::forward<Body>(body),
                        [] { return flg::translate_exception(last_error, sizeof last_error, "no memory is left"); });
}

// A body that has Embree take memory; where the host refuses it some, Embree may name another error.
template <class Body>
FlgResult guarded_change(FlgPickScene scene, Body&& body) noexcept {
    if (scene) scene->embree.was_refused = false;
    const FlgResult result = guarded(std::forward<Body>(body));
    if (result != FLG_ERROR_INTERNAL || !scene || !scene->embree.was_refused) return result;
    return guarded([] { throw std::bad_alloc(); });
}

FlgAllocator read_allocator(const FlgAllocator* given) {
    if (!given) return sized<FlgAllocator>();
    const FlgAllocator allocator = flg::read_struct<Longer::cut>(given, sized<FlgAllocator>(), "desc.allocator");
    if (!allocator.allocate != !allocator.free) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.allocator.%s is null, but the other function is not",
                      allocator.allocate ? "free" : "allocate");
    }
    return allocator;
}

flg::Origin read_origin(const double (&origin)[3], const char* argument) {
    for (const double value : origin) {
        if (!(std::abs(value) <= 1e30)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s holds %g, must be finite and at most 1e30 in size", argument,
                          value);
        }
    }
    return {origin[0], origin[1], origin[2]};
}

// Of places: Embree takes coordinates up to 2^60.
void check_place(const float* values, const char* name, uint32_t index) {
    for (uint32_t i = 0; i < 3; ++i) {
        if (!(std::abs(values[i]) <= flg::pick::largest_coordinate)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%u] holds %g, must be finite and at most 1e18 in size", name,
                          index, static_cast<double>(values[i]));
        }
    }
}

void check_direction(const float* direction, uint32_t index) {
    for (uint32_t i = 0; i < 3; ++i) {
        if (!std::isfinite(direction[i])) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the direction of rays[%u] holds %g, must be finite", index,
                          static_cast<double>(direction[i]));
        }
    }
    if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the direction of rays[%u] is 0", index);
    }
}

bool has_positions(const FlgColumn* columns, uint32_t count) {
    for (uint32_t i = 0; columns && i < count; ++i) {
        if (columns[i].attribute == FLG_ATTRIBUTE_POSITION) return columns[i].components == 3 && columns[i].data;
    }
    return false;
}

void check_mesh(const FlgMeshView& mesh, const uint32_t* changed, uint32_t changed_count) {
    if (!has_positions(mesh.columns, mesh.column_count)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "surface.mesh.columns has no FLG_ATTRIBUTE_POSITION");
    }
    require(mesh.triangles, "surface.mesh.triangles");
    read_origin(mesh.origin, "surface.mesh.origin");
    for (uint32_t i = 0; changed && i < changed_count; ++i) {
        if (changed[i] >= mesh.triangle_count) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "changed[%u] is %u, but there are %u triangles", i, changed[i],
                          mesh.triangle_count);
        }
    }
}

void check_curves(const FlgCurveSetView& curves, float min_radius) {
    if (!has_positions(curves.columns, curves.column_count)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "curves.columns has no FLG_ATTRIBUTE_POSITION");
    }
    require(curves.curve_offsets, "curves.curve_offsets");
    read_origin(curves.origin, "curves.origin");
    if (!(min_radius > 0 && std::isfinite(min_radius))) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "min_radius is %g, must be finite and above 0",
                      static_cast<double>(min_radius));
    }
}

void check_rays(const FlgRay* rays, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        check_place(rays[i].origin, "the origin of rays", i);
        check_direction(rays[i].direction, i);
        if (!(rays[i].nearest >= 0 && rays[i].furthest >= rays[i].nearest)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "rays[%u] goes from %g to %g, must be 0 or above and rising", i,
                          static_cast<double>(rays[i].nearest), static_cast<double>(rays[i].furthest));
        }
    }
}

}  // namespace

extern "C" {

const char* flgPickErrorGetMessage(void) {
    return last_error;
}

FlgResult flgPickSceneDescInit(FlgPickSceneDesc* desc, uint32_t struct_size) {
    return guarded([&] { flg::init_struct(desc, struct_size, default_desc(), "desc"); });
}

FlgResult flgPickSceneCreate(const FlgPickSceneDesc* desc, FlgPickScene* out_scene) {
    return guarded([&] {
        require(out_scene, "out_scene") = nullptr;
        const FlgPickSceneDesc read =
            desc ? flg::read_struct<Longer::cut>(desc, default_desc(), "desc") : default_desc();
        const flg::Origin origin = read_origin(read.origin, "desc.origin");
        const FlgAllocator allocator = read_allocator(read.allocator);
        flg::HostMemory memory(allocator);
        std::pmr::polymorphic_allocator<FlgPickSceneT> to(&memory);
        *out_scene = to.new_object<FlgPickSceneT>(read, allocator, origin);
    });
}

void flgPickSceneDestroy(FlgPickScene scene) {
    if (!scene) return;
    flg::HostMemory memory = scene->memory;
    std::pmr::polymorphic_allocator<FlgPickSceneT>(&memory).delete_object(scene);
}

FlgResult flgPickSceneSetSurface(FlgPickScene scene, uint32_t object, const FlgSurfaceView* surface,
                                 const uint32_t* changed, uint32_t changed_count) {
    return guarded_change(scene, [&] {
        FlgSurfaceView read = flg::read_struct<Longer::cut>(surface, flg::sized<FlgSurfaceView>(), "surface");
        const FlgMeshView mesh = flg::read_struct<Longer::cut>(read.mesh, flg::sized<FlgMeshView>(), "surface.mesh");
        check_mesh(mesh, changed, changed_count);
        read.mesh = &mesh;
        require(scene, "scene").scene.set_surface(object, read, changed, changed_count);
    });
}

FlgResult flgPickSceneSetCurves(FlgPickScene scene, uint32_t object, const FlgCurveSetView* curves, float min_radius) {
    return guarded_change(scene, [&] {
        const FlgCurveSetView read = flg::read_struct<Longer::cut>(curves, flg::sized<FlgCurveSetView>(), "curves");
        check_curves(read, min_radius);
        require(scene, "scene").scene.set_curves(object, read, min_radius);
    });
}

FlgResult flgPickSceneRemove(FlgPickScene scene, uint32_t object) {
    return guarded([&] { require(scene, "scene").scene.remove(object); });
}

FlgResult flgPickSceneCommit(FlgPickScene scene) {
    return guarded_change(scene, [&] { require(scene, "scene").scene.commit(); });
}

FlgResult flgPickSceneCastRays(FlgPickScene scene, const FlgRay* rays, uint32_t ray_count, FlgHit* out_hits) {
    return guarded([&] {
        require(scene, "scene");
        if (ray_count == 0) return;
        require(rays, "rays");
        require(out_hits, "out_hits");
        check_rays(rays, ray_count);
        scene->scene.pick(rays, ray_count, out_hits);
    });
}

FlgResult flgPickSceneFindNearest(FlgPickScene scene, const float point[3], float max_distance, FlgHit* out_hit) {
    return guarded([&] {
        require(scene, "scene");
        require(point, "point");
        require(out_hit, "out_hit");
        check_place(point, "point", 0);
        if (!(max_distance > 0)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "max_distance is %g, must be above 0",
                          static_cast<double>(max_distance));
        }
        *out_hit = scene->scene.nearest(flg::pick::load(point), max_distance);
    });
}

}  // extern "C"
