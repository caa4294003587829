/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Filigree's file formats, in a library of its own (filigree_io) that hosts may leave out. It follows the grammar of
 * filigree.h but needs no context: its functions block on the disk, so call them where your engine loads assets.
 *
 * [any thread] All functions here; calls on one FlgCurveFile, FlgMeshFile or FlgSkinFile must not overlap.
 *
 * Formats of curves, by extension:
 *   .xyz .txt     text: `x y z [radius]` a line, blank line between curves, `# closed` on the line before a closed
 *                 one; anything else behind a # is ignored. All points of a curve have a radius or none; where only
 *                 some curves do, the others get 0.005 m. A line `# columns x y z NAME ...` before the first point names
 *                 what all lines hold instead, each number by a name of the list below
 *   .obj          lines (`l`); read and written. Edges (`l a b`) that chain are joined; colours and radii are lost
 *   .gltf .glb    LINES (joined where they chain), LINE_STRIP, LINE_LOOP, with COLOR_0 and _RADIUS, and with NORMAL,
 *                 _TIME, _PRESSURE, _STYLE_INDEX, _RADII, _ANGLE, _WIDTH, _SPEED, _DISPLACEMENT and _USERN (1 to 4 floats)
 *                 where all curves have them; lengths, speeds and directions go with their nodes. .glb is written, as
 *                 lines, ribbons or tubes. No sparse accessors; buffers only embedded or below the file's folder
 *   .tilt         VR sketches, a file or a directory, read only; converted to metres and to a right-handed system
 *   .svg          shapes' and paths' outlines, read only; y upwards, a metre a px, curves flattened to 1/1000 of their size
 * Formats of meshes, by extension; read and written, .gltf only read:
 *   .ply          ascii and binary are read, little-endian binary is written. Vertices: positions, colours (0 to 1 if
 *                 they are integers), normals and the columns this library writes, by the names below. Faces: the list
 *                 vertex_indices, and integer properties, of which `region` is the view's regions; or `tristrips`.
 *                 Other elements and properties are passed over
 *   .obj          faces (`f`) and positions with colours (`v x y z r g b`). Regions are materials (`usemtl`), numbered
 *                 from 0 in the order of first use, and written as such. Texture coordinates and normals are passed over
 *   .off          also COFF, NOFF and CNOFF; colours (0 to 255 if one is above 1) but no regions
 *   .gltf .glb    TRIANGLES, TRIANGLE_STRIP and TRIANGLE_FAN with COLOR_0, placed by the scene's nodes; regions are
 *                 materials, numbered from 0 in the order of first use; their factors are read, textures passed over.
 *                 .glb is written. Limits as for curves
 * Columns have these names in .ply and .xyz: x y z; nx ny nz; red green blue alpha; radius, time, pressure,
 * style_index, angle, width, speed; tangent_0 to _2, orientation_0 to _3, radii_0 to _2, displacement_0 to _2;
 * FLG_ATTRIBUTE_USER + N: userN, or userN_0, userN_1, ... of several components. Of meshes the other formats hold
 * positions, colours (not above 1 in .glb) and, in .glb, normals.
 */
#ifndef FILIGREE_FILIGREE_IO_H
#define FILIGREE_FILIGREE_IO_H

#include "filigree.h"
#include "filigree_model.h"
#include "filigree_surface.h"
#include "filigree_tangle.h"

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
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT. Cost: 0.1 to 0.2 us a point. */
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

/* What the file holds, and what is odd about it. Set its struct_size. */
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

/* What curves become in .glb. */
typedef enum FlgGeometry {
    FLG_GEOMETRY_LINES = 0,  /* no surface */
    FLG_GEOMETRY_RIBBON = 1, /* flat, across the frame's second normal */
    FLG_GEOMETRY_TUBE = 2,   /* round, of `tube_sides` sides */
    FLG_GEOMETRY_FORCE_32BIT = 0x7fffffff
} FlgGeometry;

typedef struct FlgCurveWriteDesc {
    uint32_t struct_size;
    FlgGeometry geometry;   /* of .glb; the text formats hold lines. Default FLG_GEOMETRY_LINES */
    float default_radius;   /* metres, > 0, for curves without a RADIUS column. Default 0.005 */
    uint32_t tube_sides;    /* 3 to 64. Default 8 */
    uint32_t all_columns;   /* nonzero: .xyz and the lines of .glb hold all columns of the view (.glb but TANGENT and
                               ORIENTATION), else positions, radii and, in .glb, colours. Default 0 */
    uint32_t reserved;
} FlgCurveWriteDesc;

FLG_API FlgResult flgCurveWriteDescInit(FlgCurveWriteDesc* desc, uint32_t struct_size);

/* Writes curves to .xyz, .obj or .glb, whole or not at all: a temporary file beside it is renamed when complete.
 * `desc` may be null. Curves without NORMAL column get frames by double reflection. Colours go into .glb, clamped to
 * 0 to 1; a USER column of more than 4 floats has no place there. Lines of one point are written with their point twice; ribbons and tubes leave out curves without length.
 * Errors: FLG_ERROR_INVALID_ARGUMENT (also for no curves at all), FLG_ERROR_FORMAT for another extension, FLG_ERROR_FILE,
 * FLG_ERROR_LIMIT (2 GiB). Cost: .glb 0.1 us a point, text 0.5 to 0.8. */
FLG_API FlgResult flgCurveFileWrite(const char* path, const FlgCurveSetView* view, const FlgCurveWriteDesc* desc);

/* ---- Meshes -------------------------------------------------------------------------------------------------- */

/* A mesh read from a file, with its memory. */
typedef struct FlgMeshFileT* FlgMeshFile;

/* Reads the mesh of a file as it is stored: nothing is welded, turned or dropped, but for triangles of strips and fans
 * that name a vertex twice. Faces of more than three corners are split into triangles: convex ones as fans from their
 * first corner, others of at most 1024 corners by clipping ears. As flgCurveFileRead it refuses what can't be right
 * (indices out of range, faces of fewer than three corners, values that aren't finite, counts the file has no room for,
 * no faces at all) and warns of what is odd. Cost: one core, some 400 MB/s of binary and 250 MB/s of text (2 M triangles:
 * 0.1 s and 0.3 s). Limits: 2 GiB a file, and what is made of it.
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT. */
FLG_API FlgResult flgMeshFileRead(const char* path, FlgMeshFile* out_file);

/* The mesh; lives until the file is released. `regions` is null where the file has none. */
FLG_API FlgResult flgMeshFileGetView(FlgMeshFile file, FlgMeshView* out_view);

/* Whole numbers that belong to the triangles, by a name. */
typedef struct FlgMeshFaceColumn {
    const char* name;       /* letters, digits and _, at most 63; not `region` nor `vertex_indices` */
    const uint32_t* values; /* one a triangle */
} FlgMeshFaceColumn;

/* The integer properties of a .ply file's faces besides `region`, at most the first 16; all triangles of a face have its
 * values, negative ones 2^32 more. Null and 0 for other formats. Lives until the file is released. */
FLG_API FlgResult flgMeshFileGetFaceColumns(FlgMeshFile file, const FlgMeshFaceColumn** out_columns,
                                            uint32_t* out_count);

/* How a region looks: glTF's metallic-roughness model, and a line where it meets another. Colours are linear RGB. */
typedef struct FlgMeshMaterial {
    const char* name;       /* UTF-8, at most 255 bytes; null: `region N` */
    float color[3];         /* 0 to 1 each */
    float metallic;         /* 0 = paint, clay, wood to 1 = bare metal */
    float roughness;        /* 0 = polished to 1 = matte */
    float border_color[3];  /* of the lines to regions that come before it in the table, 0 to 1 each */
    float border_width_px;  /* of these lines, 0 to 64 pixels; 0: none */
    uint32_t reserved;
} FlgMeshMaterial;

/* The materials of a .gltf or .glb file, one a region of the view (the only one where that has no regions), if at least one
 * says a colour; else null and 0. Factors that a material leaves out are glTF's: white, metallic 1, roughness 1. Lines are
 * read from this library's files: glTF has none. Lives until the file is released. */
FLG_API FlgResult flgMeshFileGetMaterials(FlgMeshFile file, const FlgMeshMaterial** out_materials, uint32_t* out_count);

typedef struct FlgMeshFileInfo {
    uint32_t struct_size;
    uint32_t vertex_count;        /* as stored: formats that keep normals or texture with vertices repeat positions */
    uint32_t triangle_count;      /* after polygons are split */
    uint32_t region_count;        /* different labels; 1 where the file has none */
    uint64_t polygon_count;       /* faces as stored; of strips and fans their triangles */
    const char* format;           /* "ply", "obj", "off", "gltf" */
    float box_min[3], box_max[3]; /* of the positions, metres; units are taken as given */
    uint32_t warning_count;
    uint32_t reserved;
    const char* const* warnings;  /* sentences; live until the file is released */
} FlgMeshFileInfo;

/* What the file holds, and what is odd about it. Set its struct_size. */
FLG_API FlgResult flgMeshFileGetInfo(FlgMeshFile file, FlgMeshFileInfo* out_info);

/* Null is allowed. */
FLG_API void flgMeshFileRelease(FlgMeshFile file);

typedef struct FlgMeshWriteDesc {
    uint32_t struct_size;
    uint32_t face_column_count;            /* 0 to 16. Default 0 */
    const FlgMeshFaceColumn* face_columns; /* written to .ply, different names; the other formats have no place for them */
    uint32_t split_regions;                /* nonzero: a primitive and a material for each region in .glb. Default 0 */
    uint32_t material_count;               /* with split_regions: above all regions' labels. Default 0: named, without colour */
    const FlgMeshMaterial* materials;      /* those of .glb, by label; materials that no region has are left out */
} FlgMeshWriteDesc;

FLG_API FlgResult flgMeshWriteDescInit(FlgMeshWriteDesc* desc, uint32_t struct_size);

/* Writes a mesh to .ply, .obj, .off or .glb, whole or not at all as flgCurveFileWrite. `desc` may be null. .ply and .glb
 * keep every bit of positions, text has 9 digits. .glb gets normals: the column's, else the area-weighted ones.
 * Errors: FLG_ERROR_INVALID_ARGUMENT (also for no triangles, and for indices out of range), FLG_ERROR_FORMAT for
 * another extension, FLG_ERROR_FILE, FLG_ERROR_LIMIT (2 GiB). Cost: 0.2 to 0.5 us a triangle. */
FLG_API FlgResult flgMeshFileWrite(const char* path, const FlgMeshView* view, const FlgMeshWriteDesc* desc);

/* ---- Skinned models ------------------------------------------------------------------------------------------ */

/* A skin read from a .gltf or .glb file, with its animations and its memory. */
typedef struct FlgSkinFileT* FlgSkinFile;

/* Reads the skinned mesh that a file's scene shows: all nodes with a mesh and the first skin that is met; other meshes are
 * left out, with a warning. Rest is the pose of the skin's inverseBindMatrices, whatever the nodes say. Joints that are turned
 * in that pose are read as if they were not: rotations of animations are changed so that each vertex moves as it did. Keys
 * of all of an animation's channels are brought together. Joints come parents first; those below nodes that are no joints
 * hang on the nearest joint above. Weights are sorted and brought to the sum 1, of a vertex' joints the first four are read.
 * Normals that the file lacks are made. Parts are the column _PART, else the materials.
 * Refused, for no FlgSkinAnimation can say it: scaled joints, joints that an animation moves apart from their parents, roots
 * that move differently, keys that are not LINEAR; and what can't be right: joints or weights missing, out of range, not
 * finite, nodes in circles, counts that don't fit.
 * If the scene shows no skin the result is FLG_OK and `out_file` null. Cost: one core, about 0.4 us a vertex.
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT (2 GiB a file and what is made of it; 65535 joints). */
FLG_API FlgResult flgSkinFileRead(const char* path, FlgSkinFile* out_file);

/* The skin; lives until the file is released. */
FLG_API FlgResult flgSkinFileGetView(FlgSkinFile file, FlgSkinView* out_view);

/* The animations in the file's order, null and 0 if it has none. They live until the file is released. */
FLG_API FlgResult flgSkinFileGetAnimations(FlgSkinFile file, const FlgSkinAnimation** out_animations,
                                           uint32_t* out_count);

/* The materials, one a part, or one for all; if at least one says a colour, else null and 0. As flgMeshFileGetMaterials. */
FLG_API FlgResult flgSkinFileGetMaterials(FlgSkinFile file, const FlgMeshMaterial** out_materials, uint32_t* out_count);

typedef struct FlgSkinFileInfo {
    uint32_t struct_size;
    uint32_t part_count;          /* the highest of the view's parts, and one */
    float box_min[3], box_max[3]; /* of the positions at rest, metres */
    uint32_t warning_count;
    uint32_t reserved;
    const char* const* warnings;  /* sentences; live until the file is released */
} FlgSkinFileInfo;

/* What the file holds, and what is odd about it. Set its struct_size. */
FLG_API FlgResult flgSkinFileGetInfo(FlgSkinFile file, FlgSkinFileInfo* out_info);

/* Null is allowed. */
FLG_API void flgSkinFileRelease(FlgSkinFile file);

typedef struct FlgSkinFileDesc {
    uint32_t struct_size;
    uint32_t animation_count;           /* default 0 */
    const FlgSkinView* skin;
    const FlgSkinAnimation* animations; /* animation_count of them, of all of the skin's joints */
    const char* name;                   /* of the model, UTF-8, at most 255 bytes; null: "model" */
    uint32_t material_count;            /* 0: one without colour; 1: of all; else above all parts. Default 0 */
    uint32_t reserved;
    const FlgMeshMaterial* materials;   /* by part. A triangle is of the part that two of its corners are of, else of the first's */
} FlgSkinFileDesc;

FLG_API FlgResult flgSkinFileDescInit(FlgSkinFileDesc* desc, uint32_t struct_size);

/* Writes a skin with its animations to .glb, whole or not at all as flgCurveFileWrite: a node with the mesh; a node with all
 * roots below it, which the skin names as its skeleton; a node a joint. Vertices have POSITION, NORMAL, JOINTS_0 (16 bits),
 * WEIGHTS_0 (float) and _PART. Rotations that stay at none are left out. It refuses what glTF forbids: joints out of range or
 * twice at a vertex, weights that don't come to 1 within 0.0001, quaternions that aren't of length 1 within 0.001, times that
 * don't rise, values that aren't finite, parents that don't come first. Cost: about 0.8 us a vertex.
 * Errors: FLG_ERROR_INVALID_ARGUMENT, FLG_ERROR_FORMAT for another extension, FLG_ERROR_FILE, FLG_ERROR_LIMIT (2 GiB). */
FLG_API FlgResult flgSkinFileWrite(const char* path, const FlgSkinFileDesc* desc);

/* ---- Motions of rigid bodies ----------------------------------------------------------------------------------- */

typedef struct FlgMotionFileDesc {
    uint32_t struct_size;
    uint32_t position_count;           /* at least 1 */
    const double* times;               /* seconds from 0 on; as floats they must rise */
    const double* poses;               /* 12 a position: three rows of four, the rotation and the place, metres. Points p of the
                                          body are at rotation p + place */
    double end_time;                   /* when the first pose comes again, after the last time; 0: it does not. Default 0 */
    const FlgMeshView* mesh;           /* moves with the body; null: none */
    const FlgMeshWriteDesc* mesh_desc; /* its materials, as for flgMeshFileWrite; null: defaults */
    float camera_fov_rad;              /* above 0 and below pi: a camera that looks along the body's -z, with y up, and sees this
                                          angle from bottom to top. Default 0: none */
    uint32_t reserved;
    const char* name;                  /* of the body, UTF-8, at most 255 bytes; null: "motion" */
} FlgMotionFileDesc;

FLG_API FlgResult flgMotionFileDescInit(FlgMotionFileDesc* desc, uint32_t struct_size);

/* Writes a motion to .glb, whole or not at all as flgCurveFileWrite: one node, with the mesh and the camera where given, and an
 * animation that moves it by a translation and a rotation a position; between positions both go evenly (LINEAR). Without an
 * animation it stands at the first one. Rotations of poses may be off by 0.001; quaternions are, to the bits of a float, of length
 * 1, and next ones on the same side. Cost: about 1 us a position, and what the mesh takes.
 * Errors: FLG_ERROR_INVALID_ARGUMENT (also for poses that are no rotations), FLG_ERROR_FORMAT for another extension,
 * FLG_ERROR_FILE, FLG_ERROR_LIMIT (2 GiB). */
FLG_API FlgResult flgMotionFileWrite(const char* path, const FlgMotionFileDesc* desc);

/* ---- Documents of tangles ------------------------------------------------------------------------------------- */

/* A history read from a file, with its memory. */
typedef struct FlgTangleFileT* FlgTangleFile;

/* Writes the history of a tangle (flgTangleGetHistory) as JSON that can be read, with a side file for arrays of more than twelve
 * numbers: `PATH.CHECKSUM.bin`, beside it. The JSON is put into its place last, and then the side file of the document that
 * was there is removed: a save that is cut short leaves the document as it was. Where the history needs no side file none is
 * written. The same history gives the same bytes.
 * Errors: FLG_ERROR_INVALID_ARGUMENT (null, values that aren't finite), FLG_ERROR_FILE, FLG_ERROR_LIMIT (8 MiB of JSON, 2 GiB
 * of arrays). Cost: some us a step and what the disk takes. */
FLG_API FlgResult flgTangleFileWrite(const char* path, const FlgTangleHistory* history);

/* Reads a document, and checks it as far as that can be done without its mesh: version, keys, types, sizes, the side file's size
 * and checksum, finite numbers. What the numbers may not be flgTangleReplay finds out. Nothing is read twice, so that what is
 * made of a file is no larger than some multiple of it.
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT. Cost: some us a step and what the disk takes. */
FLG_API FlgResult flgTangleFileRead(const char* path, FlgTangleFile* out_file);

/* The history, ready for flgTangleReplay; lives until the file is released. */
FLG_API FlgResult flgTangleFileGetHistory(FlgTangleFile file, FlgTangleHistory* out_history);

/* Null is allowed. */
FLG_API void flgTangleFileRelease(FlgTangleFile file);

#ifdef __cplusplus
}
#endif

#endif
