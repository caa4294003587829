// SPDX-License-Identifier: MIT
// A host that loads the library, works with it and unloads it, again and again: of the library nothing must be left,
// neither mappings nor threads nor files, and the process must not grow. Not linked to it: arguments are the paths of
// filigree and of what hosts may load beside it.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "filigree/filigree_surface.h"
#include "process.h"

namespace {

constexpr int rounds = 50, settled_round = 10;
constexpr long max_growth = 2 << 20;  // bytes: less than one library that stays
constexpr uint32_t across = 40;

// Function `name` of the library, as the headers declare it.
#define LOOK_UP(library, name) const auto name##_ = look_up<decltype(&name)>(library, #name)

void must(FlgResult result, const char* what) {
    if (result != FLG_OK) FAIL("%s: result %d", what, static_cast<int>(result));
}
#define MUST(call) must(call, #call)

template <class Function>
Function look_up(void* library, const char* name) {
    return reinterpret_cast<Function>(symbol(library, name));
}

// A plane with distances from its first vertex, made by workers; the farthest one.
float work(void* library) {
    LOOK_UP(library, flgContextDescInit);
    LOOK_UP(library, flgContextCreate);
    LOOK_UP(library, flgContextDestroy);
    LOOK_UP(library, flgContextWait);
    LOOK_UP(library, flgContextTick);
    LOOK_UP(library, flgErrorGetMessage);
    LOOK_UP(library, flgMeshViewInit);
    LOOK_UP(library, flgSurfaceDescInit);
    LOOK_UP(library, flgSurfaceCreate);
    LOOK_UP(library, flgFieldGeodesicDescInit);
    LOOK_UP(library, flgFieldCreateGeodesic);
    LOOK_UP(library, flgFieldGetView);
    LOOK_UP(library, flgFieldViewInit);

    float positions[across * across * 3] = {};
    uint32_t triangles[(across - 1) * (across - 1) * 6];
    uint32_t corner = 0;
    for (uint32_t i = 0; i < across * across; ++i) {
        positions[3 * i] = static_cast<float>(i % across);
        positions[3 * i + 1] = static_cast<float>(i / across);
        if (i % across == across - 1 || i / across == across - 1) continue;
        const uint32_t square[] = {i, i + 1, i + across, i + 1, i + across + 1, i + across};
        std::memcpy(triangles + corner, square, sizeof square);
        corner += 6;
    }
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions, 0, 0};

    FlgContextDesc desc;
    MUST(flgContextDescInit_(&desc, sizeof desc));
    desc.worker_count = 3;
    FlgContext context{};
    MUST(flgContextCreate_(&desc, &context));
    FlgSurfaceDesc surface_desc;
    MUST(flgSurfaceDescInit_(&surface_desc, sizeof surface_desc));
    FlgMeshView input;
    MUST(flgMeshViewInit_(&input, sizeof input));
    input.vertex_count = across * across;
    input.triangle_count = corner / 3;
    input.column_count = 1;
    input.columns = &column;
    input.triangles = triangles;
    surface_desc.mesh = &input;
    const uint32_t first = 0;
    FlgFieldGeodesicDesc geodesic;
    MUST(flgFieldGeodesicDescInit_(&geodesic, sizeof geodesic));
    MUST(flgSurfaceCreate_(context, &surface_desc, &geodesic.surface, nullptr));
    geodesic.vertices = &first;
    geodesic.vertex_count = 1;
    FlgField field{};
    MUST(flgFieldCreateGeodesic_(context, &geodesic, &field, nullptr));
    FlgFrameReport report{};
    report.struct_size = sizeof report;
    do {
        flgContextWait_(context, 10000);
        MUST(flgContextTick_(context, 0, &report));
    } while (report.jobs_pending > 0);
    FlgFieldView view;
    MUST(flgFieldViewInit_(&view, sizeof view));
    MUST(flgFieldGetView_(context, field, &view));
    const float farthest = view.values[across * across - 1];
    // A failure's sentence is kept for each thread: that must not keep the library either.
    if (flgContextTick_({}, 0, nullptr) != FLG_ERROR_INVALID_HANDLE) FAIL("a null context was not refused");
    if (std::strstr(flgErrorGetMessage_(), "context") == nullptr) FAIL("the sentence is: %s", flgErrorGetMessage_());
    MUST(flgContextDestroy_(context));
    return farthest;
}

// Libraries beside: a call or two each.
void touch(void* library, const std::string& path) {
    if (path.find("filigree_io") != path.npos) {
        const auto read = look_up<FlgResult (*)(const char*, const void*, void**)>(library, "flgCurveFileRead");
        void* file = nullptr;
        if (read("no such file.xyz", nullptr, &file) != FLG_ERROR_FILE) FAIL("a missing file was read");
    } else {
        const float farthest = work(library);
        if (farthest < 50 || farthest > 60) FAIL("the farthest vertex is %g metres away", double{farthest});
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int threads = thread_count();
    int files = 0;
    long settled = 0;
    for (int round = 0; round < rounds; ++round) {
        for (int i = 1; i < argc; ++i) {
            const std::string path = argv[i], name = path.substr(path.find_last_of("/\\") + 1);
            void* const library = load(path);
            if (!is_loaded(name)) FAIL("%s is not mapped, so that nothing can be said", name.c_str());
            touch(library, path);
            unload(library);
            if (is_loaded(name)) FAIL("round %d: %s is still mapped", round, name.c_str());
        }
        if (round == 0) files = open_file_count();
        if (open_file_count() != files) FAIL("round %d: files were left open", round);
        if (thread_count() != threads) FAIL("round %d: threads were left", round);
        if (round == settled_round) settled = resident_bytes();
    }
    const long grown = resident_bytes() - settled;
    std::printf("%d rounds; resident memory %+ld bytes since round %d\n", rounds, grown, settled_round);
    if (grown > max_growth) FAIL("resident memory grew by %ld bytes", grown);
    return 0;
}
