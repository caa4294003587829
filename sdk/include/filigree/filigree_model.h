/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Models made from drawn parts (Ma, Wang, Li, Zhang: Real-time skeletonization for sketch-based modeling, 2021).
 * Follows the grammar of filigree.h.
 *
 * Part         A contour with its axis, in its own plane. Made once, when the contour is drawn.
 * Model        Parts in their places, with one tree of joints. Moving a part or changing a threshold makes a new model
 *              from the same parts in a tenth of a ms, so a dragged part can show its bones in every frame.
 * Skin         A model's surface in one piece, bound to its joints.
 *
 * All three never change once ready, and keep their inputs alive. Lengths in a drawing are in its own unit; a part's
 * placement maps them to the model's space, in metres.
 */
#ifndef FILIGREE_FILIGREE_MODEL_H
#define FILIGREE_FILIGREE_MODEL_H

#include "filigree_skeleton.h"
#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A surface's silhouette from afar, as a contour. Never changes once ready. */
FLG_HANDLE(FlgOutline);
/* A drawn contour with its axis. Never changes once ready. */
FLG_HANDLE(FlgPart);
/* A part's own inflated surface. Never changes once ready. */
FLG_HANDLE(FlgPartMesh);
/* Parts in their places and one tree of joints. Never changes once ready. */
FLG_HANDLE(FlgModel);
/* A model's surface, bound to its joints. Never changes once ready. */
FLG_HANDLE(FlgSkin);

/* ---- Outlines of what nobody drew ------------------------------------------------------------------------------ */

typedef struct FlgOutlineDesc {
    uint32_t struct_size;
    uint32_t region_count;
    const FlgJobOptions* job;
    FlgSurface surface;
    const uint32_t* regions; /* labels of the surface; null: the whole surface. Copied */
    float direction[3];      /* towards the viewer, of any length; 0 0 0: the average normal of the triangles, which
                                suits flat regions. Default 0 0 0 */
    uint32_t reserved;
} FlgOutlineDesc;

FLG_API FlgResult flgOutlineDescInit(FlgOutlineDesc* desc, uint32_t struct_size);

/* Starts a job that finds the silhouette of a surface or its regions from afar, or the border of a flat region; of
 * several pieces the largest, with its holes. Fails if there are no such triangles or nothing is visible. Without a
 * direction it also fails if the normals cancel out, as on a closed surface. Cost: 40 ns a triangle and 3 us a side of
 * the borders. */
FLG_API FlgResult flgOutlineCreate(FlgContext context, const FlgOutlineDesc* desc, FlgOutline* out_outline,
                                   FlgJob* out_job);

/* Ready to become a part: `contour` for FlgPartDesc, `placement` for FlgModelPart. */
typedef struct FlgOutlineView {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgContourView* contour; /* metres, in the plane through the middle of the triangles; y points up as far as
                                      possible */
    double placement[12];          /* maps the contour back to the surface */
    double origin[3];              /* metres: what the placement's positions are relative to: the surface's origin */
} FlgOutlineView;

FLG_API FlgResult flgOutlineViewInit(FlgOutlineView* view, uint32_t struct_size);

/* The arrays live until the outline is released. FLG_NOT_READY until its job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgOutlineGetView(FlgContext context, FlgOutline outline, FlgOutlineView* out_view);

FLG_API FlgResult flgOutlineRelease(FlgContext context, FlgOutline outline);

/* ---- Parts ----------------------------------------------------------------------------------------------------- */

/* Fractions are of the part's length: the drawn length of the contour's ring 0, but at most three times its box
 * diagonal (a frayed line does not make a larger drawing). */
typedef struct FlgPartDesc {
    uint32_t struct_size;
    uint32_t repair;  /* nonzero: the contour may cross and touch itself, see FlgStraightSkeletonDesc. Default 0 */
    const FlgJobOptions* job;
    const FlgContourView* contour; /* copied */
    double spacing;   /* distance between resampled points of the drawn line, a fraction: 0.0005 to 0.1, default 0.005;
                         0: as drawn */
    double tolerance; /* how far the axis' outline may deviate from the line, a fraction: 0 to 0.1, default 0.0015 */
    double collapse;  /* removes axis arcs shorter than this fraction of their mean length: 0 to 10, default 0.5 */
} FlgPartDesc;

FLG_API FlgResult flgPartDescInit(FlgPartDesc* desc, uint32_t struct_size);

/* Starts a job that finds the axis of a contour, sec. 3.1 of the paper. It resamples the contour at equal distances,
 * keeps the points that matter (the outline), and makes their straight skeleton. It drops arcs that end on the outline
 * and short arcs, then fits smooth curves to the branches and cuts slices across them. Where the outline would cross
 * itself, the job reduces the tolerance, down to the line as drawn. Reports invalid contours as
 * flgStraightSkeletonCreate does; it may smooth away crossings much smaller than the spacing. Around a hole the axis
 * passes on one side only: bones cannot form cycles. Cost: 0.1 to 0.3 ms for a drawn contour. */
FLG_API FlgResult flgPartCreate(FlgContext context, const FlgPartDesc* desc, FlgPart* out_part, FlgJob* out_job);

/* A point on a branch's axis, with the slice across it. */
typedef struct FlgAxisSample {
    double x, y;           /* on the axis */
    double left_x, left_y; /* unit vector to the left of the axis */
    double left, right;    /* extent of the slice to either side: to the outline, or to twice the axis' clearance */
} FlgAxisSample;

typedef struct FlgPartView {
    uint32_t struct_size;
    uint32_t outline_count;         /* points */
    const double* outline;          /* 2 per point */
    const uint32_t* outline_rings;  /* ring_count + 1 values: the start of each ring, then outline_count */
    uint32_t ring_count;
    uint32_t node_count;            /* of the axis; at least 1 */
    const double* nodes;            /* 3 per node: x, y, and the radius of a disc around it inside the outline */
    const uint32_t* arcs;           /* 2 per arc: nodes; node_count - 1 arcs */
    const FlgAxisSample* samples;   /* of all branches, consecutively */
    const uint32_t* branches;       /* 4 per branch: its first and last node; its first sample, and one past its last */
    uint32_t sample_count;
    uint32_t branch_count;          /* 0 if the axis is one node */
    double length;                  /* the length that fractions refer to */
} FlgPartView;

FLG_API FlgResult flgPartViewInit(FlgPartView* view, uint32_t struct_size);

/* The arrays live until the part is released. FLG_NOT_READY until its job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgPartGetView(FlgContext context, FlgPart part, FlgPartView* out_view);

FLG_API FlgResult flgPartRelease(FlgContext context, FlgPart part);

/* ---- Bodies of parts --------------------------------------------------------------------------------------------- */

typedef struct FlgPartMeshDesc {
    uint32_t struct_size;
    float thickness; /* 0.01 to 100, default 1: a disc becomes a ball, a long strip a tube 1.4 times as deep as wide */
    const FlgJobOptions* job;
    FlgPart part;
    double spacing;  /* edge length, in units of the drawing, 1e-4 to 1 of the part's length; 0: automatic, for 500 to
                        3,000 vertices. Default 0 */
} FlgPartMeshDesc;

FLG_API FlgResult flgPartMeshDescInit(FlgPartMeshDesc* desc, uint32_t struct_size);

/* Starts a job that inflates a part, sec. 4.1: it triangulates the contour with interior points, solves a Poisson
 * equation for the height, and joins both sides. The surface is closed and manifold, also around holes. Cost: 3 ms for
 * 700 vertices. */
FLG_API FlgResult flgPartMeshCreate(FlgContext context, const FlgPartMeshDesc* desc, FlgPartMesh* out_mesh,
                                    FlgJob* out_job);

typedef struct FlgPartMeshView {
    uint32_t struct_size;
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t reserved;
    const float* positions;    /* 3 per vertex, units of the drawing; z is the height above its plane */
    const uint32_t* triangles; /* 3 per triangle, counter-clockwise seen from outside */
} FlgPartMeshView;

FLG_API FlgResult flgPartMeshViewInit(FlgPartMeshView* view, uint32_t struct_size);

/* The arrays live until the mesh is released. FLG_NOT_READY until its job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgPartMeshGetView(FlgContext context, FlgPartMesh mesh, FlgPartMeshView* out_view);

FLG_API FlgResult flgPartMeshRelease(FlgContext context, FlgPartMesh mesh);

/* ---- Models ---------------------------------------------------------------------------------------------------- */

/* Resolution of the bones. The four are fractions of the model's size, the largest length among its placed parts: 0 to
 * 10 each. The defaults give a person some 20 joints. The paper's are 0.0025, 0.015, 0.015 and 0.005, with detail 0. */
typedef struct FlgBoneThresholds {
    uint32_t struct_size;
    float simplify; /* how far joints along a branch may deviate from axis and shape; default 0.01 */
    float merge;    /* merges junctions closer than this along the bones; default 0.03 */
    float prune;    /* removes shorter branches that lead to an end; default 0.03 */
    float collapse; /* removes bones shorter than this with bones at both ends; default 0.01 */
    float detail;   /* one number for all: divides the four, and gives limbs more joints the longer they are for their
                       width, in equal limbs the same number: 2 is finer, 0.5 coarser. 0.05 to 20; 0: the four alone,
                       as they are. Default 1 */
} FlgBoneThresholds;

FLG_API FlgResult flgBoneThresholdsInit(FlgBoneThresholds* thresholds, uint32_t struct_size);

/* A part, its place in a model, and its refinement there. */
typedef struct FlgModelPart {
    uint32_t struct_size; /* the same of all parts of a model */
    uint32_t branch_count; /* the part's count, if branch_simplify is given */
    FlgPart part;         /* may be used more than once; its job may still run */
    const char* name;     /* UTF-8, 1 to 63 bytes, unique; null: "part" and its number */
    double placement[12]; /* rows of a 3 x 4 matrix that maps (x, y, 0, 1) to the model's space: rotation, uniform
                             scale, translation, optional mirroring. Default: as drawn */
    float thickness;      /* depth of the part relative to the paper's inflation: 0.01 to 100, default 1; a disc
                             becomes a ball */
    /* Overlapping parts become one piece, and their weights blend, but for these, which a skin does not weld: limbs
     * that cross another part away from where they hang, desc.apart_pairs, and a part and its mirror image where the
     * part's axis is on one side of the mirror. See `depth`. */
    uint32_t mirrored;                   /* nonzero: adds a copy mirrored at desc.mirror; names end with .L and .R,
                                            .L on the side of the plane's normal. Default 0 */
    const FlgBoneThresholds* thresholds; /* null: the model's */
    const float* branch_simplify;        /* one per branch of the part; negative: the part's value; null: the part's
                                            value for all */
    uint32_t parent;                     /* index in desc.parts of the part it attaches to, wherever both are; its own
                                            index: none; FLG_NO_INDEX: found. Default FLG_NO_INDEX */
    /* Which of two parts passes in front where their skins would cut through each other: that of greater depth, else
     * the one whose plane is farther in front, else the one drawn later. Front is where the trunk's plane faces; in a
     * mirror image across it, the back. The skin moves limbs out of their planes, rising from where they hang, by no
     * more than that takes. Finite, default 0. */
    float depth;
    const char* parent_joint;            /* key of the parent's joint that it attaches to; null, or not there: the
                                            nearest place. Default null */
    /* The rectangle of its drawing that a picture covers: left, bottom, right, top, units of the contour. It gives the
     * skin texture coordinates: the part is projected along the plane of its drawing, front and back alike, and a
     * mirror image shows the mirrored picture. Right above left and top above bottom, or all 0: none. Default 0 */
    double picture[4];
} FlgModelPart;

/* What a host or its user sets about a joint. */
typedef enum FlgJointEditKind {
    FLG_JOINT_EDIT_KIND_PIN = 0,    /* the joint stays at `at`, also if that moves it, and is never refined away; one
                                       that is not there is made on the nearest bone of its part */
    FLG_JOINT_EDIT_KIND_SPLIT = 1,  /* a new joint, with `name` as its key, on the bone from its parent, at `share` */
    FLG_JOINT_EDIT_KIND_MERGE = 2,  /* the joint becomes one with its parent, which stays where it is */
    FLG_JOINT_EDIT_KIND_RENAME = 3, /* the joint is called `name`; its key stays */
    FLG_JOINT_EDIT_KIND_FORCE_32BIT = 0x7fffffff
} FlgJointEditKind;

/* Joints are told by their keys (FlgModelView::joint_keys), which survive edits of the drawing: pass the same list with
 * every model. A key without its .L or .R means both. Edits of joints that are not there wait until they are. */
typedef struct FlgJointEdit {
    uint32_t struct_size; /* the same of all edits of a model */
    FlgJointEditKind kind; /* default FLG_JOINT_EDIT_KIND_PIN */
    const char* joint;    /* its key */
    const char* name;     /* for SPLIT and RENAME: UTF-8, 1 to 127 bytes, unique in the model; default null */
    double at[3];         /* for PIN: in the drawing of the joint's part, z at right angles to it; inside of the part.
                             Default 0 */
    double share;         /* for SPLIT: 0 at the parent, 1 at the joint, exclusive; default 0.5 */
} FlgJointEdit;

FLG_API FlgResult flgJointEditInit(FlgJointEdit* edit, uint32_t struct_size);

/* How a part was attached to the model. */
typedef enum FlgPartEvent {
    FLG_PART_EVENT_ROOT = 0,          /* meets no earlier part */
    FLG_PART_EVENT_BONE_SPLIT = 1,    /* a new joint on a bone of its parent part */
    FLG_PART_EVENT_JOINT_CONNECT = 2, /* a bone from one of its parent part's joints */
    FLG_PART_EVENT_FORCE_32BIT = 0x7fffffff
} FlgPartEvent;

/* Joints, parents first. The bone to a joint turns with its parent. Parts include mirror images, each after its
 * original. */
typedef struct FlgModelView {
    uint32_t struct_size;
    uint32_t joint_count;           /* at least 1 */
    const float* joint_positions;   /* 3 per joint, metres */
    const float* joint_radii;       /* radius of the shape around the joint, metres */
    const uint32_t* joint_parents;  /* FLG_NO_INDEX: a root */
    const uint32_t* joint_parts;    /* the part each joint lies in */
    const char* const* joint_names; /* the joint's key, unless it was renamed */
    uint32_t part_count;
    float size;                      /* the size that thresholds are fractions of, metres */
    const FlgPartEvent* part_events; /* one per part: how it was connected, before refinement of bones */
    const uint32_t* part_parents;    /* one per part: its parent part; FLG_NO_INDEX: none */
    const uint32_t* part_joints;     /* one per part: its own joint nearest to the root, which swings it; if it has none
                                        left, the joint that moves it */
    const uint32_t* part_sources;    /* one per part: index of the host's part */
    const uint32_t* part_twins;      /* one per part: its mirror image; FLG_NO_INDEX: none */
    const uint8_t* part_mirrored;    /* one per part: 1 for a mirror image, 0 for a drawn part */
    double origin[3];              /* metres: what positions are relative to */
    const char* const* joint_keys; /* what edits know a joint by: the part's name, then a number: tail_0, tail_1, ...,
                                      arm_0.L, ...; where a part attaches: torso_at_arm; the middle of a trunk:
                                      torso_root */
    const double* joint_places;    /* 3 per joint: where it is in the drawing of its part, as FlgJointEdit::at */
    const uint8_t* joint_pinned;   /* one per joint: 1 if an edit pins it */
} FlgModelView;

typedef struct FlgModelDesc {
    uint32_t struct_size;
    uint32_t part_count;       /* 1 to 4096 */
    const FlgJobOptions* job;
    const FlgModelPart* parts; /* in modelling order: the trunk comes first wherever it is, then a part attaches to an
                                  earlier one */
    const FlgBoneThresholds* thresholds; /* null: the defaults */
    float shape_weight;        /* weight of the shape in `simplify`, alpha_s of Eq. 1 (the paper gives no number): 0 to
                                  100, default 0.25 */
    /* A plane a x + b y + c z = d. Its normal may have any length above 0 and points to the model's left (0 0 -1 for a
     * model that looks along +x, y up). A part across the plane is doubled in place. Default 1 0 0 0 */
    float mirror[4];
    uint32_t apart_pair_count; /* up to 65535. Default 0 */
    double origin[3]; /* metres: what placements and `mirror` are relative to. Default 0 */
    uint32_t root;                   /* the trunk, an index of parts: the hierarchy begins there. FLG_NO_INDEX: the
                                        part of the largest area that is not mirrored. Default FLG_NO_INDEX */
    uint32_t joint_edit_count;       /* up to 65535. Default 0 */
    const char* root_joint;          /* key of the root part's joint; null, or not there: its middle. Default null */
    const FlgJointEdit* joint_edits; /* applied in order; copied. Default null */
    FlgModel previous;               /* what this model was before its parts changed: joints keep the keys they have in
                                        it, by part and place. Its job may still run. Default null: keys are new */
    const uint32_t* apart_pairs;     /* 2 per pair: indices of parts that a skin does not weld where they touch, images
                                        included; twice the same: a part and its mirror image. A part and what it hangs
                                        on are joined there all the same. Copied. Default null */
    const FlgModelView* previous_view; /* in place of `previous`, what a file kept of that model: joint_count,
                                          joint_keys, joint_places and joint_parents; the rest is not read. Copied, 0.1
                                          us a joint. Default null */
} FlgModelDesc;

FLG_API FlgResult flgModelPartInit(FlgModelPart* part, uint32_t struct_size);
FLG_API FlgResult flgModelDescInit(FlgModelDesc* desc, uint32_t struct_size);

/* Starts a job that makes one skeleton from the parts, sec. 3.1 (BoundedDP), 3.2 and 3.3 of the paper: it places joints
 * along the branches, connects parts, merges junctions, and removes short branches and bones. The hierarchy begins in
 * the middle of the trunk; a part that meets no other is another root. Joints of one contour that is its own mirror
 * image are mirror images too. The job fails if an edit pins a joint outside of its part, merges a root or gives two
 * joints one name; the model before it stays as it was. FLG_ERROR_LIMIT above 65535 joints. Cost: 20 us a part. */
FLG_API FlgResult flgModelCreate(FlgContext context, const FlgModelDesc* desc, FlgModel* out_model, FlgJob* out_job);

FLG_API FlgResult flgModelViewInit(FlgModelView* view, uint32_t struct_size);

/* The arrays live until the model is released. FLG_NOT_READY until its job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgModelGetView(FlgContext context, FlgModel model, FlgModelView* out_view);

FLG_API FlgResult flgModelRelease(FlgContext context, FlgModel model);

/* ---- Skins ----------------------------------------------------------------------------------------------------- */

/* A surface in one piece and the joints that move it, in the rest pose: no joint is rotated. */
typedef struct FlgSkinView {
    uint32_t struct_size;
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t joint_count;           /* 1 to 65535 */
    const float* positions;         /* 3 per vertex, metres */
    const float* normals;           /* 3 per vertex, of length 1 */
    const uint32_t* triangles;      /* 3 per triangle, counter-clockwise seen from outside */
    const uint16_t* vertex_joints;  /* 4 per vertex: joints that move it, largest weight first; unused ones are 0 */
    const float* vertex_weights;    /* 4 per vertex: 0 to 1, with sum 1; unused ones are 0 */
    const uint32_t* vertex_parts;   /* one per vertex: the part it lies on */
    const float* joint_positions;   /* 3 per joint, metres, in the model's space: the model's, moved with limbs that
                                       pass in front of others or behind (FlgModelPart::depth) */
    const uint32_t* joint_parents;  /* one per joint, lower than its own index; FLG_NO_INDEX: a root */
    const char* const* joint_names; /* one per joint, UTF-8, unique; null in input: none */
    double origin[3];               /* metres: what positions are relative to. Default 0 */
    const float* joint_radii;       /* one per joint: radius of the shape around it, metres; null in input: not known */
    float mirror[4];                /* a x + b y + c z = d: the plane of its mirror image, whose normal points to its
                                       left; 0: none. Ignored in input */
    const uint32_t* triangle_parts; /* one per triangle: the part it lies on. These meet at edges that follow the parts'
                                       border. Null in input: that of two corners, else of the first */
    const float* corner_uvs;        /* 6 per triangle: u, v of its corners, 0 0 at the picture's upper left, 1 1 at its
                                       lower right; parts without a picture: 0. Corners of a vertex differ only where
                                       parts with different projections meet. Null: no part has a picture */
} FlgSkinView;

typedef struct FlgSkinDesc {
    uint32_t struct_size;
    uint32_t vertex_count;      /* within 2 %, or more if a part is too thin for so few: 100 to max_vertices, default
                                   10000 */
    const FlgJobOptions* job;
    FlgModel model;
    uint32_t max_vertices;      /* upper limit where thin parts need more, without borders between parts: 100 to
                                   4194304, default 200000 */
    float blend;                /* rounds edges where parts cross over this length: metres, up to 1e30; below 0:
                                   automatic, 0.15 of the smaller part's radius; 0: none. Default -1 */
    float corner_angle;         /* corners of contours that turn by more than this, within 1.5 edges of the surface,
                                   stay corners: radians, 0 to pi; 0: all are rounded to about an edge's length.
                                   Default 0 */
    uint32_t reserved;
} FlgSkinDesc;

FLG_API FlgResult flgSkinDescInit(FlgSkinDesc* desc, uint32_t struct_size);

/* Starts a job that makes one closed surface from all parts of a model, manifold however they meet, and binds it to the
 * joints: weights are smooth, 0 to 1, at most 4 per vertex. Limbs that cross other parts pass in front or behind
 * (FlgModelPart::depth). Parts that meet no other stay separate pieces. FLG_ERROR_LIMIT if the thinnest part needs more
 * than max_vertices, or if a part lies further from the origin than 1e7 sides of a triangle. Cost: 20 us a vertex. */
FLG_API FlgResult flgSkinCreate(FlgContext context, const FlgSkinDesc* desc, FlgSkin* out_skin, FlgJob* out_job);

typedef struct FlgSkinFromMeshDesc {
    uint32_t struct_size;
    uint32_t cell_count;      /* of the lattice that the inside is looked at in: 1000 to 16777216, default 600000. Limbs
                                 of less than two cells get no bones of their own */
    const FlgJobOptions* job;
    const FlgMeshView* mesh;  /* up to 1048576 vertices; copied. Columns other than position and normal are not read */
    float weld_distance;      /* metres: nearer vertices move alike; below 0: none do. Default 0: those at one place */
    float up[3];              /* of any length above 0. Default 0 1 0 */
    float left[3];            /* to the model's left, if it is its own mirror image. 0 0 0: found; the model looks where
                                 its head is if it stands on four legs, else where its feet point. Default 0 0 0 */
    uint32_t reserved;
    const FlgBoneThresholds* thresholds; /* shares of three times the mesh's diagonal; null: the defaults */
} FlgSkinFromMeshDesc;

FLG_API FlgResult flgSkinFromMeshDescInit(FlgSkinFromMeshDesc* desc, uint32_t struct_size);

/* Starts a job that gives a mesh joints and weights. The skin has the mesh's own vertices and triangles in their order,
 * so all that belongs to them (texture coordinates, colours, morph targets) still fits; its normals are the mesh's, or
 * found if it has none. The mesh should be closed: past holes what is inside is guessed, and what is thinner than a
 * cell counts as inside. Pieces that do not touch hang on the nearest one.
 * The hierarchy begins in the middle of the trunk. Limbs that stand out get bones; sheets and bulges don't. A mesh that
 * is its own mirror image within 3 % gets joints that are mirror images too. Joints have names as drawn ones: body_0,
 * head_0, arm_1.L; flgRigFind takes them with `joint_radii` and `mirror`. The lattice turns with the mesh.
 * Fails for meshes without triangles. FLG_ERROR_LIMIT above 65535 joints. Cost: 0.25 s, and 15 us a vertex. */
FLG_API FlgResult flgSkinCreateFromMesh(FlgContext context, const FlgSkinFromMeshDesc* desc, FlgSkin* out_skin,
                                        FlgJob* out_job);

/* The arrays live until the skin is released. FLG_NOT_READY until its job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgSkinGetView(FlgContext context, FlgSkin skin, FlgSkinView* out_view);

FLG_API FlgResult flgSkinRelease(FlgContext context, FlgSkin skin);

typedef struct FlgSkinSimplifyDesc {
    uint32_t struct_size;
    uint32_t vertex_count; /* at least 4. No default */
    const FlgJobOptions* job;
    FlgSkin skin;
} FlgSkinSimplifyDesc;

FLG_API FlgResult flgSkinSimplifyDescInit(FlgSkinSimplifyDesc* desc, uint32_t struct_size);

/* Starts a job that makes a level of detail: the same surface, parts and joints with fewer vertices. Edges are
 * collapsed, those first that change the shape least; where weights change more stay. Borders of parts and sharp
 * corners stay where they are, pieces and holes remain, and a vertex has the weights of its place on the surface. So
 * few vertices may not be reachable: then the result has the fewest that are. With as many as the skin has, or more,
 * it is a copy. Cost: about 2 us a vertex of the skin and 20 us for each that goes. */
FLG_API FlgResult flgSkinSimplify(FlgContext context, const FlgSkinSimplifyDesc* desc, FlgSkin* out_skin,
                                  FlgJob* out_job);

typedef struct FlgSkinSetWeightsDesc {
    uint32_t struct_size;
    uint32_t vertex_count;         /* the skin's, as in FlgSkinView. No default */
    const FlgJobOptions* job;
    FlgSkin skin;                  /* its job may still run */
    const uint16_t* vertex_joints; /* 4 per vertex, below the skin's joint_count; those of weight 0 are not read.
                                      Copied */
    const float* vertex_weights;   /* 4 per vertex, in any order: 0 to 1, with sum 1 within 0.001. Copied */
} FlgSkinSetWeightsDesc;

FLG_API FlgResult flgSkinSetWeightsDescInit(FlgSkinSetWeightsDesc* desc, uint32_t struct_size);

/* Starts a job that makes the same skin with other weights, as painted ones: all else is the source's, which stays as
 * it is. Weights get the sum 1 and the largest first; a joint that a vertex has twice gets both weights. Weights out of
 * range are refused at once; another vertex_count than the skin's, or a joint that it does not have, makes the job fail
 * with FLG_ERROR_INVALID_ARGUMENT. Cost: 20 ns a vertex in the call, 0.1 us in the job. */
FLG_API FlgResult flgSkinSetWeights(FlgContext context, const FlgSkinSetWeightsDesc* desc, FlgSkin* out_skin,
                                    FlgJob* out_job);

/* A motion of a skin's joints. */
typedef struct FlgSkinAnimation {
    uint32_t struct_size;
    uint32_t key_count;        /* at least 1 */
    const char* name;          /* UTF-8 */
    const float* times;        /* one per key, seconds, ascending, from 0 or later */
    const float* rotations;    /* 4 per joint, joint by joint, key by key: x, y, z, w of length 1, in the parent's
                                  frame */
    const float* translations; /* 3 per key: translation of all roots, metres; null: none */
} FlgSkinAnimation;

/* ---- Poses of skins ---------------------------------------------------------------------------------------------
 * [any thread] All functions here: they need no context and keep no state. They check their input before they write
 * anything: on failure arrays stay unchanged. Rotating a joint rotates everything attached to it about its position:
 * bones keep their lengths. */

FLG_API FlgResult flgSkinViewInit(FlgSkinView* view, uint32_t struct_size);

FLG_API FlgResult flgSkinAnimationInit(FlgSkinAnimation* animation, uint32_t struct_size);

/* How a vertex follows several joints. */
typedef enum FlgSkinning {
    FLG_SKINNING_LINEAR = 0,          /* the mean of the positions each joint gives: thins out where joints twist */
    FLG_SKINNING_DUAL_QUATERNION = 1, /* one rigid motion between the joints': keeps the girth, bulges a little in sharp
                                         bends */
    FLG_SKINNING_FORCE_32BIT = 0x7fffffff
} FlgSkinning;

/* The transform of each joint from rest to a pose.
 *   rotations             4 per joint: x, y, z, w of length 1 within 0.001, in the parent's frame, as in
 *                         FlgSkinAnimation; null: no rotations
 *   translation           3: translation of all roots, metres; null: none
 *   out_matrices          12 per joint, or null: three rows of four. The rows times (x, y, z, 1) at rest give the
 *                         position in the pose
 *   out_dual_quaternions  8 per joint, or null: x, y, z, w of the rotation r, then those of (t r) / 2, where t
 *                         translates after it
 * Reads only the skin's joints. Cost: about 50 ns a joint; takes no memory for up to 256 joints, else 56 bytes a joint
 * of the C++ runtime's. */
FLG_API FlgResult flgSkinPose(const FlgSkinView* skin, const float* rotations, const float* translation,
                              float* out_matrices, float* out_dual_quaternions);

/* The pose of an animation at a time, ready for flgSkinPose. Between keys rotations turn evenly the shorter way, and
 * translations are linear. Before the first key and after the last, the pose is constant.
 *   joint_count      the skin's
 *   time             seconds, finite
 *   out_rotations    4 per joint
 *   out_translation  3, or null; 0 if the animation moves no roots
 * Cost: about 80 ns a joint, 1 ns a key: all times are checked, and of the rest the two keys that are used. */
FLG_API FlgResult flgSkinAnimationSample(const FlgSkinAnimation* animation, uint32_t joint_count, float time,
                                         float* out_rotations, float* out_translation);

/* Deforms the vertices on the CPU: the reference for a vertex shader.
 *   transforms     from flgSkinPose: 12 per joint (FLG_SKINNING_LINEAR) or 8 (FLG_SKINNING_DUAL_QUATERNION)
 *   out_positions  3 per vertex
 *   out_normals    3 per vertex, of length 1, rotated as their vertices are; null: not needed
 * The joint with a vertex' largest weight decides the sign of equivalent dual quaternions. Weights must sum to 1 within
 * 0.0001, the largest first. Cost: about 0.1 us a vertex, one pass to check and one to move. */
FLG_API FlgResult flgSkinDeform(const FlgSkinView* skin, FlgSkinning skinning, const float* transforms,
                                float* out_positions, float* out_normals);

static inline FlgSkinView flgSkinViewDefaults(void) {
    FlgSkinView view;
    flgSkinViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSkinAnimation flgSkinAnimationDefaults(void) {
    FlgSkinAnimation animation;
    flgSkinAnimationInit(&animation, (uint32_t)sizeof animation);
    return animation;
}

/* ---- Defaults by value, parts and models -------------------------------------------------------------------- */

static inline FlgOutlineDesc flgOutlineDefaults(void) {
    FlgOutlineDesc desc;
    flgOutlineDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgOutlineView flgOutlineViewDefaults(void) {
    FlgOutlineView view;
    flgOutlineViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgPartDesc flgPartDefaults(void) {
    FlgPartDesc desc;
    flgPartDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgPartView flgPartViewDefaults(void) {
    FlgPartView view;
    flgPartViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgPartMeshDesc flgPartMeshDefaults(void) {
    FlgPartMeshDesc desc;
    flgPartMeshDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgPartMeshView flgPartMeshViewDefaults(void) {
    FlgPartMeshView view;
    flgPartMeshViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSkinDesc flgSkinDefaults(void) {
    FlgSkinDesc desc;
    flgSkinDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSkinFromMeshDesc flgSkinFromMeshDefaults(void) {
    FlgSkinFromMeshDesc desc;
    flgSkinFromMeshDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSkinSimplifyDesc flgSkinSimplifyDefaults(void) {
    FlgSkinSimplifyDesc desc;
    flgSkinSimplifyDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSkinSetWeightsDesc flgSkinSetWeightsDefaults(void) {
    FlgSkinSetWeightsDesc desc;
    flgSkinSetWeightsDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgModelPart flgModelPartDefaults(void) {
    FlgModelPart part;
    flgModelPartInit(&part, (uint32_t)sizeof part);
    return part;
}

static inline FlgBoneThresholds flgBoneThresholdsDefaults(void) {
    FlgBoneThresholds thresholds;
    flgBoneThresholdsInit(&thresholds, (uint32_t)sizeof thresholds);
    return thresholds;
}

static inline FlgJointEdit flgJointEditDefaults(void) {
    FlgJointEdit edit;
    flgJointEditInit(&edit, (uint32_t)sizeof edit);
    return edit;
}

static inline FlgModelDesc flgModelDefaults(void) {
    FlgModelDesc desc;
    flgModelDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgModelView flgModelViewDefaults(void) {
    FlgModelView view;
    flgModelViewInit(&view, (uint32_t)sizeof view);
    return view;
}

#ifdef __cplusplus
}
#endif

#endif
