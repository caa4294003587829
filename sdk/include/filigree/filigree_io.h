/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Filigree's file formats, in a separate library (filigree_io) that hosts may leave out. Follows the grammar of
 * filigree.h but needs no context: its functions block on the disk, so call them where your engine loads assets. Memory
 * and files may be the host's (FlgFileHooks).
 *
 * [any thread] All functions here; calls on one FlgCurveFile, FlgMeshFile, FlgSkinFile or FlgTangleFile must not
 * overlap.
 *
 * Curve formats, by extension:
 *   .xyz .txt     text: `x y z [radius]` per line, blank line between curves, `# closed` on the line before a closed
 *                 one, `# color r g b a` (linear; without a: 1) on the line before the points that have this colour, up
 *                 to the next such line; anything else after # is ignored. Points before the first colour are white.
 *                 All points of a curve have a radius or none; if only some curves do, the others get 0.005 m. A line
 *                 `# columns x y z NAME ...` before the first point instead names the contents of all lines, each
 *                 number by a name from the list below
 *   .obj          lines (`l`); read and written. Edges (`l a b`) that chain are joined; colours and radii are lost
 *   .gltf .glb    LINES (joined where they chain), LINE_STRIP, LINE_LOOP, with COLOR_0 and _RADIUS, and with NORMAL,
 *                 _TIME, _PRESSURE, _STYLE_INDEX, _RADII, _ANGLE, _WIDTH, _SPEED, _DISPLACEMENT and _USERN (1 to 4
 *                 floats) if all curves have them; node transforms apply to lengths, speeds and directions too. .glb is
 *                 written, as lines, ribbons or tubes; colours of these have 16 bits. Buffers only embedded or
 *                 below the file's folder
 *   .tilt         VR sketches, a file or a directory, read only; converted to metres and to a right-handed system. In
 *                 an FlgFileSystem a directory is a path that does not open, with a `data.sketch` below it that does
 *   .svg          outlines of shapes and paths, read only; y upwards, one metre per px, curves flattened to 1/1000 of
 *                 their size
 * Mesh formats, by extension; read and written, .gltf only read:
 *   .ply          reads ascii and binary, writes little-endian binary. Vertices: positions, colours (0 to 1 if they are
 *                 integers), normals and the columns this library writes, by the names below. Faces: the list
 *                 vertex_indices, and integer properties, of which `region` becomes the view's regions; or `tristrips`.
 *                 Reads texture coordinates: `s t`, `u v` or `texture_u texture_v` of vertices, lists `texcoord` of
 *                 faces, with the textures of comments `TextureFile` below the file's folder, by `texnumber`. Other
 *                 elements and properties are skipped
 *   .obj          faces (`f`) and positions with colours (`v x y z r g b`). Regions are materials (`usemtl`), numbered
 *                 from 0 in order of first use, and written as such. Texture coordinates (`vt`) are read, and materials
 *                 of `mtllib` files below the file's folder: Kd, map_Kd, Pr, Pm. Normals are skipped
 *   .off          also COFF, NOFF and CNOFF; colours (0 to 255 if one is above 1) but no regions
 *   .gltf .glb    TRIANGLES, TRIANGLE_STRIP and TRIANGLE_FAN with COLOR_0, placed by the scene's nodes; regions are
 *                 materials, numbered from 0 in order of first use; their factors are read, and their base colour
 *                 textures with TEXCOORD_0. Reads KHR_mesh_quantization and KHR_texture_transform. What is left out is
 *                 named in warnings. Writes .glb. Limits as for curves
 * Large worlds: .obj, .off, .xyz and .ply (doubles and text) are read to all their digits, .gltf and .glb as precisely
 * as their nodes place them. Where most edges are shorter than 64 times the spacing of floats there, views get an
 * origin: the middle of all, or the first node's place, in whole metres. Boxes in infos are relative to it. Views with
 * an origin are written to text with more digits, to .ply in doubles, to .glb below a node at the origin.
 * Column names in .ply and .xyz: x y z; nx ny nz; red green blue alpha; radius, time, pressure, style_index, angle,
 * width, speed; tangent_0 to _2, orientation_0 to _3, radii_0 to _2, displacement_0 to _2; FLG_ATTRIBUTE_USER + N:
 * userN, or userN_0, userN_1, ... with several components. For meshes the other formats hold positions, colours (not
 * above 1 in .glb) and, in .glb, normals.
 */
#ifndef FILIGREE_FILIGREE_IO_H
#define FILIGREE_FILIGREE_IO_H

#include "filigree.h"
#include "filigree_rig.h"
#include "filigree_surface.h"
#include "filigree_tangle.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- The host's memory and files ----------------------------------------------------------------------------- */

/* What a file is opened for. */
typedef enum FlgFileAccess {
    FLG_FILE_ACCESS_READ = 0,  /* from its start */
    FLG_FILE_ACCESS_WRITE = 1, /* anew: what is there is replaced when the file is closed as complete */
    FLG_FILE_ACCESS_FORCE_32BIT = 0x7fffffff
} FlgFileAccess;

/* Files of the host: archives, assets, consoles. Called only within calls of this library that were given it, on their
 * threads. Paths are those the host passes, and names beside them that files or this library give, put together with
 * `/`; UTF-8. This library opens no path with `..` that the host did not pass. One file is open at a time in a call.
 * Each function returns FLG_OK or an error, such as FLG_ERROR_FILE; the call that needs the file then fails with it. */
typedef struct FlgFileSystem {
    uint32_t struct_size;
    uint32_t reserved;
    void* user_data; /* passed to all */
    /* Opens a file; `out_file` is what the other functions get. */
    FlgResult (*open)(void* user_data, const char* path, FlgFileAccess access, void** out_file);
    /* The size of a file that is read, bytes. */
    FlgResult (*size)(void* user_data, void* file, uint64_t* out_size);
    /* Reads the next bytes, at most `size`; `out_count` is how many. 0 only at the end. */
    FlgResult (*read)(void* user_data, void* file, void* out_bytes, size_t size, size_t* out_count);
    /* Appends bytes, all of them. Null: no file can be written. */
    FlgResult (*write)(void* user_data, void* file, const void* bytes, size_t size);
    /* Called once for each open file. Of one that is written, `complete` tells whether to keep it: with 0 what was
     * there before must stay. */
    FlgResult (*close)(void* user_data, void* file, uint32_t complete);
    /* Removes a side file that no document names any more. Where it fails the file stays, and the call that asked for
     * it succeeds nevertheless. Null: files stay. */
    FlgResult (*remove)(void* user_data, const char* path);
} FlgFileSystem;

FLG_API FlgResult flgFileSystemInit(FlgFileSystem* files, uint32_t struct_size);

/* What a call uses of the host. The structs are copied; what they point to must live as long as what the call makes. */
typedef struct FlgFileHooks {
    uint32_t struct_size;
    uint32_t reserved;
    /* All memory of the call and of what it makes. Where it returns null, the call fails with FLG_ERROR_OUT_OF_MEMORY.
     * Null: the C++ runtime's. Not included: what the C++ runtime takes for the exceptions that stop a failing call,
     * and for names and buffers of the operating system's files. Called on the threads that use this library. */
    const FlgAllocator* allocator;
    const FlgFileSystem* files; /* null: the operating system's */
} FlgFileHooks;

FLG_API FlgResult flgFileHooksInit(FlgFileHooks* hooks, uint32_t struct_size);

/* ---- Curves -------------------------------------------------------------------------------------------------- */

/* Curves read from a file, with their memory. */
typedef struct FlgCurveFileT* FlgCurveFile;

/* [any thread] As flgErrorGetMessage, for the functions of this header. Sentences start with FILE:PLACE, where PLACE
 * is a line number, a byte offset (`@1234`), a part of the file's structure or an argument; with FILE alone if the
 * whole file is meant, such as when it cannot be opened. */
FLG_API const char* flgIoErrorGetMessage(void);

/* How a curve file is read. */
typedef struct FlgCurveFileReadDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
} FlgCurveFileReadDesc;

FLG_API FlgResult flgCurveFileReadDescInit(FlgCurveFileReadDesc* desc, uint32_t struct_size);

/* Reads all curves of a file. Reads the whole file, checks it, and refuses it at the first error; mere oddities become
 * warnings (flgCurveFileGetInfo). `desc` may be null: all defaults. Limits: 2 GiB a file (unpacked too), 2^31 points.
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT, FLG_ERROR_OUT_OF_MEMORY. Cost: 0.1 to 0.2 us a point. */
FLG_API FlgResult flgCurveFileRead(const char* path, const FlgCurveFileReadDesc* desc, FlgCurveFile* out_file);

/* The curves, ready for flgCurveSetCreate; lives until the file is released. */
FLG_API FlgResult flgCurveFileGetView(FlgCurveFile file, FlgCurveSetView* out_view);

typedef struct FlgCurveFileInfo {
    uint32_t struct_size;
    uint32_t curve_count;
    uint64_t point_count;
    const char* format;           /* "tilt", "xyz", "obj", "gltf", "svg" */
    const char* units;            /* of the file, before conversion: "decimetres, left-handed", "metres", "as given" */
    float box_min[3], box_max[3]; /* of the positions, metres */
    float total_length;           /* of all curves as polylines, metres */
    uint32_t warning_count;
    uint32_t stroke_count;        /* that of the curves for .tilt files, else 0 */
    const char* const* warnings;  /* sentences; live until the file is released */
} FlgCurveFileInfo;

FLG_API FlgResult flgCurveFileInfoInit(FlgCurveFileInfo* info, uint32_t struct_size);

/* The file's contents and warnings. Set struct_size. */
FLG_API FlgResult flgCurveFileGetInfo(FlgCurveFile file, FlgCurveFileInfo* out_info);

/* Data of one stroke in a .tilt file, besides its points. */
typedef struct FlgStroke {
    uint32_t struct_size;
    uint32_t group;    /* selection group, 0 = none */
    char brush[40];    /* the brush's name if known, else its GUID */
    float size;        /* width at full pressure, metres */
    uint32_t flags;    /* as stored: 2 = continues the undo group of the previous stroke */
    uint64_t start_ms; /* timestamp of its first point, milliseconds of sketching time */
} FlgStroke;

FLG_API FlgResult flgStrokeInit(FlgStroke* stroke, uint32_t struct_size);

/* The stroke of a curve, 0 to the info's stroke_count - 1. Set struct_size. */
FLG_API FlgResult flgCurveFileGetStroke(FlgCurveFile file, uint32_t curve, FlgStroke* out_stroke);

/* Null is allowed. */
FLG_API void flgCurveFileRelease(FlgCurveFile file);

/* Geometry of curves in .glb. */
typedef enum FlgCurveGeometry {
    FLG_CURVE_GEOMETRY_LINES = 0,  /* no surface */
    FLG_CURVE_GEOMETRY_RIBBON = 1, /* flat, across the frame's second normal */
    FLG_CURVE_GEOMETRY_TUBE = 2,   /* round, with `tube_sides` sides */
    FLG_CURVE_GEOMETRY_FORCE_32BIT = 0x7fffffff
} FlgCurveGeometry;

typedef struct FlgCurveFileWriteDesc {
    uint32_t struct_size;
    FlgCurveGeometry geometry; /* for .glb; the text formats hold lines. Default FLG_CURVE_GEOMETRY_LINES */
    float default_radius;      /* metres, > 0, for curves without a RADIUS column. Default 0.005 */
    uint32_t tube_sides;       /* 3 to 64. Default 8 */
    uint32_t all_columns;      /* nonzero: .xyz and lines in .glb hold all columns of the view (.glb except TANGENT
                                  and ORIENTATION), else positions, radii and colours. Default 0 */
    uint32_t reserved;
    float tolerance;           /* metres, >= 0: how far ribbons and tubes may deviate from those with all points and
                                  `tube_sides` sides. Makes the file smaller. Default 0: every point, every side */
    uint32_t quantize;         /* nonzero: ribbons and tubes use integers (KHR_mesh_quantization): positions in
                                  65535ths of their piece's extent, if that is within the tolerance, normals and
                                  colours in 8 bits. Halves the size. Not all programs read it. Default 0 */
    const uint8_t* geometries; /* for .glb: FLG_CURVE_GEOMETRY_RIBBON or FLG_CURVE_GEOMETRY_TUBE for each curve, in
                                  place of `geometry`. Default null */
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
} FlgCurveFileWriteDesc;

FLG_API FlgResult flgCurveFileWriteDescInit(FlgCurveFileWriteDesc* desc, uint32_t struct_size);

/* Writes curves to .xyz, .obj or .glb, completely or not at all, also when the power goes: a temporary file beside it
 * is flushed to the disk and renamed when complete (for an FlgFileSystem its `close` does so). The mode and owner of a
 * file that it replaces stay. So do all functions that write files. `desc` may be null. Curves without a NORMAL column
 * get frames by double reflection. Colours in .glb are clamped to 0 to 1; .glb cannot hold USER columns of more than 4
 * floats. Lines of one point are written with that point twice; ribbons and tubes omit zero-length curves.
 * Errors: FLG_ERROR_INVALID_ARGUMENT (also for no curves at all), FLG_ERROR_FORMAT for another extension,
 * FLG_ERROR_FILE, FLG_ERROR_LIMIT (.glb: 2 GiB). Text leaves while it is made, in parts of 64 KiB, and may be of any
 * size; above 2 GiB it can't be read again. Cost: .glb 0.1 us a point, text 0.5 to 0.8. */
FLG_API FlgResult flgCurveFileWrite(const char* path, const FlgCurveSetView* view, const FlgCurveFileWriteDesc* desc);

/* ---- Meshes -------------------------------------------------------------------------------------------------- */

/* A mesh read from a file, with its memory. */
typedef struct FlgMeshFileT* FlgMeshFile;

/* How a mesh file is read. */
typedef struct FlgMeshFileReadDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
} FlgMeshFileReadDesc;

FLG_API FlgResult flgMeshFileReadDescInit(FlgMeshFileReadDesc* desc, uint32_t struct_size);

/* Reads the mesh of a file as stored: nothing is welded, reversed or dropped, except triangles of strips and fans that
 * use a vertex twice. Splits faces of more than three corners into triangles: convex ones as fans from their first
 * corner, others of at most 1024 corners by ear clipping. Like flgCurveFileRead, refuses errors (indices out of range,
 * faces of fewer than three corners, values that are not finite, counts too large for the file, no faces at all) and
 * warns of oddities. Cost: one core, some 400 MB/s of binary and 250 MB/s of text (2 M triangles: 0.1 s and 0.3 s).
 * `desc` may be null: all defaults. Limits: 2 GiB a file, and 2 GiB for the result.
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT. */
FLG_API FlgResult flgMeshFileRead(const char* path, const FlgMeshFileReadDesc* desc, FlgMeshFile* out_file);

/* The mesh; lives until the file is released. `regions` is null if the file has none. */
FLG_API FlgResult flgMeshFileGetView(FlgMeshFile file, FlgMeshView* out_view);

/* Integers per triangle, with a name. */
typedef struct FlgMeshFaceColumn {
    uint32_t struct_size;   /* the same of all columns of a mesh */
    uint32_t reserved;
    const char* name;       /* letters, digits and _, at most 63; not `region` nor `vertex_indices` */
    const uint32_t* values; /* one per triangle */
} FlgMeshFaceColumn;

FLG_API FlgResult flgMeshFaceColumnInit(FlgMeshFaceColumn* column, uint32_t struct_size);

/* An integer property of a .ply file's faces besides `region`, 0 to the info's face_column_count - 1. All triangles of
 * a face have its values; negative values are stored plus 2^32. Its arrays live until the file is released. */
FLG_API FlgResult flgMeshFileGetFaceColumn(FlgMeshFile file, uint32_t column, FlgMeshFaceColumn* out_column);

/* How a texture goes on beyond its picture. */
typedef enum FlgTextureWrap {
    FLG_TEXTURE_WRAP_REPEAT = 0,
    FLG_TEXTURE_WRAP_CLAMP = 1,  /* by its edge */
    FLG_TEXTURE_WRAP_MIRROR = 2, /* repeated, every other one mirrored */
    FLG_TEXTURE_WRAP_FORCE_32BIT = 0x7fffffff
} FlgTextureWrap;

/* A picture that colours triangles, by the texture coordinates of their corners: 0 0 is its upper left, 1 1 its lower
 * right. */
typedef struct FlgTexture {
    uint32_t struct_size;   /* the same of all textures of a file */
    uint32_t nearest;       /* nonzero: texels are not blended. Default 0 */
    FlgTextureWrap wrap_u;  /* Default FLG_TEXTURE_WRAP_REPEAT */
    FlgTextureWrap wrap_v;
    const uint8_t* picture; /* a PNG or JPEG file, picture_size bytes; sRGB */
    uint64_t picture_size;  /* bytes */
    const char* name;       /* UTF-8, at most 255 bytes; null: none. Default null */
} FlgTexture;

FLG_API FlgResult flgTextureInit(FlgTexture* texture, uint32_t struct_size);

/* A region's material: glTF's metallic-roughness model, and a line where it meets another region. Colours are linear
 * RGB. */
typedef struct FlgMeshMaterial {
    uint32_t struct_size;   /* the same of all materials of a mesh */
    uint32_t reserved;
    const char* name;       /* UTF-8, at most 255 bytes. Default null: `region N` */
    float color[3];         /* 0 to 1 each. Default 1 1 1 */
    float metallic;         /* 0 = paint, clay, wood to 1 = bare metal. Default 0 */
    float roughness;        /* 0 = polished to 1 = matte. Default 0.6 */
    float border_color[3];  /* of the lines to regions earlier in the table, 0 to 1 each. Default 0 0 0 */
    float border_width_px;  /* of these lines, 0 to 64 pixels. Default 0: none */
    uint32_t reserved2;
    uint32_t texture;       /* of the file's textures: its colour, times the material's. Default FLG_NO_INDEX: none */
    uint32_t two_sided;     /* nonzero: seen from behind too. Default 0 */
} FlgMeshMaterial;

FLG_API FlgResult flgMeshMaterialInit(FlgMeshMaterial* material, uint32_t struct_size);

/* The material of a region in a .gltf or .glb file, in an .obj file's `mtllib`, of a .ply file's textures, 0 to the
 * info's material_count - 1. Missing factors get glTF's defaults: white, metallic 1, roughness 1; in .obj and .ply
 * files metallic 0. Lines are read only from this library's files: glTF has none. Its name lives until the file is
 * released. */
FLG_API FlgResult flgMeshFileGetMaterial(FlgMeshFile file, uint32_t material, FlgMeshMaterial* out_material);

/* A texture of a material, 0 to the info's texture_count - 1. Its picture is not decoded; it lives until the file is
 * released. */
FLG_API FlgResult flgMeshFileGetTexture(FlgMeshFile file, uint32_t texture, FlgTexture* out_texture);

typedef struct FlgMeshFileInfo {
    uint32_t struct_size;
    uint32_t vertex_count;        /* as stored: formats that keep normals or texture with vertices repeat positions */
    uint32_t triangle_count;      /* after splitting polygons */
    uint32_t region_count;        /* distinct labels; 1 if the file has none */
    uint64_t polygon_count;       /* faces as stored; for strips and fans their triangles */
    const char* format;           /* "ply", "obj", "off", "gltf" */
    float box_min[3], box_max[3]; /* of the positions, metres; units are taken as given */
    uint32_t warning_count;
    uint32_t material_count;      /* one per region of the view (one alone if that has no regions), if at least one has
                                     a colour or a texture; else 0 */
    const char* const* warnings;  /* sentences; live until the file is released */
    uint32_t face_column_count;   /* at most 16; 0 for other formats than .ply */
    uint32_t texture_count;
    const float* corner_uvs;      /* 6 per triangle: texture coordinates of its corners, 0 0 where some have none; live
                                     until the file is released. Null: the file has none */
} FlgMeshFileInfo;

FLG_API FlgResult flgMeshFileInfoInit(FlgMeshFileInfo* info, uint32_t struct_size);

/* The file's contents and warnings. Set struct_size. */
FLG_API FlgResult flgMeshFileGetInfo(FlgMeshFile file, FlgMeshFileInfo* out_info);

/* Null is allowed. */
FLG_API void flgMeshFileRelease(FlgMeshFile file);

typedef struct FlgMeshFileWriteDesc {
    uint32_t struct_size;
    uint32_t face_column_count;            /* 0 to 16. Default 0 */
    const FlgMeshFaceColumn* face_columns; /* written to .ply, under distinct names; the other formats cannot hold
                                              them */
    uint32_t split_regions;                /* nonzero: one primitive and material per region in .glb. Default 0 */
    uint32_t material_count;               /* with split_regions: above all regions' labels. Default 0: named, without
                                              colour */
    const FlgMeshMaterial* materials;      /* for .glb, by label; materials without a region are omitted */
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
    /* For .glb: the path of the .gltf or .glb file whose mesh, as flgMeshFileRead gives it, became the surface that
     * `view` shows. What that file holds is written too: nodes, other meshes, materials, pictures, skins, animations
     * and what this library does not know keep their content. Triangles are the view's, with all that the file's
     * vertices have: texture coordinates, colours, tangents, joints and weights, morph targets. Those whose label is
     * material_count or more keep their material. Needs `provenance`. Default null: none. */
    const char* asset;
    const FlgSurfaceProvenanceView* provenance; /* of that surface, as it is in `view`. Default null */
} FlgMeshFileWriteDesc;

FLG_API FlgResult flgMeshFileWriteDescInit(FlgMeshFileWriteDesc* desc, uint32_t struct_size);

/* Writes a mesh to .ply, .obj, .off or .glb, completely or not at all, as flgCurveFileWrite. `desc` may be null. .ply
 * and .glb keep every bit of positions; text has 9 digits. A column FLG_ATTRIBUTE_UV, with v downwards, becomes
 * TEXCOORD_0 in .glb, `vt` in .obj, `s` and `t` in .ply; .off has none. .glb gets normals: the column's, else
 * area-weighted ones.
 * Errors: FLG_ERROR_INVALID_ARGUMENT (also for no triangles, and for indices out of range), FLG_ERROR_FORMAT for
 * another extension, FLG_ERROR_FILE, FLG_ERROR_LIMIT (.ply, .glb: 2 GiB). Cost: 0.2 to 0.5 us a triangle. */
FLG_API FlgResult flgMeshFileWrite(const char* path, const FlgMeshView* view, const FlgMeshFileWriteDesc* desc);

/* ---- Skinned models ------------------------------------------------------------------------------------------ */

/* A skin read from a .gltf or .glb file, with its animations and its memory. */
typedef struct FlgSkinFileT* FlgSkinFile;

/* How a skin file is read. */
typedef struct FlgSkinFileReadDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
} FlgSkinFileReadDesc;

FLG_API FlgResult flgSkinFileReadDescInit(FlgSkinFileReadDesc* desc, uint32_t struct_size);

/* Reads the skinned mesh in a file's scene: all nodes with a mesh and the first skin found; other meshes are skipped,
 * with a warning. The rest pose is that of the skin's inverseBindMatrices, whatever the nodes say. Joints rotated in
 * that pose are read without the rotation; animation rotations change so that each vertex moves as before. The keys of
 * all channels of an animation are merged. Joints come parents first; joints below other nodes attach to the nearest
 * joint above. Weights are sorted and normalized to sum 1; only the first four joints of a vertex are read. Missing
 * normals are computed. Parts come from the column _PART, else from the materials. TEXCOORD_0 becomes the view's
 * corner_uvs. Morph targets are read if all primitives have as many; their animations must be LINEAR.
 * Refused, as FlgSkinAnimation cannot represent them: scaled joints, joints that an animation moves away from their
 * parents, roots that move differently, keys that are not LINEAR. Also refused: missing, out-of-range or non-finite
 * joints or weights, cycles of nodes, inconsistent counts.
 * If the scene has no skin the result is FLG_OK and `out_file` null. `desc` may be null: all defaults. Cost: one core,
 * about 0.4 us a vertex.
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT (2 GiB a file and for the result; 65535 joints). */
FLG_API FlgResult flgSkinFileRead(const char* path, const FlgSkinFileReadDesc* desc, FlgSkinFile* out_file);

/* The skin; lives until the file is released. */
FLG_API FlgResult flgSkinFileGetView(FlgSkinFile file, FlgSkinView* out_view);

/* An animation, 0 to the info's animation_count - 1, in the file's order. Its arrays live until the file is
 * released. */
FLG_API FlgResult flgSkinFileGetAnimation(FlgSkinFile file, uint32_t animation, FlgSkinAnimation* out_animation);

/* The material of a part, 0 to the info's material_count - 1. As flgMeshFileGetMaterial. */
FLG_API FlgResult flgSkinFileGetMaterial(FlgSkinFile file, uint32_t material, FlgMeshMaterial* out_material);

/* A texture of a material, 0 to the info's texture_count - 1. As flgMeshFileGetTexture. */
FLG_API FlgResult flgSkinFileGetTexture(FlgSkinFile file, uint32_t texture, FlgTexture* out_texture);

/* A shape that a mesh takes as far as its weight says: vertices move by `moves`, times the weight, before joints move
 * them. */
typedef struct FlgMorphTarget {
    uint32_t struct_size;      /* the same of all targets of a mesh */
    uint32_t reserved;
    const char* name;          /* UTF-8, at most 255 bytes; null: `target N`. Default null */
    const float* moves;        /* 3 per vertex, metres */
    const float* normal_moves; /* 3 per vertex: what is added to normals. Null: found from how triangles turn. Default
                                  null */
} FlgMorphTarget;

FLG_API FlgResult flgMorphTargetInit(FlgMorphTarget* target, uint32_t struct_size);

/* Weights of all morph targets over time. Between keys they change evenly; before the first and after the last key they
 * hold. */
typedef struct FlgMorphAnimation {
    uint32_t struct_size;  /* the same of all of a mesh */
    uint32_t key_count;    /* at least 1 */
    const char* name;      /* UTF-8; null: "morph". Of one that belongs to a skin's animation that one's name counts */
    const float* times;    /* seconds, starting at 0 or later; strictly ascending */
    const float* weights;  /* for each key one per target; finite */
    uint32_t animation;    /* of the skin's animations: joints and shapes move together, as one animation. Default
                              FLG_NO_INDEX: by itself */
    uint32_t reserved;
} FlgMorphAnimation;

FLG_API FlgResult flgMorphAnimationInit(FlgMorphAnimation* animation, uint32_t struct_size);

/* A morph target, 0 to the info's morph_count - 1. Its arrays live until the file is released; `normal_moves` are 0
 * where the file has none. */
FLG_API FlgResult flgSkinFileGetMorphTarget(FlgSkinFile file, uint32_t target, FlgMorphTarget* out_target);

/* What animates morph targets, 0 to the info's morph_animation_count - 1. Its arrays live until the file is released.
 */
FLG_API FlgResult flgSkinFileGetMorphAnimation(FlgSkinFile file, uint32_t animation,
                                               FlgMorphAnimation* out_animation);

typedef struct FlgSkinFileInfo {
    uint32_t struct_size;
    uint32_t part_count;          /* the view's highest part index plus one */
    float box_min[3], box_max[3]; /* of the positions at rest, metres */
    uint32_t warning_count;
    uint32_t animation_count;
    const char* const* warnings;  /* sentences; live until the file is released */
    uint32_t material_count;      /* one per part, or one for all, if at least one has a colour or a texture; else 0 */
    uint32_t texture_count;
    const float* vertex_colors;   /* 4 per vertex, linear RGBA; live until the file is released. Null: none */
    uint32_t morph_count;
    uint32_t morph_animation_count;
} FlgSkinFileInfo;

FLG_API FlgResult flgSkinFileInfoInit(FlgSkinFileInfo* info, uint32_t struct_size);

/* The file's contents and warnings. Set struct_size. */
FLG_API FlgResult flgSkinFileGetInfo(FlgSkinFile file, FlgSkinFileInfo* out_info);

/* Null is allowed. */
FLG_API void flgSkinFileRelease(FlgSkinFile file);

/* The extension VRMC_vrm of VRM 1.0: who made an avatar, and which of its joints are which bones. Its other fields are
 * left at the extension's defaults: only the author may use the avatar, and nobody may change it. */
typedef struct FlgVrm {
    uint32_t struct_size;
    uint32_t author_count;      /* at least 1 */
    const char* const* authors; /* UTF-8 */
    const char* name;           /* of the avatar, UTF-8; null: the model's. Default null */
    const char* license_url;    /* UTF-8; null: https://vrm.dev/licenses/1.0/, the only one VRM 1.0 allows. Default
                                   null */
    const char* const* bones;   /* one per joint of the skin: from flgRigGetNames with FLG_RIG_STANDARD_VRM; null: the
                                   joint is no bone of VRM */
} FlgVrm;

FLG_API FlgResult flgVrmInit(FlgVrm* vrm, uint32_t struct_size);

typedef struct FlgSkinFileWriteDesc {
    uint32_t struct_size;
    uint32_t animation_count;           /* default 0 */
    const FlgSkinView* skin;
    const FlgSkinAnimation* animations; /* animation_count entries, each for all of the skin's joints */
    const char* name;                   /* of the model, UTF-8, at most 255 bytes; null: "model" */
    uint32_t material_count;            /* 0: one without colour; 1: one for all; else above all part indices.
                                           Default 0 */
    uint32_t reserved;
    const FlgMeshMaterial* materials;   /* by part. Without triangle_parts a triangle belongs to the part of two of its
                                           corners, else of its first corner */
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
    const FlgRig* rig;         /* of the skin's joints: written as `extras` of their nodes, see docs/rigs.md. Default
                                  null */
    const FlgVrm* vrm;         /* makes the file a VRM 1.0 avatar. Default null */
    const uint8_t* texture;    /* a PNG or JPEG file, texture_size bytes: the colour of all materials, times theirs; the
                                  skin needs corner_uvs. Default null */
    uint64_t texture_size;     /* bytes; 0 without one. Default 0 */
    const FlgSkinView* levels; /* levels of detail after the skin itself, from fine to coarse, with its joints:
                                  flgSkinSimplify. Default null */
    uint32_t level_count;      /* up to 16. Default 0 */
    uint32_t texture_count;    /* default 0 */
    const FlgTexture* textures;  /* what materials refer to, in place of `texture`; the skin and its levels need
                                    corner_uvs. Default null */
    const float* vertex_colors;  /* 4 per vertex of the skin, linear RGBA, 0 to 1: times the materials' colour. Levels
                                    of detail have none. Default null */
    const FlgMorphTarget* morphs; /* shapes of the skin. Default null */
    const FlgMorphAnimation* morph_animations; /* default null */
    uint32_t morph_count;           /* up to 65535. Default 0 */
    uint32_t morph_animation_count; /* default 0 */
    const FlgMorphTarget* level_morphs; /* the same shapes of the levels of detail: morph_count of each, level by level;
                                           their names are not read. Null: levels have none. Default null */
} FlgSkinFileWriteDesc;

FLG_API FlgResult flgSkinFileWriteDescInit(FlgSkinFileWriteDesc* desc, uint32_t struct_size);

/* Writes a skin with its animations to .glb, completely or not at all, as flgCurveFileWrite: a node with the mesh, a
 * node above all roots, which the skin names as its skeleton, and one node per joint. Vertices have POSITION, NORMAL,
 * JOINTS_0 (16 bits), WEIGHTS_0 (float), _PART, with corner_uvs TEXCOORD_0, with vertex_colors COLOR_0. They keep their
 * order; of those whose corners differ in texture coordinates, copies follow after all. Morph targets have POSITION and
 * NORMAL, sparse where few vertices move; their weights are animated at the mesh's node, and at those of levels that
 * have them. Levels of detail are meshes of the same skin, named NAME_LOD0, NAME_LOD1, ...; the first is in the scene
 * and refers to the others by MSFT_lod, so programs that do not know it show the finest alone. Rotations that stay at
 * identity are omitted. Refuses what glTF forbids: joints out of range or twice at a vertex, weights that do not sum to
 * 1 within 0.0001, quaternions that are not of length 1 within 0.001, times that do not rise, values that are not
 * finite, parents that do not come first.
 * Cost: about 0.8 us a vertex. Errors: FLG_ERROR_INVALID_ARGUMENT, FLG_ERROR_FORMAT for another extension,
 * FLG_ERROR_FILE, FLG_ERROR_LIMIT (2 GiB). */
FLG_API FlgResult flgSkinFileWrite(const char* path, const FlgSkinFileWriteDesc* desc);

/* ---- Motions of rigid bodies ----------------------------------------------------------------------------------- */

typedef struct FlgMotionFileWriteDesc {
    uint32_t struct_size;
    uint32_t position_count;               /* at least 1 */
    const double* times;                   /* seconds, starting at 0 or later; strictly ascending as floats */
    const double* poses;                   /* 12 per position: three rows of four, the rotation and the position,
                                              metres. Point p of the body is at rotation p + position */
    double end_time;                       /* when the first pose recurs, after the last time; 0: never. Default 0 */
    const FlgMeshView* mesh;               /* moves with the body; null: none */
    const FlgMeshFileWriteDesc* mesh_desc; /* its materials, as for flgMeshFileWrite; its hooks are not used; null:
                                              defaults */
    float camera_fov_rad;                  /* above 0 and below pi: the vertical field of view of a camera that looks
                                              along the body's -z, with y up. Default 0: no camera */
    uint32_t reserved;
    const char* name;                  /* of the body, UTF-8, at most 255 bytes; null: "motion" */
    double origin[3];                  /* metres: what the poses are relative to: a node above the body's is there.
                                          Default 0 */
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
} FlgMotionFileWriteDesc;

FLG_API FlgResult flgMotionFileWriteDescInit(FlgMotionFileWriteDesc* desc, uint32_t struct_size);

/* Writes a motion to .glb, completely or not at all, as flgCurveFileWrite: one node, with the mesh and the camera if
 * given, and an animation with one translation and rotation per position; both interpolate linearly in between
 * (LINEAR). Without an animation the node stands at the first pose. Rotations of poses may be off by 0.001; quaternions
 * have length 1, to float precision, and consecutive ones are in the same hemisphere. Cost: about 1 us a position, and
 * what the mesh takes. Errors: FLG_ERROR_INVALID_ARGUMENT (also for poses that are no rotations), FLG_ERROR_FORMAT for
 * another extension, FLG_ERROR_FILE, FLG_ERROR_LIMIT (2 GiB). */
FLG_API FlgResult flgMotionFileWrite(const char* path, const FlgMotionFileWriteDesc* desc);

/* ---- Documents of tangles ------------------------------------------------------------------------------------- */

/* [any thread] The name of a tangle operator in documents and scripts, such as "contour", by FlgTangleOperator value.
 * Null beyond the last one. A static string. Cost: nanoseconds. */
FLG_API const char* flgTangleOperatorGetName(uint32_t number);

/* [any thread] Likewise for a macro, such as "sunburst", by FlgTangleMacro value. Cost: nanoseconds. */
FLG_API const char* flgTangleMacroGetName(uint32_t number);

/* A history read from a file, with its memory. */
typedef struct FlgTangleFileT* FlgTangleFile;

typedef struct FlgTangleFileWriteDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
} FlgTangleFileWriteDesc;

FLG_API FlgResult flgTangleFileWriteDescInit(FlgTangleFileWriteDesc* desc, uint32_t struct_size);

/* Writes a tangle's history (flgTangleGetHistory) as readable JSON, with arrays of more than twelve numbers in a side
 * file beside it: `PATH.CHECKSUM.bin`. The JSON is put in place last; then the previous document's side file is
 * removed: an interrupted save leaves the previous document intact. No side file is written if none is needed. The same
 * history gives the same bytes. `desc` may be null: all defaults. An FlgFileSystem opens and closes one file after the
 * other.
 * Errors: FLG_ERROR_INVALID_ARGUMENT (null, values that are not finite), FLG_ERROR_FILE, FLG_ERROR_LIMIT (8 MiB of
 * JSON, 2 GiB of arrays). Cost: some us a step and what the disk takes. */
FLG_API FlgResult flgTangleFileWrite(const char* path, const FlgTangleHistory* history,
                                     const FlgTangleFileWriteDesc* desc);

/* How a tangle's file is read. */
typedef struct FlgTangleFileReadDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgFileHooks* hooks; /* null: all defaults. Default null */
} FlgTangleFileReadDesc;

FLG_API FlgResult flgTangleFileReadDescInit(FlgTangleFileReadDesc* desc, uint32_t struct_size);

/* Reads a document and checks what can be checked without its mesh: version, keys, types, sizes, the side file's size
 * and checksum, finite numbers. flgTangleReplay checks the values' ranges. Nothing is read twice, so the result is at
 * most some multiple of the file's size. `desc` may be null: all defaults.
 * Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT. Cost: some us a step and what the disk takes. */
FLG_API FlgResult flgTangleFileRead(const char* path, const FlgTangleFileReadDesc* desc, FlgTangleFile* out_file);

/* The history, ready for flgTangleReplay; lives until the file is released. */
FLG_API FlgResult flgTangleFileGetHistory(FlgTangleFile file, FlgTangleHistory* out_history);

/* Null is allowed. */
FLG_API void flgTangleFileRelease(FlgTangleFile file);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgFileSystem flgFileSystemDefaults(void) {
    FlgFileSystem files;
    flgFileSystemInit(&files, (uint32_t)sizeof files);
    return files;
}

static inline FlgFileHooks flgFileHooksDefaults(void) {
    FlgFileHooks hooks;
    flgFileHooksInit(&hooks, (uint32_t)sizeof hooks);
    return hooks;
}

static inline FlgCurveFileReadDesc flgCurveFileReadDefaults(void) {
    FlgCurveFileReadDesc desc;
    flgCurveFileReadDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgMeshFileReadDesc flgMeshFileReadDefaults(void) {
    FlgMeshFileReadDesc desc;
    flgMeshFileReadDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSkinFileReadDesc flgSkinFileReadDefaults(void) {
    FlgSkinFileReadDesc desc;
    flgSkinFileReadDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgTangleFileReadDesc flgTangleFileReadDefaults(void) {
    FlgTangleFileReadDesc desc;
    flgTangleFileReadDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgTangleFileWriteDesc flgTangleFileWriteDefaults(void) {
    FlgTangleFileWriteDesc desc;
    flgTangleFileWriteDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgStroke flgStrokeDefaults(void) {
    FlgStroke stroke;
    flgStrokeInit(&stroke, (uint32_t)sizeof stroke);
    return stroke;
}

static inline FlgMeshFaceColumn flgMeshFaceColumnDefaults(void) {
    FlgMeshFaceColumn column;
    flgMeshFaceColumnInit(&column, (uint32_t)sizeof column);
    return column;
}

static inline FlgTexture flgTextureDefaults(void) {
    FlgTexture texture;
    flgTextureInit(&texture, (uint32_t)sizeof texture);
    return texture;
}

static inline FlgMorphTarget flgMorphTargetDefaults(void) {
    FlgMorphTarget target;
    flgMorphTargetInit(&target, (uint32_t)sizeof target);
    return target;
}

static inline FlgMorphAnimation flgMorphAnimationDefaults(void) {
    FlgMorphAnimation animation;
    flgMorphAnimationInit(&animation, (uint32_t)sizeof animation);
    return animation;
}

static inline FlgMeshMaterial flgMeshMaterialDefaults(void) {
    FlgMeshMaterial material;
    flgMeshMaterialInit(&material, (uint32_t)sizeof material);
    return material;
}

static inline FlgCurveFileInfo flgCurveFileInfoDefaults(void) {
    FlgCurveFileInfo info;
    flgCurveFileInfoInit(&info, (uint32_t)sizeof info);
    return info;
}

static inline FlgCurveFileWriteDesc flgCurveFileWriteDefaults(void) {
    FlgCurveFileWriteDesc desc;
    flgCurveFileWriteDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgMeshFileInfo flgMeshFileInfoDefaults(void) {
    FlgMeshFileInfo info;
    flgMeshFileInfoInit(&info, (uint32_t)sizeof info);
    return info;
}

static inline FlgMeshFileWriteDesc flgMeshFileWriteDefaults(void) {
    FlgMeshFileWriteDesc desc;
    flgMeshFileWriteDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSkinFileInfo flgSkinFileInfoDefaults(void) {
    FlgSkinFileInfo info;
    flgSkinFileInfoInit(&info, (uint32_t)sizeof info);
    return info;
}

static inline FlgVrm flgVrmDefaults(void) {
    FlgVrm vrm;
    flgVrmInit(&vrm, (uint32_t)sizeof vrm);
    return vrm;
}

static inline FlgSkinFileWriteDesc flgSkinFileWriteDefaults(void) {
    FlgSkinFileWriteDesc desc;
    flgSkinFileWriteDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgMotionFileWriteDesc flgMotionFileWriteDefaults(void) {
    FlgMotionFileWriteDesc desc;
    flgMotionFileWriteDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
