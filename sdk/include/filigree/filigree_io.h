/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Filigree's file formats, in a library of its own (filigree_io) that hosts may leave out. It follows the grammar of
 * filigree.h but needs no context: its functions block on the disk, so call them where your engine loads assets.
 *
 * [any thread] All functions here; calls on one FlgCurveFile must not overlap.
 *
 * Formats, by extension:
 *   .xyz .txt     text: `x y z [radius]` a line, blank line between curves, `# closed` on the line before a closed
 *                 one; anything else behind a # is ignored. All points of a curve have a radius or none; where only
 *                 some curves do, the others get 0.005 m
 *   .obj          lines (`l`); read and written. Edges (`l a b`) that chain are joined; colours and radii are lost
 *   .gltf .glb    LINES (joined where they chain), LINE_STRIP, LINE_LOOP, with COLOR_0 and _RADIUS; .glb is written,
 *                 as lines, ribbons or tubes. No sparse accessors; buffers only embedded or below the file's folder
 *   .tilt         VR sketches, a file or a directory, read only; converted to metres and to a right-handed system
 */
#ifndef FILIGREE_FILIGREE_IO_H
#define FILIGREE_FILIGREE_IO_H

#include "filigree.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Curves read from a file, with their memory. */
typedef struct FlgCurveFileT* FlgCurveFile;

/* [any thread] As flgLastError, for the functions of this header. Sentences start with FILE:PLACE, where PLACE is a line
 * number, a byte offset (`@1234`), a part of the file's structure or an argument; with FILE alone when the file as a
 * whole is meant, as when it can't be opened. */
FLG_API const char* flgIoLastError(void);

/* Reads all curves of a file. The file is read whole, checked, and refused at the first thing that can't be right; what
 * is merely odd becomes a warning (flgCurveFileGetInfo). Limits: 2 GiB a file (unpacked too), 2^31 points.
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT. */
FLG_API FlgResult flgCurveFileRead(const char* path, FlgCurveFile* out_file);

/* The curves, ready for flgCurveSetCreate; lives until the file is released. */
FLG_API FlgResult flgCurveFileGetView(FlgCurveFile file, FlgCurveSetView* out_view);

typedef struct FlgCurveFileInfo {
    uint32_t struct_size;
    uint32_t curve_count;
    uint64_t point_count;
    const char* format;           /* "tilt", "xyz", "obj", "gltf" */
    const char* units;            /* of the file, before conversion: "decimetres, left-handed", "metres", "as given" */
    float box_min[3], box_max[3]; /* of the positions, metres */
    float total_length;           /* of all curves as polylines, metres */
    uint32_t warning_count;
    uint32_t reserved;
    const char* const* warnings;  /* sentences; live until the file is released */
} FlgCurveFileInfo;

FLG_API FlgResult flgCurveFileGetInfo(FlgCurveFile file, FlgCurveFileInfo* out_info);

/* What a .tilt file says of one stroke besides its points. */
typedef struct FlgStroke {
    char brush[40];      /* the brush's name where known, else its GUID */
    float size;          /* width at full pressure, metres */
    uint32_t group;      /* selection group, 0 = none */
    uint32_t flags;      /* as stored: 2 = continues the undo group of the stroke before it */
    uint64_t start_ms;   /* time stamp of its first point, milliseconds of sketching time */
} FlgStroke;

/* One a curve, for .tilt files; null and 0 for other formats. */
FLG_API FlgResult flgCurveFileGetStrokes(FlgCurveFile file, const FlgStroke** out_strokes, uint32_t* out_count);

/* Null is allowed. */
FLG_API void flgCurveFileRelease(FlgCurveFile file);

typedef enum FlgGeometry {
    FLG_GEOMETRY_LINES = 0,
    FLG_GEOMETRY_RIBBON = 1, /* flat, across the frame's second normal */
    FLG_GEOMETRY_TUBE = 2,
    FLG_GEOMETRY_FORCE_32BIT = 0x7fffffff
} FlgGeometry;

typedef struct FlgCurveWriteDesc {
    uint32_t struct_size;
    FlgGeometry geometry;   /* of .glb; the text formats hold lines. Default FLG_GEOMETRY_LINES */
    float default_radius;   /* metres, > 0, for curves without a RADIUS column. Default 0.005 */
    uint32_t tube_sides;    /* 3 to 64. Default 8 */
} FlgCurveWriteDesc;

FLG_API FlgResult flgCurveWriteDescInit(FlgCurveWriteDesc* desc, uint32_t struct_size);

/* Writes curves to .xyz, .obj or .glb, whole or not at all: a temporary file beside it is renamed when complete.
 * `desc` may be null. Curves without NORMAL column get frames by double reflection. Colours go into .glb, clamped to
 * 0 to 1. Lines of one point are written with their point twice; ribbons and tubes leave out curves without length.
 * Errors: FLG_ERROR_INVALID_ARGUMENT (also for no curves at all), FLG_ERROR_FORMAT for another extension, FLG_ERROR_FILE,
 * FLG_ERROR_LIMIT (2 GiB). */
FLG_API FlgResult flgCurveFileWrite(const char* path, const FlgCurveSetView* view, const FlgCurveWriteDesc* desc);

#ifdef __cplusplus
}
#endif

#endif
