// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The Filigree authors
// Written by tools/abi/generate from sdk/api/abi.json and tools/abi/wrapper_parts.hpp: change the C headers, or that.
// clang-format off

/// @file filigree.hpp
/// Filigree for C++17 and later: all of the C ABI, with owners instead of handles. Header only, and nothing that the C
/// functions don't do; use both side by side.
///
///     auto context = filigree::Context::create();
///     filigree::CurveSet example = context.curve_set(view);
///     filigree::Style style = context.style({example});
///     filigree::CurveSet result = context.stylize({style, target});
///     while (!result.ready()) context.tick(2000);  // once a frame
///     draw(result.view());
///
/// Names: `flgNounGetThing(context, noun)` is `noun.thing()`, `flgNounVerb(context, noun)` is `noun.verb()`, and so is
/// `flgNounVerb(context, desc)` if all that the descriptor needs is that noun, which is filled in. `flgNounCreate` is
/// `context.noun`, `flgNounCreateFromThing` is `context.noun_from_thing`; all else that takes a context and a
/// descriptor is `context.verb(desc)`. Without a context: `CurveFile::read(path)`, or the C name,
/// `formula_name(number)`.
///
/// Types: `Flg` is left out. Owners (CurveSet, CurveFile) release what they hold; they are movable, convert to their
/// handle, and must not outlive their context. Descriptors (StyleDesc) begin with their defaults, or with the handles
/// they need; set_...() sets an array with its count. Views (CurveSetView) have the C struct's fields, arrays as spans;
/// they own nothing.
///
/// Failures: with exceptions, calls throw Error, and `Result<T>` is T. Without (or with FILIGREE_NO_EXCEPTIONS defined)
/// they return `Result<T>`, which holds the value or what failed. FLG_NOT_READY is no failure: the value is then false,
/// empty or null. Nothing here needs RTTI.
///
/// Threads, costs, units: as the C functions say. Programs that call io or pick link them.
#ifndef FILIGREE_FILIGREE_HPP
#define FILIGREE_FILIGREE_HPP

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "filigree_all.h"

#if !defined(FILIGREE_NO_EXCEPTIONS) && !defined(__cpp_exceptions)
/// Calls return `Result<T>` and throw nothing. Define it yourself to have that with exceptions, too.
#define FILIGREE_NO_EXCEPTIONS
#endif
#ifndef FILIGREE_NO_EXCEPTIONS
#include <stdexcept>
#endif

namespace filigree {

#ifdef FILIGREE_NO_EXCEPTIONS
// Apart from the throwing kind, so that a program may have files of both.
inline namespace no_exceptions {

/// A call's value, or why it has none.
template <class T>
class [[nodiscard]] Result {
public:
    /// Holds a value, of a call that returned `result`, with its sentence if that is a failure.
    Result(FlgResult result, const char* message, T value)
        : result_(result), message_(message), value_(std::move(value)) {}
    /// The call returned FLG_OK, and of a `Result<bool>` the value is true.
    explicit operator bool() const noexcept {
        if constexpr (std::is_same_v<T, bool>) return result_ == FLG_OK && value_;
        else return result_ == FLG_OK;
    }
    /// Whether it has no value: neither FLG_OK nor FLG_NOT_READY.
    bool failed() const noexcept { return result_ < 0; }
    /// What the C function returned.
    FlgResult result() const noexcept { return result_; }
    /// What failed, in one sentence; valid until the next failing call on this thread. "" if nothing did.
    const char* message() const noexcept { return message_; }
    /// The value. Aborts if the call failed.
    T& value() & { return need(), value_; }
    /// The value. Aborts if the call failed.
    const T& value() const& { return need(), value_; }
    /// The value, to be moved. Aborts if the call failed.
    T&& value() && { return need(), std::move(value_); }
    /// The value. Aborts if the call failed.
    T& operator*() & { return value(); }
    /// The value. Aborts if the call failed.
    const T& operator*() const& { return value(); }
    /// The value, to be moved. Aborts if the call failed.
    T&& operator*() && { return std::move(*this).value(); }
    /// The value's members. Aborts if the call failed.
    T* operator->() { return &value(); }
    /// The value's members. Aborts if the call failed.
    const T* operator->() const { return &value(); }

private:
    void need() const {
        if (failed()) std::abort();
    }

    FlgResult result_;
    const char* message_;
    T value_;
};
#else
/// What a failing call throws; what() is the library's sentence.
class Error : public std::runtime_error {
public:
    /// Of a C function that has just failed on this thread.
    explicit Error(FlgResult result, const char* message = flgErrorGetMessage())
        : std::runtime_error(message), result_(result) {}
    /// What the C function returned.
    FlgResult result() const noexcept { return result_; }

private:
    FlgResult result_;
};

/// A call's value; failures are thrown.
template <class T>
using Result = T;
#endif

/// Consecutive elements that another owns: an array, a vector, a list within one call.
template <class T>
class Span {
public:
    /// Empty.
    constexpr Span() = default;
    /// The first `size` at `data`.
    constexpr Span(T* data, std::size_t size) : data_(data), size_(size) {}
    /// An array.
    template <std::size_t count>
    constexpr Span(T (&array)[count]) : data_(array), size_(count) {}
    /// Whatever has data() and size(): vectors, strings, std::array, std::span.
    template <class Container, class = std::enable_if_t<std::is_convertible_v<
        decltype(std::declval<Container&>().data()), T*>>, class = decltype(std::declval<Container&>().size())>
    constexpr Span(Container&& container) : data_(container.data()), size_(container.size()) {}
    /// A list: for an argument only, it ends with the call.
    template <class Value = T, class = std::enable_if_t<std::is_const_v<Value>>>
    constexpr Span(std::initializer_list<std::remove_const_t<Value>> list) : size_(list.size()) {
        data_ = list.begin();
    }

    /// The first element; null or not if empty.
    constexpr T* data() const noexcept { return data_; }
    /// How many elements there are.
    constexpr std::size_t size() const noexcept { return size_; }
    /// Whether there are none.
    constexpr bool empty() const noexcept { return size_ == 0; }
    /// The first element, for loops.
    constexpr T* begin() const noexcept { return data_; }
    /// Behind the last element, for loops.
    constexpr T* end() const noexcept { return data_ + size_; }
    /// An element below size(), unchecked.
    constexpr T& operator[](std::size_t index) const { return data_[index]; }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

/// The rows of a column, a few floats each, packed or not; another owns them. Empty without such a column, or where its
/// rows have other numbers of floats.
template <std::size_t components>
class Rows {
public:
    /// A row.
    using Row = const float[components];

    /// Empty.
    constexpr Rows() = default;
    /// The first `size` of a column, which may be null.
    Rows(const FlgColumn* column, std::size_t size) {
        if (!column || column->components != components) return;
        data_ = reinterpret_cast<const char*>(column->data);
        stride_ = column->stride != 0 ? column->stride : sizeof(Row);
        size_ = size;
    }

    /// How many rows there are.
    constexpr std::size_t size() const noexcept { return size_; }
    /// Whether there are none.
    constexpr bool empty() const noexcept { return size_ == 0; }
    /// A row below size(), unchecked.
    Row& operator[](std::size_t index) const { return *reinterpret_cast<Row*>(data_ + index * stride_); }

    /// Goes from row to row.
    class Iterator {
    public:
        /// A row of a column.
        Iterator(const Rows& rows, std::size_t index) : rows_(&rows), index_(index) {}
        /// The row.
        Row& operator*() const { return (*rows_)[index_]; }
        /// To the next.
        Iterator& operator++() {
            ++index_;
            return *this;
        }
        /// Whether it is at another row.
        bool operator!=(const Iterator& other) const { return index_ != other.index_; }

    private:
        const Rows* rows_;
        std::size_t index_;
    };
    /// The first row, for loops.
    Iterator begin() const { return {*this, 0}; }
    /// Behind the last row, for loops.
    Iterator end() const { return {*this, size_}; }

private:
    const char* data_ = nullptr;
    std::size_t stride_ = 0, size_ = 0;
};

namespace detail {

template <class Struct>
constexpr uint32_t size_of = static_cast<uint32_t>(sizeof(Struct));

// A call's value, or its failure as this build has failures.
template <const char* (*message)() = flgErrorGetMessage, class T>
Result<T> made(FlgResult result, T value) {
#ifdef FILIGREE_NO_EXCEPTIONS
    return Result<T>(result, result < 0 ? message() : "", std::move(value));
#else
    if (result < 0) throw Error(result, message());
    return value;
#endif
}

template <const char* (*message)() = flgErrorGetMessage>
Result<bool> done(FlgResult result) {
    return made<message>(result, result == FLG_OK);
}

// An array of a view: null is empty, whatever its count.
template <class T>
Span<T> span(T* data, std::size_t size) {
    return {data, data ? size : 0};
}

// Rows of so many numbers. What is too much, or ends within a row, is UINT32_MAX, which every call refuses.
inline uint32_t count(std::size_t size, std::size_t row = 1) {
    return size % row == 0 && size / row < UINT32_MAX ? static_cast<uint32_t>(size / row) : UINT32_MAX;
}

// Owns one handle of a context.
template <class Handle, FlgResult (*release)(FlgContext, Handle)>
class Owner {
public:
    Owner() = default;
    Owner(FlgContext context, Handle handle) noexcept : context_(context), handle_(handle) {}
    Owner(Owner&& other) noexcept : context_(other.context_), handle_(std::exchange(other.handle_, Handle{})) {}
    Owner& operator=(Owner&& other) noexcept {
        if (this == &other) return *this;
        reset();
        context_ = other.context_;
        handle_ = std::exchange(other.handle_, Handle{});
        return *this;
    }
    ~Owner() { reset(); }

    explicit operator bool() const noexcept { return handle_.id != 0; }
    operator Handle() const& noexcept { return handle_; }
    operator Handle() const&& = delete;  // it would be released at the end of the expression
    Handle get() const noexcept { return handle_; }
    void reset() noexcept {
        if (handle_.id != 0) release(context_, std::exchange(handle_, Handle{}));
    }

protected:
    FlgContext context_{};
    Handle handle_{};
};

// Owns an object that needs no context.
template <class Pointer, void (*release)(Pointer)>
class Object {
public:
    Object() = default;
    explicit Object(Pointer pointer) noexcept : handle_(pointer) {}
    Object(Object&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Object& operator=(Object&& other) noexcept {
        if (this == &other) return *this;
        reset();
        handle_ = std::exchange(other.handle_, nullptr);
        return *this;
    }
    ~Object() { reset(); }

    explicit operator bool() const noexcept { return handle_ != nullptr; }
    Pointer get() const noexcept { return handle_; }
    void reset() noexcept {
        if (handle_) release(std::exchange(handle_, nullptr));
    }

protected:
    Pointer handle_ = nullptr;
};

// Owns a context.
class ContextOwner {
public:
    ContextOwner() = default;
    explicit ContextOwner(FlgContext context) noexcept : handle_(context) {}
    ContextOwner(ContextOwner&& other) noexcept : handle_(std::exchange(other.handle_, FlgContext{})) {}
    ContextOwner& operator=(ContextOwner&& other) noexcept {
        if (this == &other) return *this;
        reset();
        handle_ = std::exchange(other.handle_, FlgContext{});
        return *this;
    }
    // With a host's job system it waits until that has let go of our tasks: if this thread runs them, call destroy()
    // until it is true first.
    ~ContextOwner() { reset(); }
    /// Destroys the context and all that it owns. False while the host's job system still holds its tasks: run them,
    /// then call again. The destructor waits for that on its thread.
    Result<bool> destroy() {
        const FlgResult result = flgContextDestroy(handle_);
        if (result == FLG_OK) handle_ = {};
        return done(result);
    }

    explicit operator bool() const noexcept { return handle_.id != 0; }
    FlgContext get() const noexcept { return handle_; }
    void reset() noexcept {
        while (flgContextDestroy(handle_) == FLG_NOT_READY) std::this_thread::yield();
        handle_ = {};
    }

protected:
    FlgContext handle_{};
};

}  // namespace detail

/// For C functions called directly: true for FLG_OK, false for FLG_NOT_READY; all else is a failure.
inline Result<bool> check(FlgResult result) { return detail::done(result); }

/// How a call or a job ended; negative values are failures.
using ResultCode = FlgResult;

/// How much a message matters.
using LogLevel = FlgLogLevel;

/// What memory is for.
using MemoryKind = FlgMemoryKind;

/// Which ready job runs first.
using Priority = FlgPriority;

/// Where a job is, as of the last flgContextTick.
using JobState = FlgJobState;

/// Why a job does not go on.
using JobWait = FlgJobWait;

/// What a column of a curve set means, and its number of floats per point:
using Attribute = FlgAttribute;

/// How a number is stored in the host's buffers. Values beyond a format's range become the nearest that it holds; what
/// is no number (NaN) becomes its least. FLOAT32 keeps all bits.
using NumberFormat = FlgNumberFormat;

/// Which moving frame to carry along a curve.
using FrameMethod = FlgFrameMethod;

/// Distance between two values of an attribute, sec. 5.
using Metric = FlgMetric;

/// Where on the style a target curve begins.
using StyleStart = FlgStyleStart;

/// What a column of the target can drive along it.
using StyleDriven = FlgStyleDriven;

/// What a style does at the corners of its targets.
using StyleCorners = FlgStyleCorners;

/// How triangles are refined.
using Subdivision = FlgSubdivision;

/// How near distances are to those of the triangles.
using Accuracy = FlgAccuracy;

/// The borders an operator starts from.
using TangleBorders = FlgTangleBorders;

/// How an operator divides regions, sec. 3.3 of the paper.
using TangleOperator = FlgTangleOperator;

/// How an operator groups the regions it makes.
using TangleGrouping = FlgTangleGrouping;

/// Common combinations of operators.
using TangleMacro = FlgTangleMacro;

/// The function that made a step.
using TangleStepKind = FlgTangleStepKind;

/// What a step does.
using TangleStepState = FlgTangleStepState;

/// The cross-section of a brush mesh.
using BrushShape = FlgBrushShape;

/// The end of an open curve. An end of radius 0 gets none.
using BrushCap = FlgBrushCap;

/// How the segments on both sides of a corner meet. Smaller turns are always mitered.
using BrushJoin = FlgBrushJoin;

/// In what texture coordinates are measured.
using BrushUv = FlgBrushUv;

/// What a host or its user sets about a joint.
using JointEditKind = FlgJointEditKind;

/// How a part was attached to the model.
using PartEvent = FlgPartEvent;

/// How a vertex follows several joints.
using Skinning = FlgSkinning;

/// What a joint belongs to.
using Limb = FlgLimb;

/// Where an arm or a leg bends.
using LimbPlace = FlgLimbPlace;

/// Who names the bones of a humanoid.
using RigStandard = FlgRigStandard;

/// Motions that show whether a model moves well.
using RigMotion = FlgRigMotion;

/// What a file is opened for.
using FileAccess = FlgFileAccess;

/// Geometry of curves in .glb.
using CurveGeometry = FlgCurveGeometry;

/// How a texture goes on beyond its picture.
using TextureWrap = FlgTextureWrap;

/// Manifolds that need no data.
using ManifoldShape = FlgManifoldShape;

/// The kind of an obstacle; it determines which fields apply.
using ObstacleKind = FlgObstacleKind;

/// The energy a curve minimizes.
using SplineEnergy = FlgSplineEnergy;

/// The initial curve, before optimization.
using SplineStart = FlgSplineStart;

/// Why the optimization ended. A curve is available in each case.
using SplineEnding = FlgSplineEnding;

/// How times of keys come about.
using MotionTiming = FlgMotionTiming;

/// How fast the path is passed.
using MotionPacing = FlgMotionPacing;

/// Where the body's -z points, with its +y upwards, as a camera.
using MotionLook = FlgMotionLook;

/// What to draw of an object; combined with |.
using DebugPart = FlgDebugPart;

/// What one flgContextTick did, and what the workers did since the previous one.
using FrameReport = FlgFrameReport;

/// Bytes of the host's allocator that a context holds.
using MemoryUse = FlgMemoryUse;

/// FlgJobStatus of the C ABI.
using JobStatus = FlgJobStatus;

/// How long a stage of a job took.
using StageTime = FlgStageTime;

/// One column. Input columns may be strided; result columns are tightly packed.
using Column = FlgColumn;

/// Where a column goes in the host's buffers, and as what. Formats: FLOAT32 and FLOAT16 for all numbers but whole ones;
/// SNORM8 and SNORM16 for NORMAL, TANGENT, ORIENTATION and the host's own; OCTAHEDRAL16 for NORMAL and TANGENT; UNORM8
/// and UNORM16 for COLOR, PRESSURE, WEIGHTS, VALUE and the host's own; SRGB8 for COLOR; UINT8, UINT16 and UINT32 for
/// the whole ones: JOINTS, PART, LABEL.
using BufferColumn = FlgBufferColumn;

/// An attribute that a style transfers along with its shape. The style curves need a column for it; otherwise
/// flgStyleCreate refuses them, or its job does if another job still makes them. Values are sampled where the matching
/// leads, angles between points the shorter way and unwrapped along the curve. A SPEED must be above 0.
using StyleAttribute = FlgStyleAttribute;

/// One of several patch sizes, sec. 4.5.4: their distances are summed with these weights.
using PatchSize = FlgPatchSize;

/// Steers a style along its targets: where the column is `from`, `driven` has the value `at_from`, where it is `to`,
/// the value `at_to`; in between in proportion, beyond them no further. So at the target's points; values go evenly
/// from one point to the next. Several drives of the same thing are multiplied.
using StyleDrive = FlgStyleDrive;

/// At weights (1 - u - v, u, v) of the triangle's corners; u, v >= 0 and u + v <= 1 (clipped within 1e-5).
using SurfacePoint = FlgSurfacePoint;

/// Where a vertex lies on the mesh that its surface was made of: weights of at most three of that mesh's vertices, all
/// of one triangle.
using SourceWeights = FlgSourceWeights;

/// Part of a border. Loops are the closed borders of the seeds' regions, taken together, including surface borders.
/// They are ordered by their least edges, as flgSurfaceSampleBorders gives them. `begin` and `end` are fractions of the
/// loop's length from its first vertex.
using BorderStretch = FlgBorderStretch;

/// A region by how it was made: what it is known by while it is not there.
using TangleRegionName = FlgTangleRegionName;

/// FlgTangleInfo of the C ABI.
using TangleInfo = FlgTangleInfo;

/// FlgTangleRegion of the C ABI.
using TangleRegion = FlgTangleRegion;

/// What a call of flgBrushMeshWrite writes.
using BrushMeshSizes = FlgBrushMeshSizes;

/// A point on a branch's axis, with the slice across it.
using AxisSample = FlgAxisSample;

/// A joint's place in the rig, the bone that turns with it, and how far it may turn.
using RigJoint = FlgRigJoint;

/// Data of one stroke in a .tilt file, besides its points.
using Stroke = FlgStroke;

/// Progress of a stroke.
using LiveStrokeInfo = FlgLiveStrokeInfo;

/// FlgManifoldView of the C ABI.
using ManifoldView = FlgManifoldView;

/// The side on which a curve passes an obstacle: while the initial curve is found, the obstacle extends without end
/// against the direction: in the plane and in space straight, on a surface along it, as far as the surface is large
/// (where that leads back to the obstacle, half way around). In the plane and on surfaces the optimized curve stays on
/// that side. In space a ball has no other side, and the curve may slide over it to where it bends less. On a surface
/// the job fails for obstacles that do not cut it near their middle, and for directions across it.
using ObstacleSide = FlgObstacleSide;

/// A ray.
using Ray = FlgRay;

/// The hit of a ray or a point.
using Hit = FlgHit;

/// An end of a line, or a point.
using DebugVertex = FlgDebugVertex;

/// Curves in flat arrays: curve c has the points curve_offsets[c] to curve_offsets[c + 1] - 1 of every column. For
/// input the host owns the arrays, which must live for the call; for results the set owns them until it is released.
struct CurveSetView {
    /// FlgCurveSetView::curve_count.
    uint32_t curve_count{};
    /// curve_count + 1 values, starting at 0, never decreasing
    Span<const uint32_t> curve_offsets;
    /// curve_count values of FLG_CURVE_...; null in input: all 0
    Span<const uint8_t> curve_flags;
    /// POSITION first in results
    Span<const FlgColumn> columns;
    /// 1 to 16, each attribute at most once
    uint32_t column_count{};
    /// metres: what positions are relative to. Default 0
    double origin[3]{};

    /// Empty.
    CurveSetView() { flgCurveSetViewInit(&c_, detail::size_of<FlgCurveSetView>); }
    /// Of the C struct.
    CurveSetView(const FlgCurveSetView& c) : c_(c) {
        curve_count = c.curve_count;
        column_count = c.column_count;
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        curve_offsets = detail::span(c.curve_offsets, std::size_t{curve_count} + 1);
        curve_flags = detail::span(c.curve_flags, curve_count);
        columns = detail::span(c.columns, column_count);
    }
    /// The C struct, for C functions.
    const FlgCurveSetView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgCurveSetView() const noexcept { return c_; }

    /// [any thread] The view's column of an attribute, null if there is none.
    /// Calls flgCurveSetViewGetColumn.
    const FlgColumn* column(FlgAttribute attribute) const {
        return flgCurveSetViewGetColumn(&c_, attribute);
    }

    /// An attribute of all points, `components` floats each: `rows<3>(FLG_ATTRIBUTE_POSITION)`. Empty without such a
    /// column.
    template <std::size_t components>
    Rows<components> rows(FlgAttribute attribute) const {
        return Rows<components>(column(attribute), curve_offsets.empty() ? 0 : curve_offsets[curve_count]);
    }

private:
    FlgCurveSetView c_;
};

/// What FlgStyleInfo shows.
struct StyleInfo {
    /// of style, guide and displacement, over all curves
    uint32_t point_count{};
    /// p, the largest
    uint32_t patch{};
    /// in the patch graph, including consecutive ones
    uint32_t edge_count{};
    /// metres, over all curves
    float style_length{};
    /// metres, likewise
    float guide_length{};
    /// guide_length / (point_count - curves): the distance between a result's points along its target
    float spacing{};
    /// metres
    float displacement_rms{};
    /// E' of sec. 4.2, square metres, mean over the points
    float matching_energy{};
    /// metres: what temperature 1 means, see FlgCurveSetStylizeDesc
    float temperature_unit{};
    /// of the guide flow; 0 with a guide given
    uint32_t flow_steps{};
    /// point_count arc lengths on the style's curves, metres; lives until the style is released
    Span<const float> matching;
    /// the first points of the style, so many, are its start cap
    uint32_t start_cap_points{};
    /// likewise the last ones its end cap
    uint32_t end_cap_points{};

    /// Empty.
    StyleInfo() { flgStyleInfoInit(&c_, detail::size_of<FlgStyleInfo>); }
    /// Of the C struct.
    StyleInfo(const FlgStyleInfo& c) : c_(c) {
        point_count = c.point_count;
        patch = c.patch;
        edge_count = c.edge_count;
        style_length = c.style_length;
        guide_length = c.guide_length;
        spacing = c.spacing;
        displacement_rms = c.displacement_rms;
        matching_energy = c.matching_energy;
        temperature_unit = c.temperature_unit;
        flow_steps = c.flow_steps;
        start_cap_points = c.start_cap_points;
        end_cap_points = c.end_cap_points;
        matching = detail::span(c.matching, point_count);
    }
    /// The C struct, for C functions.
    const FlgStyleInfo& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgStyleInfo() const noexcept { return c_; }

private:
    FlgStyleInfo c_;
};

/// In which size a style was drawn on each curve of a result.
struct CurveSetScales {
    /// of the result; 0 for sets that no style was applied to
    uint32_t curve_count{};
    /// curve_count factors on the style, as FlgCurveSetStylizeDesc::scale; null if there are none. They live until the
    /// set is released
    Span<const float> scales;

    /// Empty.
    CurveSetScales() { flgCurveSetScalesInit(&c_, detail::size_of<FlgCurveSetScales>); }
    /// Of the C struct.
    CurveSetScales(const FlgCurveSetScales& c) : c_(c) {
        curve_count = c.curve_count;
        scales = detail::span(c.scales, curve_count);
    }
    /// The C struct, for C functions.
    const FlgCurveSetScales& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgCurveSetScales() const noexcept { return c_; }

private:
    FlgCurveSetScales c_;
};

/// A triangle mesh in flat arrays. Used for input (the host owns the arrays, which must live for the call) and for
/// results.
struct MeshView {
    /// FlgMeshView::vertex_count.
    uint32_t vertex_count{};
    /// FlgMeshView::triangle_count.
    uint32_t triangle_count{};
    /// 1 to 16, each attribute at most once
    uint32_t column_count{};
    /// one value per vertex; POSITION is required, others are carried along
    Span<const FlgColumn> columns;
    /// 3 vertices per triangle, counter-clockwise seen from outside
    Span<const uint32_t> triangles;
    /// one label per triangle; null: all 0
    Span<const uint32_t> regions;
    /// metres: what positions are relative to. Default 0
    double origin[3]{};

    /// Empty.
    MeshView() { flgMeshViewInit(&c_, detail::size_of<FlgMeshView>); }
    /// Of the C struct.
    MeshView(const FlgMeshView& c) : c_(c) {
        vertex_count = c.vertex_count;
        triangle_count = c.triangle_count;
        column_count = c.column_count;
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        columns = detail::span(c.columns, column_count);
        triangles = detail::span(c.triangles, std::size_t{3} * triangle_count);
        regions = detail::span(c.regions, triangle_count);
    }
    /// The C struct, for C functions.
    const FlgMeshView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgMeshView() const noexcept { return c_; }

    /// [any thread] The view's column of an attribute, null if there is none.
    /// Calls flgMeshViewGetColumn.
    const FlgColumn* column(FlgAttribute attribute) const {
        return flgMeshViewGetColumn(&c_, attribute);
    }

    /// An attribute of all vertices, `components` floats each: `rows<3>(FLG_ATTRIBUTE_POSITION)`. Empty without such a
    /// column.
    template <std::size_t components>
    Rows<components> rows(FlgAttribute attribute) const {
        return Rows<components>(column(attribute), vertex_count);
    }

private:
    FlgMeshView c_;
};

/// Defects found in the input, their repairs, and properties of the surface.
struct SurfaceReport {
    /// merged into another vertex
    uint32_t welded_vertices{};
    /// dropped: no triangle uses them
    uint32_t unused_vertices{};
    /// dropped: they use a vertex twice
    uint32_t degenerate_triangles{};
    /// dropped: the same three vertices as another, in any order
    uint32_t duplicate_triangles{};
    /// reversed, to match their neighbours' winding
    uint32_t flipped_triangles{};
    /// had more than two triangles: joined in pairs, the rest separated
    uint32_t crowded_edges{};
    /// opened because their two sides cannot stay joined (Moebius strips, crowded edges)
    uint32_t cut_edges{};
    /// vertices added where triangles formed several fans
    uint32_t split_vertices{};
    /// kept: height below 1e-6 of the longest edge
    uint32_t flat_triangles{};
    /// FlgSurfaceReport::vertex_count.
    uint32_t vertex_count{};
    /// FlgSurfaceReport::triangle_count.
    uint32_t triangle_count{};
    /// pieces not joined by any edge
    uint32_t component_count{};
    /// closed chains of border edges
    uint32_t border_count{};
    /// edges with one triangle
    uint32_t border_edges{};
    /// handles, over all components
    uint32_t genus{};
    /// vertices - edges + triangles
    int64_t euler_number{};
    /// square metres
    double area{};
    /// of the positions, metres, relative to `origin`
    float box_min[3]{};
    /// of the positions, metres, relative to `origin`
    float box_max[3]{};
    /// one per input vertex: its index in the surface, FLG_NO_INDEX if dropped (for a split vertex, that of its first
    /// fan); null if no index changed. Lives until the surface is released
    Span<const uint32_t> vertex_of_input;
    /// FlgSurfaceReport::input_vertex_count.
    uint32_t input_vertex_count{};
    /// the input mesh's
    double origin[3]{};

    /// Empty.
    SurfaceReport() { flgSurfaceReportInit(&c_, detail::size_of<FlgSurfaceReport>); }
    /// Of the C struct.
    SurfaceReport(const FlgSurfaceReport& c) : c_(c) {
        welded_vertices = c.welded_vertices;
        unused_vertices = c.unused_vertices;
        degenerate_triangles = c.degenerate_triangles;
        duplicate_triangles = c.duplicate_triangles;
        flipped_triangles = c.flipped_triangles;
        crowded_edges = c.crowded_edges;
        cut_edges = c.cut_edges;
        split_vertices = c.split_vertices;
        flat_triangles = c.flat_triangles;
        vertex_count = c.vertex_count;
        triangle_count = c.triangle_count;
        component_count = c.component_count;
        border_count = c.border_count;
        border_edges = c.border_edges;
        genus = c.genus;
        euler_number = c.euler_number;
        area = c.area;
        for (int i = 0; i < 3; ++i) box_min[i] = c.box_min[i];
        for (int i = 0; i < 3; ++i) box_max[i] = c.box_max[i];
        input_vertex_count = c.input_vertex_count;
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        vertex_of_input = detail::span(c.vertex_of_input, input_vertex_count);
    }
    /// The C struct, for C functions.
    const FlgSurfaceReport& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgSurfaceReport() const noexcept { return c_; }

private:
    FlgSurfaceReport c_;
};

/// What FlgSurfaceView shows.
struct SurfaceView {
    /// changes so far
    uint32_t revision{};
    /// never null; lives as long as its arrays
    MeshView mesh;
    /// 3 per triangle: across the edges from corner k to corner k + 1; FLG_NO_INDEX at a border
    Span<const uint32_t> neighbours;

    /// Empty.
    SurfaceView() { flgSurfaceViewInit(&c_, detail::size_of<FlgSurfaceView>); }
    /// Of the C struct.
    SurfaceView(const FlgSurfaceView& c) : c_(c) {
        revision = c.revision;
        if (c.mesh) mesh = *c.mesh;
        neighbours = detail::span(c.neighbours, std::size_t{3} * mesh.triangle_count);
    }
    /// The C struct, for C functions.
    const FlgSurfaceView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgSurfaceView() const noexcept { return c_; }

private:
    FlgSurfaceView c_;
};

/// Where a surface's triangles and vertices lie on the mesh that it was made of, however often it was cut, refined or
/// displaced since: so that whatever that mesh has at the corners of its triangles (texture coordinates with seams,
/// tangents, joints and weights, morph targets) can be had at the corners of the surface's. Each triangle lies in one
/// triangle of the input.
struct SurfaceProvenanceView {
    /// of the surface
    uint32_t revision{};
    /// the surface's
    uint32_t vertex_count{};
    /// FlgSurfaceProvenanceView::triangle_count.
    uint32_t triangle_count{};
    /// FlgSurfaceProvenanceView::input_triangle_count.
    uint32_t input_triangle_count{};
    /// one per triangle: the input's triangle it lies in
    Span<const uint32_t> triangles;
    /// 3 per triangle of the input, in its order, welded as above
    Span<const uint32_t> input_vertices;
    /// one per vertex
    Span<const FlgSourceWeights> weights;

    /// Empty.
    SurfaceProvenanceView() { flgSurfaceProvenanceViewInit(&c_, detail::size_of<FlgSurfaceProvenanceView>); }
    /// Of the C struct.
    SurfaceProvenanceView(const FlgSurfaceProvenanceView& c) : c_(c) {
        revision = c.revision;
        vertex_count = c.vertex_count;
        triangle_count = c.triangle_count;
        input_triangle_count = c.input_triangle_count;
        triangles = detail::span(c.triangles, triangle_count);
        input_vertices = detail::span(c.input_vertices, std::size_t{3} * input_triangle_count);
        weights = detail::span(c.weights, vertex_count);
    }
    /// The C struct, for C functions.
    const FlgSurfaceProvenanceView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgSurfaceProvenanceView() const noexcept { return c_; }

    /// [any thread] The place on the input of a vertex of a triangle: `triangle` of the input, and the weights of that
    /// triangle's corners 1 and 2 in the input's order. FLG_ERROR_INVALID_ARGUMENT if the vertex is none of the
    /// triangle's. Cost: tens of nanoseconds.
    /// Calls flgSurfaceProvenanceViewGetPoint.
    Result<SurfacePoint> point(uint32_t triangle, uint32_t vertex) const {
        FlgSurfacePoint out_point{};
        const FlgResult result = flgSurfaceProvenanceViewGetPoint(&c_, triangle, vertex, &out_point);
        return detail::made(result, out_point);
    }

private:
    FlgSurfaceProvenanceView c_;
};

/// What FlgSurfaceCurvesView shows.
struct SurfaceCurvesView {
    /// may be 0
    uint32_t curve_count{};
    /// curve_count + 1 values
    Span<const uint32_t> curve_offsets;
    /// FLG_CURVE_CLOSED
    Span<const uint8_t> curve_flags;
    /// an isoline's value, a path's length, or the field's value at a stream's end
    Span<const float> curve_values;
    /// the segment from each point to the next lies in the triangle that the point names
    Span<const FlgSurfacePoint> points;
    /// of the surface
    uint32_t revision{};

    /// Empty.
    SurfaceCurvesView() { flgSurfaceCurvesViewInit(&c_, detail::size_of<FlgSurfaceCurvesView>); }
    /// Of the C struct.
    SurfaceCurvesView(const FlgSurfaceCurvesView& c) : c_(c) {
        curve_count = c.curve_count;
        revision = c.revision;
        curve_offsets = detail::span(c.curve_offsets, std::size_t{curve_count} + 1);
        curve_flags = detail::span(c.curve_flags, curve_count);
        curve_values = detail::span(c.curve_values, curve_count);
        points = detail::span(c.points, curve_offsets.empty() ? 0 : curve_offsets[curve_count]);
    }
    /// The C struct, for C functions.
    const FlgSurfaceCurvesView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgSurfaceCurvesView() const noexcept { return c_; }

private:
    FlgSurfaceCurvesView c_;
};

/// What FlgFieldView shows.
struct FieldView {
    /// FlgFieldView::vertex_count.
    uint32_t vertex_count{};
    /// one per vertex; for distances: metres, infinite where no path leads within the limits
    Span<const float> values;
    /// index of the nearest source: vertices, then points, then curves, then border regions, in the descriptor's order;
    /// FLG_NO_INDEX where infinite. Null if the field has none
    Span<const uint32_t> labels;
    /// for a sampling: its vertices, in the order chosen
    Span<const uint32_t> samples;
    /// FlgFieldView::sample_count.
    uint32_t sample_count{};
    /// of the surface
    uint32_t revision{};

    /// Empty.
    FieldView() { flgFieldViewInit(&c_, detail::size_of<FlgFieldView>); }
    /// Of the C struct.
    FieldView(const FlgFieldView& c) : c_(c) {
        vertex_count = c.vertex_count;
        sample_count = c.sample_count;
        revision = c.revision;
        values = detail::span(c.values, vertex_count);
        labels = detail::span(c.labels, vertex_count);
        samples = detail::span(c.samples, sample_count);
    }
    /// The C struct, for C functions.
    const FlgFieldView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgFieldView() const noexcept { return c_; }

private:
    FlgFieldView c_;
};

/// All steps of a tangle: enough to make it again, or to save it in a file (flgTangleFileWrite of filigree_io.h).
struct TangleHistory {
    /// including undone steps, up to the first undone edit
    uint32_t step_count{};
    /// steps not undone
    uint32_t made_count{};
    /// oldest first
    Span<const FlgTangleStep* const> steps;
    /// identifies the mesh: from the tangle's initial positions and triangles, to the bit
    uint64_t base{};
    /// box of those positions, relative to the surface's origin, as all positions are: a history does not depend on
    /// where its mesh is
    float box_min[3]{};
    /// box of those positions, relative to the surface's origin, as all positions are: a history does not depend on
    /// where its mesh is
    float box_max[3]{};

    /// Empty.
    TangleHistory() { flgTangleHistoryInit(&c_, detail::size_of<FlgTangleHistory>); }
    /// Of the C struct.
    TangleHistory(const FlgTangleHistory& c) : c_(c) {
        step_count = c.step_count;
        made_count = c.made_count;
        base = c.base;
        for (int i = 0; i < 3; ++i) box_min[i] = c.box_min[i];
        for (int i = 0; i < 3; ++i) box_max[i] = c.box_max[i];
        steps = detail::span(c.steps, step_count);
    }
    /// The C struct, for C functions.
    const FlgTangleHistory& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgTangleHistory() const noexcept { return c_; }

private:
    FlgTangleHistory c_;
};

/// A drawn shape: ring 0 is its outer contour, the other rings are its holes. Rings may have either orientation and may
/// repeat their first point at the end. The host owns the arrays, which must live for the call.
struct ContourView {
    /// 3 to 2^24
    uint32_t point_count{};
    /// 2 per point: x, y; magnitude 0 or 1e-150 to 1e150
    Span<const double> points;
    /// ring_count + 1 values: the start of each ring, then point_count; null: one ring
    Span<const uint32_t> ring_offsets;
    /// at least 1; default 1
    uint32_t ring_count{};

    /// Empty.
    ContourView() { flgContourViewInit(&c_, detail::size_of<FlgContourView>); }
    /// Of the C struct.
    ContourView(const FlgContourView& c) : c_(c) {
        point_count = c.point_count;
        ring_count = c.ring_count;
        points = detail::span(c.points, std::size_t{2} * point_count);
        ring_offsets = detail::span(c.ring_offsets, std::size_t{ring_count} + 1);
    }
    /// The C struct, for C functions.
    const FlgContourView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgContourView() const noexcept { return c_; }

private:
    FlgContourView c_;
};

/// The first nodes are the contour's points, ring by ring, at time 0. Face i is the area swept by the edge that starts
/// at point i.
struct StraightSkeletonView {
    /// points of the cleaned contour; also the number of faces
    uint32_t contour_count{};
    /// FlgStraightSkeletonView::node_count.
    uint32_t node_count{};
    /// FlgStraightSkeletonView::arc_count.
    uint32_t arc_count{};
    /// 3 per node: x, y, and the time at which the front arrives: the distance to the lines of its edges
    Span<const double> nodes;
    /// 4 per arc: nodes from and to, the later one last; faces to its left and right
    Span<const uint32_t> arcs;
    /// contour_count + 1 values
    Span<const uint32_t> face_offsets;
    /// each face's nodes counter-clockwise, starting with its edge's two points
    Span<const uint32_t> face_nodes;
    /// one per point of the cleaned contour: its index in the input, or FLG_NO_INDEX
    Span<const uint32_t> input_points;
    /// Both as fractions of the contour's box diagonal. Largest difference between a time and the distance: usually
    /// 1e-13, up to 1e-6 with nearly parallel edges.
    double residual{};
    /// How far points were moved to find the skeleton: usually 0; 1e-9 or 1e-7 where events at nearly the same time
    /// could not be told apart. The first nodes remain at the contour's points.
    double perturbation{};

    /// Empty.
    StraightSkeletonView() { flgStraightSkeletonViewInit(&c_, detail::size_of<FlgStraightSkeletonView>); }
    /// Of the C struct.
    StraightSkeletonView(const FlgStraightSkeletonView& c) : c_(c) {
        contour_count = c.contour_count;
        node_count = c.node_count;
        arc_count = c.arc_count;
        residual = c.residual;
        perturbation = c.perturbation;
        nodes = detail::span(c.nodes, std::size_t{3} * node_count);
        arcs = detail::span(c.arcs, std::size_t{4} * arc_count);
        face_offsets = detail::span(c.face_offsets, std::size_t{contour_count} + 1);
        face_nodes = detail::span(c.face_nodes, face_offsets.empty() ? 0 : face_offsets[contour_count]);
        input_points = detail::span(c.input_points, contour_count);
    }
    /// The C struct, for C functions.
    const FlgStraightSkeletonView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgStraightSkeletonView() const noexcept { return c_; }

private:
    FlgStraightSkeletonView c_;
};

/// Ready to become a part: `contour` for FlgPartDesc, `placement` for FlgModelPart.
struct OutlineView {
    /// metres, in the plane through the middle of the triangles; y points up as far as possible
    ContourView contour;
    /// maps the contour back to the surface
    double placement[12]{};
    /// metres: what the placement's positions are relative to: the surface's origin
    double origin[3]{};

    /// Empty.
    OutlineView() { flgOutlineViewInit(&c_, detail::size_of<FlgOutlineView>); }
    /// Of the C struct.
    OutlineView(const FlgOutlineView& c) : c_(c) {
        for (int i = 0; i < 12; ++i) placement[i] = c.placement[i];
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        if (c.contour) contour = *c.contour;
    }
    /// The C struct, for C functions.
    const FlgOutlineView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgOutlineView() const noexcept { return c_; }

private:
    FlgOutlineView c_;
};

/// What FlgPartView shows.
struct PartView {
    /// points
    uint32_t outline_count{};
    /// 2 per point
    Span<const double> outline;
    /// ring_count + 1 values: the start of each ring, then outline_count
    Span<const uint32_t> outline_rings;
    /// FlgPartView::ring_count.
    uint32_t ring_count{};
    /// of the axis; at least 1
    uint32_t node_count{};
    /// 3 per node: x, y, and the radius of a disc around it inside the outline
    Span<const double> nodes;
    /// 2 per arc: nodes; node_count - 1 arcs
    Span<const uint32_t> arcs;
    /// of all branches, consecutively
    Span<const FlgAxisSample> samples;
    /// 4 per branch: its first and last node; its first sample, and one past its last
    Span<const uint32_t> branches;
    /// FlgPartView::sample_count.
    uint32_t sample_count{};
    /// 0 if the axis is one node
    uint32_t branch_count{};
    /// the length that fractions refer to
    double length{};

    /// Empty.
    PartView() { flgPartViewInit(&c_, detail::size_of<FlgPartView>); }
    /// Of the C struct.
    PartView(const FlgPartView& c) : c_(c) {
        outline_count = c.outline_count;
        ring_count = c.ring_count;
        node_count = c.node_count;
        sample_count = c.sample_count;
        branch_count = c.branch_count;
        length = c.length;
        outline = detail::span(c.outline, std::size_t{2} * outline_count);
        outline_rings = detail::span(c.outline_rings, std::size_t{ring_count} + 1);
        nodes = detail::span(c.nodes, std::size_t{3} * node_count);
        arcs = detail::span(c.arcs, node_count == 0 ? 0 : std::size_t{2} * (node_count - 1));
        samples = detail::span(c.samples, sample_count);
        branches = detail::span(c.branches, std::size_t{4} * branch_count);
    }
    /// The C struct, for C functions.
    const FlgPartView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgPartView() const noexcept { return c_; }

private:
    FlgPartView c_;
};

/// What FlgPartMeshView shows.
struct PartMeshView {
    /// FlgPartMeshView::vertex_count.
    uint32_t vertex_count{};
    /// FlgPartMeshView::triangle_count.
    uint32_t triangle_count{};
    /// 3 per vertex, units of the drawing; z is the height above its plane
    Span<const float> positions;
    /// 3 per triangle, counter-clockwise seen from outside
    Span<const uint32_t> triangles;

    /// Empty.
    PartMeshView() { flgPartMeshViewInit(&c_, detail::size_of<FlgPartMeshView>); }
    /// Of the C struct.
    PartMeshView(const FlgPartMeshView& c) : c_(c) {
        vertex_count = c.vertex_count;
        triangle_count = c.triangle_count;
        positions = detail::span(c.positions, std::size_t{3} * vertex_count);
        triangles = detail::span(c.triangles, std::size_t{3} * triangle_count);
    }
    /// The C struct, for C functions.
    const FlgPartMeshView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgPartMeshView() const noexcept { return c_; }

private:
    FlgPartMeshView c_;
};

/// Joints, parents first. The bone to a joint turns with its parent. Parts include mirror images, each after its
/// original.
struct ModelView {
    /// at least 1
    uint32_t joint_count{};
    /// 3 per joint, metres
    Span<const float> joint_positions;
    /// radius of the shape around the joint, metres
    Span<const float> joint_radii;
    /// FLG_NO_INDEX: a root
    Span<const uint32_t> joint_parents;
    /// the part each joint lies in
    Span<const uint32_t> joint_parts;
    /// the joint's key, unless it was renamed
    Span<const char* const> joint_names;
    /// FlgModelView::part_count.
    uint32_t part_count{};
    /// the size that thresholds are fractions of, metres
    float size{};
    /// one per part: how it was connected, before refinement of bones
    Span<const FlgPartEvent> part_events;
    /// one per part: its parent part; FLG_NO_INDEX: none
    Span<const uint32_t> part_parents;
    /// one per part: its own joint nearest to the root, which swings it; if it has none left, the joint that moves it
    Span<const uint32_t> part_joints;
    /// one per part: index of the host's part
    Span<const uint32_t> part_sources;
    /// one per part: its mirror image; FLG_NO_INDEX: none
    Span<const uint32_t> part_twins;
    /// one per part: 1 for a mirror image, 0 for a drawn part
    Span<const uint8_t> part_mirrored;
    /// metres: what positions are relative to
    double origin[3]{};
    /// what edits know a joint by: the part's name, then a number: tail_0, tail_1, ..., arm_0.L, ...; where a part
    /// attaches: torso_at_arm; the middle of a trunk: torso_root
    Span<const char* const> joint_keys;
    /// 3 per joint: where it is in the drawing of its part, as FlgJointEdit::at
    Span<const double> joint_places;
    /// one per joint: 1 if an edit pins it
    Span<const uint8_t> joint_pinned;

    /// Empty.
    ModelView() { flgModelViewInit(&c_, detail::size_of<FlgModelView>); }
    /// Of the C struct.
    ModelView(const FlgModelView& c) : c_(c) {
        joint_count = c.joint_count;
        part_count = c.part_count;
        size = c.size;
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        joint_positions = detail::span(c.joint_positions, std::size_t{3} * joint_count);
        joint_radii = detail::span(c.joint_radii, joint_count);
        joint_parents = detail::span(c.joint_parents, joint_count);
        joint_parts = detail::span(c.joint_parts, joint_count);
        joint_names = detail::span(c.joint_names, joint_count);
        part_events = detail::span(c.part_events, part_count);
        part_parents = detail::span(c.part_parents, part_count);
        part_joints = detail::span(c.part_joints, part_count);
        part_sources = detail::span(c.part_sources, part_count);
        part_twins = detail::span(c.part_twins, part_count);
        part_mirrored = detail::span(c.part_mirrored, part_count);
        joint_keys = detail::span(c.joint_keys, joint_count);
        joint_places = detail::span(c.joint_places, std::size_t{3} * joint_count);
        joint_pinned = detail::span(c.joint_pinned, joint_count);
    }
    /// The C struct, for C functions.
    const FlgModelView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgModelView() const noexcept { return c_; }

private:
    FlgModelView c_;
};

/// A surface in one piece and the joints that move it, in the rest pose: no joint is rotated.
struct SkinView {
    /// FlgSkinView::vertex_count.
    uint32_t vertex_count{};
    /// FlgSkinView::triangle_count.
    uint32_t triangle_count{};
    /// 1 to 65535
    uint32_t joint_count{};
    /// 3 per vertex, metres
    Span<const float> positions;
    /// 3 per vertex, of length 1
    Span<const float> normals;
    /// 3 per triangle, counter-clockwise seen from outside
    Span<const uint32_t> triangles;
    /// 4 per vertex: joints that move it, largest weight first; unused ones are 0
    Span<const uint16_t> vertex_joints;
    /// 4 per vertex: 0 to 1, with sum 1; unused ones are 0
    Span<const float> vertex_weights;
    /// one per vertex: the part it lies on
    Span<const uint32_t> vertex_parts;
    /// 3 per joint, metres, in the model's space: the model's, moved with limbs that pass in front of others or behind
    /// (FlgModelPart::depth)
    Span<const float> joint_positions;
    /// one per joint, lower than its own index; FLG_NO_INDEX: a root
    Span<const uint32_t> joint_parents;
    /// one per joint, UTF-8, unique; null in input: none
    Span<const char* const> joint_names;
    /// metres: what positions are relative to. Default 0
    double origin[3]{};
    /// one per joint: radius of the shape around it, metres; null in input: not known
    Span<const float> joint_radii;
    /// a x + b y + c z = d: the plane of its mirror image, whose normal points to its left; 0: none. Ignored in input
    float mirror[4]{};
    /// one per triangle: the part it lies on. These meet at edges that follow the parts' border. Null in input: that of
    /// two corners, else of the first
    Span<const uint32_t> triangle_parts;
    /// 6 per triangle: u, v of its corners, 0 0 at the picture's upper left, 1 1 at its lower right; parts without a
    /// picture: 0. Corners of a vertex differ only where parts with different projections meet. Null: no part has a
    /// picture
    Span<const float> corner_uvs;

    /// Empty.
    SkinView() { flgSkinViewInit(&c_, detail::size_of<FlgSkinView>); }
    /// Of the C struct.
    SkinView(const FlgSkinView& c) : c_(c) {
        vertex_count = c.vertex_count;
        triangle_count = c.triangle_count;
        joint_count = c.joint_count;
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        for (int i = 0; i < 4; ++i) mirror[i] = c.mirror[i];
        positions = detail::span(c.positions, std::size_t{3} * vertex_count);
        normals = detail::span(c.normals, std::size_t{3} * vertex_count);
        triangles = detail::span(c.triangles, std::size_t{3} * triangle_count);
        vertex_joints = detail::span(c.vertex_joints, std::size_t{4} * vertex_count);
        vertex_weights = detail::span(c.vertex_weights, std::size_t{4} * vertex_count);
        vertex_parts = detail::span(c.vertex_parts, vertex_count);
        joint_positions = detail::span(c.joint_positions, std::size_t{3} * joint_count);
        joint_parents = detail::span(c.joint_parents, joint_count);
        joint_names = detail::span(c.joint_names, joint_count);
        joint_radii = detail::span(c.joint_radii, joint_count);
        triangle_parts = detail::span(c.triangle_parts, triangle_count);
        corner_uvs = detail::span(c.corner_uvs, std::size_t{6} * triangle_count);
    }
    /// The C struct, for C functions.
    const FlgSkinView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgSkinView() const noexcept { return c_; }

    /// The transform of each joint from rest to a pose.
    ///   rotations             4 per joint: x, y, z, w of length 1 within 0.001, in the parent's frame, as in
    ///                         FlgSkinAnimation; null: no rotations
    ///   translation           3: translation of all roots, metres; null: none
    ///   out_matrices          12 per joint, or null: three rows of four. The rows times (x, y, z, 1) at rest give the
    ///                         position in the pose
    ///   out_dual_quaternions  8 per joint, or null: x, y, z, w of the rotation r, then those of (t r) / 2, where t
    ///                         translates after it
    /// Reads only the skin's joints. Cost: about 50 ns a joint; takes no memory for up to 256 joints, else 56 bytes a
    /// joint of the C++ runtime's.
    /// Calls flgSkinPose.
    Result<bool> pose(const float* rotations, const float* translation, float* out_matrices,
        float* out_dual_quaternions) const {
        const FlgResult result = flgSkinPose(&c_, rotations, translation, out_matrices, out_dual_quaternions);
        return detail::done(result);
    }

    /// Deforms the vertices on the CPU: the reference for a vertex shader.
    ///   transforms     from flgSkinPose: 12 per joint (FLG_SKINNING_LINEAR) or 8 (FLG_SKINNING_DUAL_QUATERNION)
    ///   out_positions  3 per vertex
    ///   out_normals    3 per vertex, of length 1, rotated as their vertices are; null: not needed
    /// The joint with a vertex' largest weight decides the sign of equivalent dual quaternions. Weights must sum to 1
    /// within 0.0001, the largest first. Cost: about 0.1 us a vertex, one pass to check and one to move.
    /// Calls flgSkinDeform.
    Result<bool> deform(FlgSkinning skinning, const float* transforms, float* out_positions, float* out_normals) const {
        const FlgResult result = flgSkinDeform(&c_, skinning, transforms, out_positions, out_normals);
        return detail::done(result);
    }

private:
    FlgSkinView c_;
};

/// What the other functions take. Refers to the host's arrays, which must live as long.
struct Rig {
    /// FlgRig::joint_count.
    uint32_t joint_count{};
    /// the descriptor's
    Span<const float> joint_positions;
    /// the descriptor's
    Span<const uint32_t> joint_parents;
    /// one per joint
    Span<const FlgRigJoint> joints;
    /// up, left and forward are at right angles, of length 1
    float up[3]{};
    /// to the model's left
    float left[3]{};
    /// where it looks
    float forward[3]{};
    /// metres along `up`: where the shape ends below
    float ground{};
    /// FlgRig::leg_count.
    uint32_t leg_count{};
    /// 0 or 2
    uint32_t arm_count{};

    /// Empty.
    Rig() { flgRigInit(&c_, detail::size_of<FlgRig>); }
    /// Of the C struct.
    Rig(const FlgRig& c) : c_(c) {
        joint_count = c.joint_count;
        for (int i = 0; i < 3; ++i) up[i] = c.up[i];
        for (int i = 0; i < 3; ++i) left[i] = c.left[i];
        for (int i = 0; i < 3; ++i) forward[i] = c.forward[i];
        ground = c.ground;
        leg_count = c.leg_count;
        arm_count = c.arm_count;
        joint_positions = detail::span(c.joint_positions, joint_count);
        joint_parents = detail::span(c.joint_parents, joint_count);
        joints = detail::span(c.joints, joint_count);
    }
    /// The C struct, for C functions.
    const FlgRig& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgRig() const noexcept { return c_; }

    /// The bones of a humanoid, by the names of a standard.
    ///   out_names  one per joint: a name that lives as long as the library; null: the joint is none of the standard's
    /// Needs two arms and two legs of at least three joints each, a head, and a joint of the spine between hips and
    /// arms. FLG_ERROR_INVALID_ARGUMENT if one is missing; the message says "no humanoid" and which. Cost: 0.1 us a
    /// joint.
    /// Calls flgRigGetNames.
    Result<bool> names(FlgRigStandard standard, const char** out_names) const {
        const FlgResult result = flgRigGetNames(&c_, standard, out_names);
        return detail::done(result);
    }

    /// The rotations that bring a humanoid from rest to a T-pose: each arm straight and level to its side, turned the
    /// shortest way, so that palms which face the body at rest face down. Legs stay. Take them for flgSkinPose: a skin
    /// that is deformed so, with its joints where they are then, is at rest in the T-pose.
    ///   out_rotations  4 per joint, as FlgSkinAnimation
    /// FLG_ERROR_INVALID_ARGUMENT without two arms. Cost: 0.1 us a joint.
    /// Calls flgRigGetTPose.
    Result<bool> tpose(float* out_rotations) const {
        const FlgResult result = flgRigGetTPose(&c_, out_rotations);
        return detail::done(result);
    }

    /// The pose of a motion. Arms of those who stand on two legs hang down in all of them, however they are at rest.
    /// Motions repeat without a seam: phase 1 is phase 0. All rotations are within the limits.
    ///   phase            share of the cycle, finite
    ///   out_rotations    4 per joint, as FlgSkinAnimation
    ///   out_translation  3: of all roots, metres
    ///   out_travel       3, or null: how far the model walks in a cycle, metres: move it so, and standing feet stay
    /// Standing feet slide by less than 0.0001 of the way of a cycle, if legs reach as far. FLG_ERROR_INVALID_ARGUMENT
    /// if the rig has no limbs for the motion; the message names them. Cost: 0.3 us a joint; takes no memory.
    /// Calls flgRigMotionSample.
    Result<bool> motion_sample(FlgRigMotion motion, float phase, float* out_rotations, float* out_translation,
        float* out_travel) const {
        const FlgResult result = flgRigMotionSample(&c_, motion, phase, out_rotations, out_translation, out_travel);
        return detail::done(result);
    }

private:
    FlgRig c_;
};

/// What FlgCurveFileInfo shows.
struct CurveFileInfo {
    /// FlgCurveFileInfo::curve_count.
    uint32_t curve_count{};
    /// FlgCurveFileInfo::point_count.
    uint64_t point_count{};
    /// "tilt", "xyz", "obj", "gltf", "svg"
    const char* format{};
    /// of the file, before conversion: "decimetres, left-handed", "metres", "as given"
    const char* units{};
    /// of the positions, metres
    float box_min[3]{};
    /// of the positions, metres
    float box_max[3]{};
    /// of all curves as polylines, metres
    float total_length{};
    /// FlgCurveFileInfo::warning_count.
    uint32_t warning_count{};
    /// that of the curves for .tilt files, else 0
    uint32_t stroke_count{};
    /// sentences; live until the file is released
    Span<const char* const> warnings;

    /// Empty.
    CurveFileInfo() { flgCurveFileInfoInit(&c_, detail::size_of<FlgCurveFileInfo>); }
    /// Of the C struct.
    CurveFileInfo(const FlgCurveFileInfo& c) : c_(c) {
        curve_count = c.curve_count;
        point_count = c.point_count;
        format = c.format;
        units = c.units;
        for (int i = 0; i < 3; ++i) box_min[i] = c.box_min[i];
        for (int i = 0; i < 3; ++i) box_max[i] = c.box_max[i];
        total_length = c.total_length;
        warning_count = c.warning_count;
        stroke_count = c.stroke_count;
        warnings = detail::span(c.warnings, warning_count);
    }
    /// The C struct, for C functions.
    const FlgCurveFileInfo& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgCurveFileInfo() const noexcept { return c_; }

private:
    FlgCurveFileInfo c_;
};

/// What FlgMeshFileInfo shows.
struct MeshFileInfo {
    /// as stored: formats that keep normals or texture with vertices repeat positions
    uint32_t vertex_count{};
    /// after splitting polygons
    uint32_t triangle_count{};
    /// distinct labels; 1 if the file has none
    uint32_t region_count{};
    /// faces as stored; for strips and fans their triangles
    uint64_t polygon_count{};
    /// "ply", "obj", "off", "gltf"
    const char* format{};
    /// of the positions, metres; units are taken as given
    float box_min[3]{};
    /// of the positions, metres; units are taken as given
    float box_max[3]{};
    /// FlgMeshFileInfo::warning_count.
    uint32_t warning_count{};
    /// one per region of the view (one alone if that has no regions), if at least one has a colour or a texture; else 0
    uint32_t material_count{};
    /// sentences; live until the file is released
    Span<const char* const> warnings;
    /// at most 16; 0 for other formats than .ply
    uint32_t face_column_count{};
    /// FlgMeshFileInfo::texture_count.
    uint32_t texture_count{};
    /// 6 per triangle: texture coordinates of its corners, 0 0 where some have none; live until the file is released.
    /// Null: the file has none
    Span<const float> corner_uvs;

    /// Empty.
    MeshFileInfo() { flgMeshFileInfoInit(&c_, detail::size_of<FlgMeshFileInfo>); }
    /// Of the C struct.
    MeshFileInfo(const FlgMeshFileInfo& c) : c_(c) {
        vertex_count = c.vertex_count;
        triangle_count = c.triangle_count;
        region_count = c.region_count;
        polygon_count = c.polygon_count;
        format = c.format;
        for (int i = 0; i < 3; ++i) box_min[i] = c.box_min[i];
        for (int i = 0; i < 3; ++i) box_max[i] = c.box_max[i];
        warning_count = c.warning_count;
        material_count = c.material_count;
        face_column_count = c.face_column_count;
        texture_count = c.texture_count;
        warnings = detail::span(c.warnings, warning_count);
        corner_uvs = detail::span(c.corner_uvs, std::size_t{6} * triangle_count);
    }
    /// The C struct, for C functions.
    const FlgMeshFileInfo& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgMeshFileInfo() const noexcept { return c_; }

private:
    FlgMeshFileInfo c_;
};

/// What FlgSkinFileInfo shows.
struct SkinFileInfo {
    /// the view's highest part index plus one
    uint32_t part_count{};
    /// of the positions at rest, metres
    float box_min[3]{};
    /// of the positions at rest, metres
    float box_max[3]{};
    /// FlgSkinFileInfo::warning_count.
    uint32_t warning_count{};
    /// FlgSkinFileInfo::animation_count.
    uint32_t animation_count{};
    /// sentences; live until the file is released
    Span<const char* const> warnings;
    /// one per part, or one for all, if at least one has a colour or a texture; else 0
    uint32_t material_count{};
    /// FlgSkinFileInfo::texture_count.
    uint32_t texture_count{};
    /// 4 per vertex, linear RGBA; live until the file is released. Null: none
    const float* vertex_colors{};
    /// FlgSkinFileInfo::morph_count.
    uint32_t morph_count{};
    /// FlgSkinFileInfo::morph_animation_count.
    uint32_t morph_animation_count{};

    /// Empty.
    SkinFileInfo() { flgSkinFileInfoInit(&c_, detail::size_of<FlgSkinFileInfo>); }
    /// Of the C struct.
    SkinFileInfo(const FlgSkinFileInfo& c) : c_(c) {
        part_count = c.part_count;
        for (int i = 0; i < 3; ++i) box_min[i] = c.box_min[i];
        for (int i = 0; i < 3; ++i) box_max[i] = c.box_max[i];
        warning_count = c.warning_count;
        animation_count = c.animation_count;
        material_count = c.material_count;
        texture_count = c.texture_count;
        vertex_colors = c.vertex_colors;
        morph_count = c.morph_count;
        morph_animation_count = c.morph_animation_count;
        warnings = detail::span(c.warnings, warning_count);
    }
    /// The C struct, for C functions.
    const FlgSkinFileInfo& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgSkinFileInfo() const noexcept { return c_; }

private:
    FlgSkinFileInfo c_;
};

/// What FlgSplineView shows.
struct SplineView {
    /// n
    uint32_t ambient{};
    /// FlgSplineView::node_count.
    uint32_t node_count{};
    /// FlgSplineView::point_count.
    uint32_t point_count{};
    /// as in the descriptor
    uint32_t closed{};
    /// FlgSplineView::ending.
    FlgSplineEnding ending{};
    /// n per node
    Span<const double> nodes;
    /// one per node, closed: one more
    Span<const double> parameters;
    /// 3 per node, unit: the surface's, outwards; null if it is not a surface in R^3, and while running
    Span<const float> normals;
    /// one per given point: its node
    Span<const uint32_t> point_nodes;
    /// nodes that stay at an edge or a gap of the surface, ascending; the curve is optimized as if they were given
    /// points. Null if there are none
    Span<const uint32_t> held_nodes;
    /// one per given point, metres: its distance from the manifold
    Span<const double> offsets;
    /// the largest of these, metres
    double largest_offset{};
    /// of the optimization
    uint32_t rounds{};
    /// projections of all nodes onto the manifold
    uint32_t projections{};
    /// number of held_nodes; 0 while running
    uint32_t held_count{};
    /// nonzero: the curve over triangles, for now or in the end
    uint32_t on_triangles{};
    /// with all weights
    double energy{};
    /// E2: exact for the spline of R^n through the nodes
    double bending{};
    /// E1 of the chain
    double stretching{};
    /// metres, of the chain
    double length{};
    /// Tangential part of the fourth derivative (with tension minus w times the second; for E1 the second) at free
    /// nodes, root mean square, divided by the mean of all elastic forces along the curve, including those at the given
    /// points.
    double residual{};
    /// metres: what the nodes are relative to: the manifold's origin; on FLG_MANIFOLD_SHAPE_SPACE the descriptor's
    double origin[3]{};
    /// one per node, where asked for: the nearest point of the mesh's triangles, as they were when the spline was made.
    /// Null else, and while running
    Span<const FlgSurfacePoint> surface_points;
    /// metres: of these, the largest distance from its node
    double largest_moved{};
    /// The curve as cubic pieces from key to key, where asked for; null and 0 else, and while running. As glTF's
    /// CUBICSPLINE has it: an animation's output is arriving, point, leaving for each key. Bezier's points from a key
    /// to the next, h later in parameter: point, point + h / 3 leaving, next point - h / 3 next arriving, next point.
    /// There is a key at each given point; a closed curve's last key is its first again.
    uint32_t key_count{};
    /// nonzero: with seek_lower, the curve is not that which goes on from the warm_start, but another one of lower
    /// energy
    uint32_t jumped{};
    /// ascending; a closed curve's with handles begin at the first one
    Span<const double> key_parameters;
    /// n per key
    Span<const double> key_points;
    /// n per key: the derivative by the parameter before it
    Span<const double> key_arriving;
    /// likewise after it: the same but at handles and, with E1, at given points
    Span<const double> key_leaving;
    /// metres: the pieces' largest distance from the cubic spline through the nodes
    double largest_key_error{};

    /// Empty.
    SplineView() { flgSplineViewInit(&c_, detail::size_of<FlgSplineView>); }
    /// Of the C struct.
    SplineView(const FlgSplineView& c) : c_(c) {
        ambient = c.ambient;
        node_count = c.node_count;
        point_count = c.point_count;
        closed = c.closed;
        ending = c.ending;
        largest_offset = c.largest_offset;
        rounds = c.rounds;
        projections = c.projections;
        held_count = c.held_count;
        on_triangles = c.on_triangles;
        energy = c.energy;
        bending = c.bending;
        stretching = c.stretching;
        length = c.length;
        residual = c.residual;
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        largest_moved = c.largest_moved;
        key_count = c.key_count;
        jumped = c.jumped;
        largest_key_error = c.largest_key_error;
        nodes = detail::span(c.nodes, std::size_t{ambient} * node_count);
        parameters = detail::span(c.parameters, std::size_t{node_count} + (closed != 0));
        normals = detail::span(c.normals, std::size_t{3} * node_count);
        point_nodes = detail::span(c.point_nodes, point_count);
        held_nodes = detail::span(c.held_nodes, held_count);
        offsets = detail::span(c.offsets, point_count);
        surface_points = detail::span(c.surface_points, node_count);
        key_parameters = detail::span(c.key_parameters, key_count);
        key_points = detail::span(c.key_points, key_count);
        key_arriving = detail::span(c.key_arriving, key_count);
        key_leaving = detail::span(c.key_leaving, key_count);
    }
    /// The C struct, for C functions.
    const FlgSplineView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgSplineView() const noexcept { return c_; }

private:
    FlgSplineView c_;
};

/// What FlgMotionView shows.
struct MotionView {
    /// FlgMotionView::position_count.
    uint32_t position_count{};
    /// FlgMotionView::key_count.
    uint32_t key_count{};
    /// as in the descriptor
    uint32_t closed{};
    /// one per position, closed: one more, when the first recurs; seconds
    Span<const double> times;
    /// 12 per position, laid out as in the descriptor
    Span<const double> poses;
    /// 4 per position, x, y, z, w: the same rotations, consecutive ones in the same hemisphere
    Span<const double> quaternions;
    /// one per key: its position
    Span<const uint32_t> key_positions;
    /// of the body: its point count or total mass; a box has 6
    double mass{};
    /// in the body's coordinates
    double barycentre[3]{};
    /// principal axes in the body's coordinates, one after another, right-handed
    double axes[9]{};
    /// distance of the body's farthest point from the barycentre, metres
    double radius{};
    /// half axes of its ellipsoid of inertia: sqrt(sum of mass * square along the axis / 2)
    double inertia[3]{};
    /// largest stretch removed from the keys' poses
    double greatest_stretch{};
    /// FlgMotionView::ending.
    FlgSplineEnding ending{};
    /// of the optimization of all positions
    uint32_t rounds{};
    /// with all weights, summed over the body's points
    double energy{};
    /// the barycentre's share: mass times its path's energy
    double barycentre_energy{};
    /// the rest: that of the rotations; 0 of a body that looks. Before re-timing
    double rotation_energy{};
    /// of the rotations, see FlgSplineView
    double residual{};
    /// as in the descriptor
    double origin[3]{};
    /// of the barycentre's path, metres
    double length{};
    /// of the barycentre, m/s
    double greatest_speed{};
    /// of the barycentre, m/s^2; from second differences
    double greatest_acceleration{};
    /// rad/s
    double greatest_turn{};
    /// rad
    double greatest_bank{};

    /// Empty.
    MotionView() { flgMotionViewInit(&c_, detail::size_of<FlgMotionView>); }
    /// Of the C struct.
    MotionView(const FlgMotionView& c) : c_(c) {
        position_count = c.position_count;
        key_count = c.key_count;
        closed = c.closed;
        mass = c.mass;
        for (int i = 0; i < 3; ++i) barycentre[i] = c.barycentre[i];
        for (int i = 0; i < 9; ++i) axes[i] = c.axes[i];
        radius = c.radius;
        for (int i = 0; i < 3; ++i) inertia[i] = c.inertia[i];
        greatest_stretch = c.greatest_stretch;
        ending = c.ending;
        rounds = c.rounds;
        energy = c.energy;
        barycentre_energy = c.barycentre_energy;
        rotation_energy = c.rotation_energy;
        residual = c.residual;
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        length = c.length;
        greatest_speed = c.greatest_speed;
        greatest_acceleration = c.greatest_acceleration;
        greatest_turn = c.greatest_turn;
        greatest_bank = c.greatest_bank;
        times = detail::span(c.times, std::size_t{position_count} + (closed != 0));
        poses = detail::span(c.poses, std::size_t{12} * position_count);
        quaternions = detail::span(c.quaternions, std::size_t{4} * position_count);
        key_positions = detail::span(c.key_positions, key_count);
    }
    /// The C struct, for C functions.
    const FlgMotionView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgMotionView() const noexcept { return c_; }

private:
    FlgMotionView c_;
};

/// What FlgPulledView shows.
struct PulledView {
    /// FlgPulledView::vertex_count.
    uint32_t vertex_count{};
    /// 3 per vertex, metres
    Span<const float> positions;
    /// of the last round, before positions were found: square metres. It does not rise from round to round, if pose and
    /// handles stay
    double energy{};
    /// metres: what positions are relative to: the mesh's origin
    double origin[3]{};

    /// Empty.
    PulledView() { flgPulledViewInit(&c_, detail::size_of<FlgPulledView>); }
    /// Of the C struct.
    PulledView(const FlgPulledView& c) : c_(c) {
        vertex_count = c.vertex_count;
        energy = c.energy;
        for (int i = 0; i < 3; ++i) origin[i] = c.origin[i];
        positions = detail::span(c.positions, std::size_t{3} * vertex_count);
    }
    /// The C struct, for C functions.
    const FlgPulledView& get() const noexcept { return c_; }
    /// The C struct.
    operator FlgPulledView() const noexcept { return c_; }

private:
    FlgPulledView c_;
};

/// All memory of a context, including that of its jobs. Called from any thread; must be thread-safe. `allocate` may
/// return null: whatever needed the memory fails with FLG_ERROR_OUT_OF_MEMORY, and nothing is lost. Both null: the C++
/// runtime's aligned new and delete. Not included: memory the C++ runtime itself takes for threads and for the
/// exceptions that stop a failing job.
struct Allocator : FlgAllocator {
    /// The defaults.
    Allocator() { flgAllocatorInit(this, detail::size_of<FlgAllocator>); }
    /// Of the C struct.
    Allocator(const FlgAllocator& c) : FlgAllocator(c) {}
};

/// The host's own job system. With `submit` set the SDK starts no threads: it hands over tasks, and the host calls
/// run(task) once for each, on any thread, at any time, in any order. A task never blocks and ends after about 500 us.
/// At most `concurrency` (1 to 256) tasks are handed over at a time. flgContextTick, calls that start jobs, and tasks
/// themselves call `submit`. It must not call run(task) before it returns, and must not fail.
struct JobSystem : FlgJobSystem {
    /// The defaults.
    JobSystem() { flgJobSystemInit(this, detail::size_of<FlgJobSystem>); }
    /// Of the C struct.
    JobSystem(const FlgJobSystem& c) : FlgJobSystem(c) {}
};

/// Messages for the host's log: one sentence, no line break. Called on the host's thread, from inside its calls. Null:
/// silence.
struct Log : FlgLog {
    /// The defaults.
    Log() { flgLogInit(this, detail::size_of<FlgLog>); }
    /// Of the C struct.
    Log(const FlgLog& c) : FlgLog(c) {}
};

/// Monotonic nanoseconds, callable from any thread. Null: the system's steady clock. Measures budgets; results never
/// depend on it.
struct Clock : FlgClock {
    /// The defaults.
    Clock() { flgClockInit(this, detail::size_of<FlgClock>); }
    /// Of the C struct.
    Clock(const FlgClock& c) : FlgClock(c) {}
};

/// Named zones for a profiler such as Tracy or the engine's own. Called on the thread that does the work, properly
/// nested; names are string literals. Null: none.
struct Profiler : FlgProfiler {
    /// The defaults.
    Profiler() { flgProfilerInit(this, detail::size_of<FlgProfiler>); }
    /// Of the C struct.
    Profiler(const FlgProfiler& c) : FlgProfiler(c) {}
};

/// Settings for a new context.
struct ContextDesc : FlgContextDesc {
    /// The defaults.
    ContextDesc() { flgContextDescInit(this, detail::size_of<FlgContextDesc>); }
    /// Of the C struct.
    ContextDesc(const FlgContextDesc& c) : FlgContextDesc(c) {}
};

/// How a job runs. Every descriptor of a job points to one as `job`; functions without a descriptor take it as an
/// argument. Null: defaults. Read during the call. A job waits for inputs that another job still makes; they need not
/// be listed here.
struct JobOptions : FlgJobOptions {
    /// The defaults.
    JobOptions() { flgJobOptionsInit(this, detail::size_of<FlgJobOptions>); }
    /// Of the C struct.
    JobOptions(const FlgJobOptions& c) : FlgJobOptions(c) {}
    /// Sets dependencies and dependency_count. The array must live until the descriptor is used.
    void set_dependencies(Span<const FlgJob> values) {
        dependencies = values.data();
        dependency_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_dependencies(std::initializer_list<FlgJob>) = delete;
};

/// FlgCurveSetResampleDesc with its defaults.
struct CurveSetResampleDesc : FlgCurveSetResampleDesc {
    /// The defaults.
    CurveSetResampleDesc() { flgCurveSetResampleDescInit(this, detail::size_of<FlgCurveSetResampleDesc>); }
    /// Of the C struct.
    CurveSetResampleDesc(const FlgCurveSetResampleDesc& c) : FlgCurveSetResampleDesc(c) {}
    /// The defaults, with curves.
    CurveSetResampleDesc(FlgCurveSet curves_) {
        flgCurveSetResampleDescInit(this, detail::size_of<FlgCurveSetResampleDesc>);
        curves = curves_;
    }
};

/// FlgCurveSetSimplifyDesc with its defaults.
struct CurveSetSimplifyDesc : FlgCurveSetSimplifyDesc {
    /// The defaults.
    CurveSetSimplifyDesc() { flgCurveSetSimplifyDescInit(this, detail::size_of<FlgCurveSetSimplifyDesc>); }
    /// Of the C struct.
    CurveSetSimplifyDesc(const FlgCurveSetSimplifyDesc& c) : FlgCurveSetSimplifyDesc(c) {}
    /// The defaults, with curves.
    CurveSetSimplifyDesc(FlgCurveSet curves_) {
        flgCurveSetSimplifyDescInit(this, detail::size_of<FlgCurveSetSimplifyDesc>);
        curves = curves_;
    }
};

/// How a style is prepared (Minarcik, Fiser, Sykora: Example-Based Authoring of Expressive Space Curves, sec. 4.1 to
/// 4.4).
struct StyleDesc : FlgStyleDesc {
    /// The defaults.
    StyleDesc() { flgStyleDescInit(this, detail::size_of<FlgStyleDesc>); }
    /// Of the C struct.
    StyleDesc(const FlgStyleDesc& c) : FlgStyleDesc(c) {}
    /// The defaults, with style.
    StyleDesc(FlgCurveSet style_) {
        flgStyleDescInit(this, detail::size_of<FlgStyleDesc>);
        style = style_;
    }
    /// Sets patch_sizes and patch_size_count. The array must live until the descriptor is used.
    void set_patch_sizes(Span<const FlgPatchSize> values) {
        patch_sizes = values.data();
        patch_size_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_patch_sizes(std::initializer_list<FlgPatchSize>) = delete;
    /// Sets attributes and attribute_count. The array must live until the descriptor is used.
    void set_attributes(Span<const FlgStyleAttribute> values) {
        attributes = values.data();
        attribute_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_attributes(std::initializer_list<FlgStyleAttribute>) = delete;
};

/// FlgCurveSetStylizeDesc with its defaults.
struct CurveSetStylizeDesc : FlgCurveSetStylizeDesc {
    /// The defaults.
    CurveSetStylizeDesc() { flgCurveSetStylizeDescInit(this, detail::size_of<FlgCurveSetStylizeDesc>); }
    /// Of the C struct.
    CurveSetStylizeDesc(const FlgCurveSetStylizeDesc& c) : FlgCurveSetStylizeDesc(c) {}
    /// The defaults, with style and target.
    CurveSetStylizeDesc(FlgStyle style_, FlgCurveSet target_) {
        flgCurveSetStylizeDescInit(this, detail::size_of<FlgCurveSetStylizeDesc>);
        style = style_;
        target = target_;
    }
    /// Sets drives and drive_count. The array must live until the descriptor is used.
    void set_drives(Span<const FlgStyleDrive> values) {
        drives = values.data();
        drive_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_drives(std::initializer_list<FlgStyleDrive>) = delete;
    /// Sets further_styles and further_style_count. The array must live until the descriptor is used.
    void set_further_styles(Span<const FlgStyle> values) {
        further_styles = values.data();
        further_style_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_further_styles(std::initializer_list<FlgStyle>) = delete;
};

/// FlgSurfaceDesc with its defaults.
struct SurfaceDesc : FlgSurfaceDesc {
    /// The defaults.
    SurfaceDesc() { flgSurfaceDescInit(this, detail::size_of<FlgSurfaceDesc>); }
    /// Of the C struct.
    SurfaceDesc(const FlgSurfaceDesc& c) : FlgSurfaceDesc(c) {}
};

/// FlgSurfaceRefineDesc with its defaults.
struct SurfaceRefineDesc : FlgSurfaceRefineDesc {
    /// The defaults.
    SurfaceRefineDesc() { flgSurfaceRefineDescInit(this, detail::size_of<FlgSurfaceRefineDesc>); }
    /// Of the C struct.
    SurfaceRefineDesc(const FlgSurfaceRefineDesc& c) : FlgSurfaceRefineDesc(c) {}
    /// The defaults, with surface.
    SurfaceRefineDesc(FlgSurface surface_) {
        flgSurfaceRefineDescInit(this, detail::size_of<FlgSurfaceRefineDesc>);
        surface = surface_;
    }
};

/// FlgSurfaceCurvesLiftDesc with its defaults.
struct SurfaceCurvesLiftDesc : FlgSurfaceCurvesLiftDesc {
    /// The defaults.
    SurfaceCurvesLiftDesc() { flgSurfaceCurvesLiftDescInit(this, detail::size_of<FlgSurfaceCurvesLiftDesc>); }
    /// Of the C struct.
    SurfaceCurvesLiftDesc(const FlgSurfaceCurvesLiftDesc& c) : FlgSurfaceCurvesLiftDesc(c) {}
    /// The defaults, with curves.
    SurfaceCurvesLiftDesc(FlgSurfaceCurves curves_) {
        flgSurfaceCurvesLiftDescInit(this, detail::size_of<FlgSurfaceCurvesLiftDesc>);
        curves = curves_;
    }
};

/// FlgFieldGeodesicDesc with its defaults.
struct FieldGeodesicDesc : FlgFieldGeodesicDesc {
    /// The defaults.
    FieldGeodesicDesc() { flgFieldGeodesicDescInit(this, detail::size_of<FlgFieldGeodesicDesc>); }
    /// Of the C struct.
    FieldGeodesicDesc(const FlgFieldGeodesicDesc& c) : FlgFieldGeodesicDesc(c) {}
    /// The defaults, with surface.
    FieldGeodesicDesc(FlgSurface surface_) {
        flgFieldGeodesicDescInit(this, detail::size_of<FlgFieldGeodesicDesc>);
        surface = surface_;
    }
    /// Sets vertices and vertex_count. The array must live until the descriptor is used.
    void set_vertices(Span<const uint32_t> values) {
        vertices = values.data();
        vertex_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_vertices(std::initializer_list<uint32_t>) = delete;
    /// Sets points and point_count. The array must live until the descriptor is used.
    void set_points(Span<const FlgSurfacePoint> values) {
        points = values.data();
        point_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_points(std::initializer_list<FlgSurfacePoint>) = delete;
    /// Sets border_regions and border_region_count. The array must live until the descriptor is used.
    void set_border_regions(Span<const uint32_t> values) {
        border_regions = values.data();
        border_region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_border_regions(std::initializer_list<uint32_t>) = delete;
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
    /// Sets targets and target_count. The array must live until the descriptor is used.
    void set_targets(Span<const uint32_t> values) {
        targets = values.data();
        target_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_targets(std::initializer_list<uint32_t>) = delete;
};

/// FlgFieldBlendDesc with its defaults.
struct FieldBlendDesc : FlgFieldBlendDesc {
    /// The defaults.
    FieldBlendDesc() { flgFieldBlendDescInit(this, detail::size_of<FlgFieldBlendDesc>); }
    /// Of the C struct.
    FieldBlendDesc(const FlgFieldBlendDesc& c) : FlgFieldBlendDesc(c) {}
    /// The defaults, with from and to.
    FieldBlendDesc(FlgField from_, FlgField to_) {
        flgFieldBlendDescInit(this, detail::size_of<FlgFieldBlendDesc>);
        from = from_;
        to = to_;
    }
};

/// FlgSurfaceSampleDesc with its defaults.
struct SurfaceSampleDesc : FlgSurfaceSampleDesc {
    /// The defaults.
    SurfaceSampleDesc() { flgSurfaceSampleDescInit(this, detail::size_of<FlgSurfaceSampleDesc>); }
    /// Of the C struct.
    SurfaceSampleDesc(const FlgSurfaceSampleDesc& c) : FlgSurfaceSampleDesc(c) {}
    /// The defaults, with surface.
    SurfaceSampleDesc(FlgSurface surface_) {
        flgSurfaceSampleDescInit(this, detail::size_of<FlgSurfaceSampleDesc>);
        surface = surface_;
    }
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// FlgSurfaceSampleBordersDesc with its defaults.
struct SurfaceSampleBordersDesc : FlgSurfaceSampleBordersDesc {
    /// The defaults.
    SurfaceSampleBordersDesc() { flgSurfaceSampleBordersDescInit(this, detail::size_of<FlgSurfaceSampleBordersDesc>); }
    /// Of the C struct.
    SurfaceSampleBordersDesc(const FlgSurfaceSampleBordersDesc& c) : FlgSurfaceSampleBordersDesc(c) {}
    /// The defaults, with surface.
    SurfaceSampleBordersDesc(FlgSurface surface_) {
        flgSurfaceSampleBordersDescInit(this, detail::size_of<FlgSurfaceSampleBordersDesc>);
        surface = surface_;
    }
};

/// FlgFieldTraceIsolinesDesc with its defaults.
struct FieldTraceIsolinesDesc : FlgFieldTraceIsolinesDesc {
    /// The defaults.
    FieldTraceIsolinesDesc() { flgFieldTraceIsolinesDescInit(this, detail::size_of<FlgFieldTraceIsolinesDesc>); }
    /// Of the C struct.
    FieldTraceIsolinesDesc(const FlgFieldTraceIsolinesDesc& c) : FlgFieldTraceIsolinesDesc(c) {}
    /// The defaults, with field.
    FieldTraceIsolinesDesc(FlgField field_) {
        flgFieldTraceIsolinesDescInit(this, detail::size_of<FlgFieldTraceIsolinesDesc>);
        field = field_;
    }
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// FlgFieldTraceStreamsDesc with its defaults.
struct FieldTraceStreamsDesc : FlgFieldTraceStreamsDesc {
    /// The defaults.
    FieldTraceStreamsDesc() { flgFieldTraceStreamsDescInit(this, detail::size_of<FlgFieldTraceStreamsDesc>); }
    /// Of the C struct.
    FieldTraceStreamsDesc(const FlgFieldTraceStreamsDesc& c) : FlgFieldTraceStreamsDesc(c) {}
    /// The defaults, with field.
    FieldTraceStreamsDesc(FlgField field_) {
        flgFieldTraceStreamsDescInit(this, detail::size_of<FlgFieldTraceStreamsDesc>);
        field = field_;
    }
    /// Sets starts and start_count. The array must live until the descriptor is used.
    void set_starts(Span<const FlgSurfacePoint> values) {
        starts = values.data();
        start_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_starts(std::initializer_list<FlgSurfacePoint>) = delete;
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// FlgFieldTracePathsDesc with its defaults.
struct FieldTracePathsDesc : FlgFieldTracePathsDesc {
    /// The defaults.
    FieldTracePathsDesc() { flgFieldTracePathsDescInit(this, detail::size_of<FlgFieldTracePathsDesc>); }
    /// Of the C struct.
    FieldTracePathsDesc(const FlgFieldTracePathsDesc& c) : FlgFieldTracePathsDesc(c) {}
    /// The defaults, with surface.
    FieldTracePathsDesc(FlgSurface surface_) {
        flgFieldTracePathsDescInit(this, detail::size_of<FlgFieldTracePathsDesc>);
        surface = surface_;
    }
    /// Sets path_offsets and path_count. The array must live until the descriptor is used.
    void set_path_offsets(Span<const uint32_t> values) {
        path_offsets = values.data();
        path_count = detail::count(values.empty() ? 0 : values.size() - 1);
    }
    /// A list would end before the descriptor is used.
    void set_path_offsets(std::initializer_list<uint32_t>) = delete;
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// FlgSurfaceCutIsolinesDesc with its defaults.
struct SurfaceCutIsolinesDesc : FlgSurfaceCutIsolinesDesc {
    /// The defaults.
    SurfaceCutIsolinesDesc() { flgSurfaceCutIsolinesDescInit(this, detail::size_of<FlgSurfaceCutIsolinesDesc>); }
    /// Of the C struct.
    SurfaceCutIsolinesDesc(const FlgSurfaceCutIsolinesDesc& c) : FlgSurfaceCutIsolinesDesc(c) {}
    /// The defaults, with field.
    SurfaceCutIsolinesDesc(FlgField field_) {
        flgSurfaceCutIsolinesDescInit(this, detail::size_of<FlgSurfaceCutIsolinesDesc>);
        field = field_;
    }
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// FlgSurfaceCutCurvesDesc with its defaults.
struct SurfaceCutCurvesDesc : FlgSurfaceCutCurvesDesc {
    /// The defaults.
    SurfaceCutCurvesDesc() { flgSurfaceCutCurvesDescInit(this, detail::size_of<FlgSurfaceCutCurvesDesc>); }
    /// Of the C struct.
    SurfaceCutCurvesDesc(const FlgSurfaceCutCurvesDesc& c) : FlgSurfaceCutCurvesDesc(c) {}
    /// The defaults, with curves.
    SurfaceCutCurvesDesc(FlgSurfaceCurves curves_) {
        flgSurfaceCutCurvesDescInit(this, detail::size_of<FlgSurfaceCutCurvesDesc>);
        curves = curves_;
    }
};

/// Where an operator starts: everything named here, combined. Empty by default. Arrays are copied.
struct TangleSeeds : FlgTangleSeeds {
    /// The defaults.
    TangleSeeds() { flgTangleSeedsInit(this, detail::size_of<FlgTangleSeeds>); }
    /// Of the C struct.
    TangleSeeds(const FlgTangleSeeds& c) : FlgTangleSeeds(c) {}
    /// Sets points and point_count. The array must live until the descriptor is used.
    void set_points(Span<const FlgSurfacePoint> values) {
        points = values.data();
        point_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_points(std::initializer_list<FlgSurfacePoint>) = delete;
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// An operator. It numbers parts as follows. Between isolines: outwards from the seeds. Between streams: along a. For a
/// polyline: 0 left of its curves (where most of the border is) and 1 elsewhere. Otherwise: in the order of their first
/// triangles.
struct TangleDivideDesc : FlgTangleDivideDesc {
    /// The defaults.
    TangleDivideDesc() { flgTangleDivideDescInit(this, detail::size_of<FlgTangleDivideDesc>); }
    /// Of the C struct.
    TangleDivideDesc(const FlgTangleDivideDesc& c) : FlgTangleDivideDesc(c) {}
    /// The defaults, with tangle.
    TangleDivideDesc(FlgTangle tangle_) {
        flgTangleDivideDescInit(this, detail::size_of<FlgTangleDivideDesc>);
        tangle = tangle_;
    }
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// Common combinations of operators, sec. 3.4 and Fig. 13.
struct TangleApplyMacroDesc : FlgTangleApplyMacroDesc {
    /// The defaults.
    TangleApplyMacroDesc() { flgTangleApplyMacroDescInit(this, detail::size_of<FlgTangleApplyMacroDesc>); }
    /// Of the C struct.
    TangleApplyMacroDesc(const FlgTangleApplyMacroDesc& c) : FlgTangleApplyMacroDesc(c) {}
    /// The defaults, with tangle.
    TangleApplyMacroDesc(FlgTangle tangle_) {
        flgTangleApplyMacroDescInit(this, detail::size_of<FlgTangleApplyMacroDesc>);
        tangle = tangle_;
    }
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// Moves vertices of regions along the surface's normals, sec. 3.4, after an operator. Each leaf rises by `amount` at
/// the point farthest from its borders, or wherever the borders are `reach` or more away; borders stay. In between, the
/// height is a profile of the distance, by the bias and gain of Schlick (1994). The ridges of the distance are rounded,
/// by some percent of the largest one; normals are smoothed within the regions, over up to half of `amount`. Where a
/// triangle that is no sliver would turn over, the height is lowered. (Parts of the surface that face each other may
/// still meet.) Later distances are measured on the new surface.
struct TangleDisplaceDesc : FlgTangleDisplaceDesc {
    /// The defaults.
    TangleDisplaceDesc() { flgTangleDisplaceDescInit(this, detail::size_of<FlgTangleDisplaceDesc>); }
    /// Of the C struct.
    TangleDisplaceDesc(const FlgTangleDisplaceDesc& c) : FlgTangleDisplaceDesc(c) {}
    /// The defaults, with tangle.
    TangleDisplaceDesc(FlgTangle tangle_) {
        flgTangleDisplaceDescInit(this, detail::size_of<FlgTangleDisplaceDesc>);
        tangle = tangle_;
    }
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// Where an operator's seeds were: used to find them again on another mesh of the same shape. Positions are x, y, z in
/// metres.
struct TangleSeedPlaces : FlgTangleSeedPlaces {
    /// The defaults.
    TangleSeedPlaces() { flgTangleSeedPlacesInit(this, detail::size_of<FlgTangleSeedPlaces>); }
    /// Of the C struct.
    TangleSeedPlaces(const FlgTangleSeedPlaces& c) : FlgTangleSeedPlaces(c) {}
    /// Sets points and point_count. The array must live until the descriptor is used.
    void set_points(Span<const float> values) {
        points = values.data();
        point_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_points(std::initializer_list<float>) = delete;
    /// Sets loops and loop_count. The array must live until the descriptor is used.
    void set_loops(Span<const float> values) {
        loops = values.data();
        loop_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_loops(std::initializer_list<float>) = delete;
    /// Sets samples and sample_count. The array must live until the descriptor is used.
    void set_samples(Span<const float> values) {
        samples = values.data();
        sample_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_samples(std::initializer_list<float>) = delete;
};

/// The arguments of a step, and the data needed to repeat it.
struct TangleStep : FlgTangleStep {
    /// The defaults.
    TangleStep() { flgTangleStepInit(this, detail::size_of<FlgTangleStep>); }
    /// Of the C struct.
    TangleStep(const FlgTangleStep& c) : FlgTangleStep(c) {}
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
    /// Sets places and place_count. The array must live until the descriptor is used.
    void set_places(Span<const FlgTangleSeedPlaces* const> values) {
        places = values.data();
        place_count = detail::count(values.size());
    }
    /// Sets made and made_count. The array must live until the descriptor is used.
    void set_made(Span<const float> values) {
        made = values.data();
        made_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_made(std::initializer_list<float>) = delete;
    /// Sets names and name_count. The array must live until the descriptor is used.
    void set_names(Span<const FlgTangleRegionName> values) {
        names = values.data();
        name_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_names(std::initializer_list<FlgTangleRegionName>) = delete;
};

/// What is drawn, and where to: null maps are not wanted, one at least is.
struct TangleBakeDesc : FlgTangleBakeDesc {
    /// The defaults.
    TangleBakeDesc() { flgTangleBakeDescInit(this, detail::size_of<FlgTangleBakeDesc>); }
    /// Of the C struct.
    TangleBakeDesc(const FlgTangleBakeDesc& c) : FlgTangleBakeDesc(c) {}
    /// The defaults, with tangle.
    TangleBakeDesc(FlgTangle tangle_) {
        flgTangleBakeDescInit(this, detail::size_of<FlgTangleBakeDesc>);
        tangle = tangle_;
    }
};

/// What to make, and of which curves.
struct BrushMeshDesc : FlgBrushMeshDesc {
    /// The defaults.
    BrushMeshDesc() { flgBrushMeshDescInit(this, detail::size_of<FlgBrushMeshDesc>); }
    /// Of the C struct.
    BrushMeshDesc(const FlgBrushMeshDesc& c) : FlgBrushMeshDesc(c) {}
};

/// Where a growing stroke is. One per stroke; plain data that the host may copy, but not change.
struct BrushMeshState : FlgBrushMeshState {
    /// The defaults.
    BrushMeshState() { flgBrushMeshStateInit(this, detail::size_of<FlgBrushMeshState>); }
    /// Of the C struct.
    BrushMeshState(const FlgBrushMeshState& c) : FlgBrushMeshState(c) {}
};

/// The buffers. They must not overlap each other, nor the input. Written from front to back and never read: mapped
/// memory of a graphics card will do.
struct BrushMeshOutput : FlgBrushMeshOutput {
    /// The defaults.
    BrushMeshOutput() { flgBrushMeshOutputInit(this, detail::size_of<FlgBrushMeshOutput>); }
    /// Of the C struct.
    BrushMeshOutput(const FlgBrushMeshOutput& c) : FlgBrushMeshOutput(c) {}
    /// Sets columns and column_count. The array must live until the descriptor is used.
    void set_columns(Span<const FlgBufferColumn> values) {
        columns = values.data();
        column_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_columns(std::initializer_list<FlgBufferColumn>) = delete;
};

/// FlgStraightSkeletonDesc with its defaults.
struct StraightSkeletonDesc : FlgStraightSkeletonDesc {
    /// The defaults.
    StraightSkeletonDesc() { flgStraightSkeletonDescInit(this, detail::size_of<FlgStraightSkeletonDesc>); }
    /// Of the C struct.
    StraightSkeletonDesc(const FlgStraightSkeletonDesc& c) : FlgStraightSkeletonDesc(c) {}
};

/// The front of a straight skeleton at a time. The host owns the arrays; null arrays are not written.
struct OffsetPolygons : FlgOffsetPolygons {
    /// The defaults.
    OffsetPolygons() { flgOffsetPolygonsInit(this, detail::size_of<FlgOffsetPolygons>); }
    /// Of the C struct.
    OffsetPolygons(const FlgOffsetPolygons& c) : FlgOffsetPolygons(c) {}
};

/// FlgOutlineDesc with its defaults.
struct OutlineDesc : FlgOutlineDesc {
    /// The defaults.
    OutlineDesc() { flgOutlineDescInit(this, detail::size_of<FlgOutlineDesc>); }
    /// Of the C struct.
    OutlineDesc(const FlgOutlineDesc& c) : FlgOutlineDesc(c) {}
    /// The defaults, with surface.
    OutlineDesc(FlgSurface surface_) {
        flgOutlineDescInit(this, detail::size_of<FlgOutlineDesc>);
        surface = surface_;
    }
    /// Sets regions and region_count. The array must live until the descriptor is used.
    void set_regions(Span<const uint32_t> values) {
        regions = values.data();
        region_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_regions(std::initializer_list<uint32_t>) = delete;
};

/// Fractions are of the part's length: the drawn length of the contour's ring 0, but at most three times its box
/// diagonal (a frayed line does not make a larger drawing).
struct PartDesc : FlgPartDesc {
    /// The defaults.
    PartDesc() { flgPartDescInit(this, detail::size_of<FlgPartDesc>); }
    /// Of the C struct.
    PartDesc(const FlgPartDesc& c) : FlgPartDesc(c) {}
};

/// FlgPartMeshDesc with its defaults.
struct PartMeshDesc : FlgPartMeshDesc {
    /// The defaults.
    PartMeshDesc() { flgPartMeshDescInit(this, detail::size_of<FlgPartMeshDesc>); }
    /// Of the C struct.
    PartMeshDesc(const FlgPartMeshDesc& c) : FlgPartMeshDesc(c) {}
    /// The defaults, with part.
    PartMeshDesc(FlgPart part_) {
        flgPartMeshDescInit(this, detail::size_of<FlgPartMeshDesc>);
        part = part_;
    }
};

/// Resolution of the bones. The four are fractions of the model's size, the largest length among its placed parts: 0 to
/// 10 each. The defaults give a person some 20 joints. The paper's are 0.0025, 0.015, 0.015 and 0.005, with detail 0.
struct BoneThresholds : FlgBoneThresholds {
    /// The defaults.
    BoneThresholds() { flgBoneThresholdsInit(this, detail::size_of<FlgBoneThresholds>); }
    /// Of the C struct.
    BoneThresholds(const FlgBoneThresholds& c) : FlgBoneThresholds(c) {}
};

/// A part, its place in a model, and its refinement there.
struct ModelPart : FlgModelPart {
    /// The defaults.
    ModelPart() { flgModelPartInit(this, detail::size_of<FlgModelPart>); }
    /// Of the C struct.
    ModelPart(const FlgModelPart& c) : FlgModelPart(c) {}
    /// The defaults, with part.
    ModelPart(FlgPart part_) {
        flgModelPartInit(this, detail::size_of<FlgModelPart>);
        part = part_;
    }
    /// Sets branch_simplify and branch_count. The array must live until the descriptor is used.
    void set_branch_simplify(Span<const float> values) {
        branch_simplify = values.data();
        branch_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_branch_simplify(std::initializer_list<float>) = delete;
};

/// Joints are told by their keys (FlgModelView::joint_keys), which survive edits of the drawing: pass the same list
/// with every model. A key without its .L or .R means both. Edits of joints that are not there wait until they are.
struct JointEdit : FlgJointEdit {
    /// The defaults.
    JointEdit() { flgJointEditInit(this, detail::size_of<FlgJointEdit>); }
    /// Of the C struct.
    JointEdit(const FlgJointEdit& c) : FlgJointEdit(c) {}
};

/// FlgModelDesc with its defaults.
struct ModelDesc : FlgModelDesc {
    /// The defaults.
    ModelDesc() { flgModelDescInit(this, detail::size_of<FlgModelDesc>); }
    /// Of the C struct.
    ModelDesc(const FlgModelDesc& c) : FlgModelDesc(c) {}
    /// Sets parts and part_count. The array must live until the descriptor is used.
    void set_parts(Span<const FlgModelPart> values) {
        parts = values.data();
        part_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_parts(std::initializer_list<FlgModelPart>) = delete;
    /// Sets joint_edits and joint_edit_count. The array must live until the descriptor is used.
    void set_joint_edits(Span<const FlgJointEdit> values) {
        joint_edits = values.data();
        joint_edit_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_joint_edits(std::initializer_list<FlgJointEdit>) = delete;
    /// Sets apart_pairs and apart_pair_count. The array must live until the descriptor is used.
    void set_apart_pairs(Span<const uint32_t> values) {
        apart_pairs = values.data();
        apart_pair_count = detail::count(values.size(), 2);
    }
    /// A list would end before the descriptor is used.
    void set_apart_pairs(std::initializer_list<uint32_t>) = delete;
};

/// FlgSkinDesc with its defaults.
struct SkinDesc : FlgSkinDesc {
    /// The defaults.
    SkinDesc() { flgSkinDescInit(this, detail::size_of<FlgSkinDesc>); }
    /// Of the C struct.
    SkinDesc(const FlgSkinDesc& c) : FlgSkinDesc(c) {}
    /// The defaults, with model.
    SkinDesc(FlgModel model_) {
        flgSkinDescInit(this, detail::size_of<FlgSkinDesc>);
        model = model_;
    }
};

/// FlgSkinFromMeshDesc with its defaults.
struct SkinFromMeshDesc : FlgSkinFromMeshDesc {
    /// The defaults.
    SkinFromMeshDesc() { flgSkinFromMeshDescInit(this, detail::size_of<FlgSkinFromMeshDesc>); }
    /// Of the C struct.
    SkinFromMeshDesc(const FlgSkinFromMeshDesc& c) : FlgSkinFromMeshDesc(c) {}
};

/// FlgSkinSimplifyDesc with its defaults.
struct SkinSimplifyDesc : FlgSkinSimplifyDesc {
    /// The defaults.
    SkinSimplifyDesc() { flgSkinSimplifyDescInit(this, detail::size_of<FlgSkinSimplifyDesc>); }
    /// Of the C struct.
    SkinSimplifyDesc(const FlgSkinSimplifyDesc& c) : FlgSkinSimplifyDesc(c) {}
    /// The defaults, with skin.
    SkinSimplifyDesc(FlgSkin skin_) {
        flgSkinSimplifyDescInit(this, detail::size_of<FlgSkinSimplifyDesc>);
        skin = skin_;
    }
};

/// FlgSkinSetWeightsDesc with its defaults.
struct SkinSetWeightsDesc : FlgSkinSetWeightsDesc {
    /// The defaults.
    SkinSetWeightsDesc() { flgSkinSetWeightsDescInit(this, detail::size_of<FlgSkinSetWeightsDesc>); }
    /// Of the C struct.
    SkinSetWeightsDesc(const FlgSkinSetWeightsDesc& c) : FlgSkinSetWeightsDesc(c) {}
    /// The defaults, with skin.
    SkinSetWeightsDesc(FlgSkin skin_) {
        flgSkinSetWeightsDescInit(this, detail::size_of<FlgSkinSetWeightsDesc>);
        skin = skin_;
    }
    /// Sets vertex_joints and vertex_count. The array must live until the descriptor is used.
    void set_vertex_joints(Span<const uint16_t> values) {
        vertex_joints = values.data();
        vertex_count = detail::count(values.size(), 4);
    }
    /// A list would end before the descriptor is used.
    void set_vertex_joints(std::initializer_list<uint16_t>) = delete;
    /// Sets vertex_weights and vertex_count. The array must live until the descriptor is used.
    void set_vertex_weights(Span<const float> values) {
        vertex_weights = values.data();
        vertex_count = detail::count(values.size(), 4);
    }
    /// A list would end before the descriptor is used.
    void set_vertex_weights(std::initializer_list<float>) = delete;
};

/// A motion of a skin's joints.
struct SkinAnimation : FlgSkinAnimation {
    /// The defaults.
    SkinAnimation() { flgSkinAnimationInit(this, detail::size_of<FlgSkinAnimation>); }
    /// Of the C struct.
    SkinAnimation(const FlgSkinAnimation& c) : FlgSkinAnimation(c) {}
    /// Sets times and key_count. The array must live until the descriptor is used.
    void set_times(Span<const float> values) {
        times = values.data();
        key_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_times(std::initializer_list<float>) = delete;
    /// Sets translations and key_count. The array must live until the descriptor is used.
    void set_translations(Span<const float> values) {
        translations = values.data();
        key_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_translations(std::initializer_list<float>) = delete;
};

/// The buffers, and which part of a result they get.
struct BufferOutput : FlgBufferOutput {
    /// The defaults.
    BufferOutput() { flgBufferOutputInit(this, detail::size_of<FlgBufferOutput>); }
    /// Of the C struct.
    BufferOutput(const FlgBufferOutput& c) : FlgBufferOutput(c) {}
    /// Sets columns and column_count. The array must live until the descriptor is used.
    void set_columns(Span<const FlgBufferColumn> values) {
        columns = values.data();
        column_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_columns(std::initializer_list<FlgBufferColumn>) = delete;
};

/// Columns of any view, and where they go.
struct ColumnsWriteDesc : FlgColumnsWriteDesc {
    /// The defaults.
    ColumnsWriteDesc() { flgColumnsWriteDescInit(this, detail::size_of<FlgColumnsWriteDesc>); }
    /// Of the C struct.
    ColumnsWriteDesc(const FlgColumnsWriteDesc& c) : FlgColumnsWriteDesc(c) {}
    /// Sets columns and column_count. The array must live until the descriptor is used.
    void set_columns(Span<const FlgColumn> values) {
        columns = values.data();
        column_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_columns(std::initializer_list<FlgColumn>) = delete;
};

/// FlgRigFindDesc with its defaults.
struct RigFindDesc : FlgRigFindDesc {
    /// The defaults.
    RigFindDesc() { flgRigFindDescInit(this, detail::size_of<FlgRigFindDesc>); }
    /// Of the C struct.
    RigFindDesc(const FlgRigFindDesc& c) : FlgRigFindDesc(c) {}
    /// Sets joint_positions and joint_count. The array must live until the descriptor is used.
    void set_joint_positions(Span<const float> values) {
        joint_positions = values.data();
        joint_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_joint_positions(std::initializer_list<float>) = delete;
    /// Sets joint_radii and joint_count. The array must live until the descriptor is used.
    void set_joint_radii(Span<const float> values) {
        joint_radii = values.data();
        joint_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_joint_radii(std::initializer_list<float>) = delete;
    /// Sets joint_parents and joint_count. The array must live until the descriptor is used.
    void set_joint_parents(Span<const uint32_t> values) {
        joint_parents = values.data();
        joint_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_joint_parents(std::initializer_list<uint32_t>) = delete;
};

/// Files of the host: archives, assets, consoles. Called only within calls of this library that were given it, on their
/// threads. Paths are those the host passes, and names beside them that files or this library give, put together with
/// `/`; UTF-8. This library opens no path with `..` that the host did not pass. One file is open at a time in a call.
/// Each function returns FLG_OK or an error, such as FLG_ERROR_FILE; the call that needs the file then fails with it.
struct FileSystem : FlgFileSystem {
    /// The defaults.
    FileSystem() { flgFileSystemInit(this, detail::size_of<FlgFileSystem>); }
    /// Of the C struct.
    FileSystem(const FlgFileSystem& c) : FlgFileSystem(c) {}
};

/// What a call uses of the host. The structs are copied; what they point to must live as long as what the call makes.
struct FileHooks : FlgFileHooks {
    /// The defaults.
    FileHooks() { flgFileHooksInit(this, detail::size_of<FlgFileHooks>); }
    /// Of the C struct.
    FileHooks(const FlgFileHooks& c) : FlgFileHooks(c) {}
};

/// How a curve file is read.
struct CurveFileReadDesc : FlgCurveFileReadDesc {
    /// The defaults.
    CurveFileReadDesc() { flgCurveFileReadDescInit(this, detail::size_of<FlgCurveFileReadDesc>); }
    /// Of the C struct.
    CurveFileReadDesc(const FlgCurveFileReadDesc& c) : FlgCurveFileReadDesc(c) {}
};

/// FlgCurveFileWriteDesc with its defaults.
struct CurveFileWriteDesc : FlgCurveFileWriteDesc {
    /// The defaults.
    CurveFileWriteDesc() { flgCurveFileWriteDescInit(this, detail::size_of<FlgCurveFileWriteDesc>); }
    /// Of the C struct.
    CurveFileWriteDesc(const FlgCurveFileWriteDesc& c) : FlgCurveFileWriteDesc(c) {}
};

/// How a mesh file is read.
struct MeshFileReadDesc : FlgMeshFileReadDesc {
    /// The defaults.
    MeshFileReadDesc() { flgMeshFileReadDescInit(this, detail::size_of<FlgMeshFileReadDesc>); }
    /// Of the C struct.
    MeshFileReadDesc(const FlgMeshFileReadDesc& c) : FlgMeshFileReadDesc(c) {}
};

/// Integers per triangle, with a name.
struct MeshFaceColumn : FlgMeshFaceColumn {
    /// The defaults.
    MeshFaceColumn() { flgMeshFaceColumnInit(this, detail::size_of<FlgMeshFaceColumn>); }
    /// Of the C struct.
    MeshFaceColumn(const FlgMeshFaceColumn& c) : FlgMeshFaceColumn(c) {}
};

/// A picture that colours triangles, by the texture coordinates of their corners: 0 0 is its upper left, 1 1 its lower
/// right.
struct Texture : FlgTexture {
    /// The defaults.
    Texture() { flgTextureInit(this, detail::size_of<FlgTexture>); }
    /// Of the C struct.
    Texture(const FlgTexture& c) : FlgTexture(c) {}
};

/// A region's material: glTF's metallic-roughness model, and a line where it meets another region. Colours are linear
/// RGB.
struct MeshMaterial : FlgMeshMaterial {
    /// The defaults.
    MeshMaterial() { flgMeshMaterialInit(this, detail::size_of<FlgMeshMaterial>); }
    /// Of the C struct.
    MeshMaterial(const FlgMeshMaterial& c) : FlgMeshMaterial(c) {}
};

/// FlgMeshFileWriteDesc with its defaults.
struct MeshFileWriteDesc : FlgMeshFileWriteDesc {
    /// The defaults.
    MeshFileWriteDesc() { flgMeshFileWriteDescInit(this, detail::size_of<FlgMeshFileWriteDesc>); }
    /// Of the C struct.
    MeshFileWriteDesc(const FlgMeshFileWriteDesc& c) : FlgMeshFileWriteDesc(c) {}
    /// Sets face_columns and face_column_count. The array must live until the descriptor is used.
    void set_face_columns(Span<const FlgMeshFaceColumn> values) {
        face_columns = values.data();
        face_column_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_face_columns(std::initializer_list<FlgMeshFaceColumn>) = delete;
    /// Sets materials and material_count. The array must live until the descriptor is used.
    void set_materials(Span<const FlgMeshMaterial> values) {
        materials = values.data();
        material_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_materials(std::initializer_list<FlgMeshMaterial>) = delete;
};

/// How a skin file is read.
struct SkinFileReadDesc : FlgSkinFileReadDesc {
    /// The defaults.
    SkinFileReadDesc() { flgSkinFileReadDescInit(this, detail::size_of<FlgSkinFileReadDesc>); }
    /// Of the C struct.
    SkinFileReadDesc(const FlgSkinFileReadDesc& c) : FlgSkinFileReadDesc(c) {}
};

/// A shape that a mesh takes as far as its weight says: vertices move by `moves`, times the weight, before joints move
/// them.
struct MorphTarget : FlgMorphTarget {
    /// The defaults.
    MorphTarget() { flgMorphTargetInit(this, detail::size_of<FlgMorphTarget>); }
    /// Of the C struct.
    MorphTarget(const FlgMorphTarget& c) : FlgMorphTarget(c) {}
};

/// Weights of all morph targets over time. Between keys they change evenly; before the first and after the last key
/// they hold.
struct MorphAnimation : FlgMorphAnimation {
    /// The defaults.
    MorphAnimation() { flgMorphAnimationInit(this, detail::size_of<FlgMorphAnimation>); }
    /// Of the C struct.
    MorphAnimation(const FlgMorphAnimation& c) : FlgMorphAnimation(c) {}
};

/// The extension VRMC_vrm of VRM 1.0: who made an avatar, and which of its joints are which bones. Its other fields are
/// left at the extension's defaults: only the author may use the avatar, and nobody may change it.
struct Vrm : FlgVrm {
    /// The defaults.
    Vrm() { flgVrmInit(this, detail::size_of<FlgVrm>); }
    /// Of the C struct.
    Vrm(const FlgVrm& c) : FlgVrm(c) {}
    /// Sets authors and author_count. The array must live until the descriptor is used.
    void set_authors(Span<const char* const> values) {
        authors = values.data();
        author_count = detail::count(values.size());
    }
};

/// FlgSkinFileWriteDesc with its defaults.
struct SkinFileWriteDesc : FlgSkinFileWriteDesc {
    /// The defaults.
    SkinFileWriteDesc() { flgSkinFileWriteDescInit(this, detail::size_of<FlgSkinFileWriteDesc>); }
    /// Of the C struct.
    SkinFileWriteDesc(const FlgSkinFileWriteDesc& c) : FlgSkinFileWriteDesc(c) {}
    /// Sets animations and animation_count. The array must live until the descriptor is used.
    void set_animations(Span<const FlgSkinAnimation> values) {
        animations = values.data();
        animation_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_animations(std::initializer_list<FlgSkinAnimation>) = delete;
    /// Sets materials and material_count. The array must live until the descriptor is used.
    void set_materials(Span<const FlgMeshMaterial> values) {
        materials = values.data();
        material_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_materials(std::initializer_list<FlgMeshMaterial>) = delete;
    /// Sets texture and texture_count. The array must live until the descriptor is used.
    void set_texture(Span<const uint8_t> values) {
        texture = values.data();
        texture_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_texture(std::initializer_list<uint8_t>) = delete;
    /// Sets textures and texture_count. The array must live until the descriptor is used.
    void set_textures(Span<const FlgTexture> values) {
        textures = values.data();
        texture_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_textures(std::initializer_list<FlgTexture>) = delete;
    /// Sets morphs and morph_count. The array must live until the descriptor is used.
    void set_morphs(Span<const FlgMorphTarget> values) {
        morphs = values.data();
        morph_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_morphs(std::initializer_list<FlgMorphTarget>) = delete;
    /// Sets morph_animations and morph_animation_count. The array must live until the descriptor is used.
    void set_morph_animations(Span<const FlgMorphAnimation> values) {
        morph_animations = values.data();
        morph_animation_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_morph_animations(std::initializer_list<FlgMorphAnimation>) = delete;
    /// Sets level_morphs and level_count. The array must live until the descriptor is used.
    void set_level_morphs(Span<const FlgMorphTarget> values) {
        level_morphs = values.data();
        level_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_level_morphs(std::initializer_list<FlgMorphTarget>) = delete;
};

/// FlgMotionFileWriteDesc with its defaults.
struct MotionFileWriteDesc : FlgMotionFileWriteDesc {
    /// The defaults.
    MotionFileWriteDesc() { flgMotionFileWriteDescInit(this, detail::size_of<FlgMotionFileWriteDesc>); }
    /// Of the C struct.
    MotionFileWriteDesc(const FlgMotionFileWriteDesc& c) : FlgMotionFileWriteDesc(c) {}
    /// Sets poses and position_count. The array must live until the descriptor is used.
    void set_poses(Span<const double> values) {
        poses = values.data();
        position_count = detail::count(values.size(), 12);
    }
    /// A list would end before the descriptor is used.
    void set_poses(std::initializer_list<double>) = delete;
};

/// FlgTangleFileWriteDesc with its defaults.
struct TangleFileWriteDesc : FlgTangleFileWriteDesc {
    /// The defaults.
    TangleFileWriteDesc() { flgTangleFileWriteDescInit(this, detail::size_of<FlgTangleFileWriteDesc>); }
    /// Of the C struct.
    TangleFileWriteDesc(const FlgTangleFileWriteDesc& c) : FlgTangleFileWriteDesc(c) {}
};

/// How a tangle's file is read.
struct TangleFileReadDesc : FlgTangleFileReadDesc {
    /// The defaults.
    TangleFileReadDesc() { flgTangleFileReadDescInit(this, detail::size_of<FlgTangleFileReadDesc>); }
    /// Of the C struct.
    TangleFileReadDesc(const FlgTangleFileReadDesc& c) : FlgTangleFileReadDesc(c) {}
};

/// FlgLiveStrokeDesc with its defaults.
struct LiveStrokeDesc : FlgLiveStrokeDesc {
    /// The defaults.
    LiveStrokeDesc() { flgLiveStrokeDescInit(this, detail::size_of<FlgLiveStrokeDesc>); }
    /// Of the C struct.
    LiveStrokeDesc(const FlgLiveStrokeDesc& c) : FlgLiveStrokeDesc(c) {}
    /// The defaults, with style.
    LiveStrokeDesc(FlgStyle style_) {
        flgLiveStrokeDescInit(this, detail::size_of<FlgLiveStrokeDesc>);
        style = style_;
    }
    /// Sets drives and drive_count. The array must live until the descriptor is used.
    void set_drives(Span<const FlgStyleDrive> values) {
        drives = values.data();
        drive_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_drives(std::initializer_list<FlgStyleDrive>) = delete;
    /// Sets further_styles and further_style_count. The array must live until the descriptor is used.
    void set_further_styles(Span<const FlgStyle> values) {
        further_styles = values.data();
        further_style_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_further_styles(std::initializer_list<FlgStyle>) = delete;
};

/// Samples of the controller, as columns: arrays of the host, or members of an array of structs.
struct LiveSampleView : FlgLiveSampleView {
    /// The defaults.
    LiveSampleView() { flgLiveSampleViewInit(this, detail::size_of<FlgLiveSampleView>); }
    /// Of the C struct.
    LiveSampleView(const FlgLiveSampleView& c) : FlgLiveSampleView(c) {}
    /// Sets positions and sample_count. The array must live until the descriptor is used.
    void set_positions(Span<const float> values) {
        positions = values.data();
        sample_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_positions(std::initializer_list<float>) = delete;
    /// Sets orientations and sample_count. The array must live until the descriptor is used.
    void set_orientations(Span<const float> values) {
        orientations = values.data();
        sample_count = detail::count(values.size(), 4);
    }
    /// A list would end before the descriptor is used.
    void set_orientations(std::initializer_list<float>) = delete;
    /// Sets pressures and sample_count. The array must live until the descriptor is used.
    void set_pressures(Span<const float> values) {
        pressures = values.data();
        sample_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_pressures(std::initializer_list<float>) = delete;
    /// Sets times and sample_count. The array must live until the descriptor is used.
    void set_times(Span<const double> values) {
        times = values.data();
        sample_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_times(std::initializer_list<double>) = delete;
};

/// FlgManifoldShapeDesc with its defaults.
struct ManifoldShapeDesc : FlgManifoldShapeDesc {
    /// The defaults.
    ManifoldShapeDesc() { flgManifoldShapeDescInit(this, detail::size_of<FlgManifoldShapeDesc>); }
    /// Of the C struct.
    ManifoldShapeDesc(const FlgManifoldShapeDesc& c) : FlgManifoldShapeDesc(c) {}
};

/// FlgManifoldFromSurfaceDesc with its defaults.
struct ManifoldFromSurfaceDesc : FlgManifoldFromSurfaceDesc {
    /// The defaults.
    ManifoldFromSurfaceDesc() { flgManifoldFromSurfaceDescInit(this, detail::size_of<FlgManifoldFromSurfaceDesc>); }
    /// Of the C struct.
    ManifoldFromSurfaceDesc(const FlgManifoldFromSurfaceDesc& c) : FlgManifoldFromSurfaceDesc(c) {}
    /// The defaults, with surface.
    ManifoldFromSurfaceDesc(FlgSurface surface_) {
        flgManifoldFromSurfaceDescInit(this, detail::size_of<FlgManifoldFromSurfaceDesc>);
        surface = surface_;
    }
};

/// FlgManifoldFromPointsDesc with its defaults.
struct ManifoldFromPointsDesc : FlgManifoldFromPointsDesc {
    /// The defaults.
    ManifoldFromPointsDesc() { flgManifoldFromPointsDescInit(this, detail::size_of<FlgManifoldFromPointsDesc>); }
    /// Of the C struct.
    ManifoldFromPointsDesc(const FlgManifoldFromPointsDesc& c) : FlgManifoldFromPointsDesc(c) {}
    /// Sets points and point_count. The array must live until the descriptor is used.
    void set_points(Span<const float> values) {
        points = values.data();
        point_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_points(std::initializer_list<float>) = delete;
    /// Sets normals and point_count. The array must live until the descriptor is used.
    void set_normals(Span<const float> values) {
        normals = values.data();
        point_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_normals(std::initializer_list<float>) = delete;
};

/// FlgManifoldFromGridDesc with its defaults.
struct ManifoldFromGridDesc : FlgManifoldFromGridDesc {
    /// The defaults.
    ManifoldFromGridDesc() { flgManifoldFromGridDescInit(this, detail::size_of<FlgManifoldFromGridDesc>); }
    /// Of the C struct.
    ManifoldFromGridDesc(const FlgManifoldFromGridDesc& c) : FlgManifoldFromGridDesc(c) {}
};

/// A manifold defined by the host. Worker threads call the functions, several at a time. They must not throw, call the
/// SDK or take more than some us, and must give the same numbers for the same arguments.
struct ManifoldFunctions : FlgManifoldFunctions {
    /// The defaults.
    ManifoldFunctions() { flgManifoldFunctionsInit(this, detail::size_of<FlgManifoldFunctions>); }
    /// Of the C struct.
    ManifoldFunctions(const FlgManifoldFunctions& c) : FlgManifoldFunctions(c) {}
};

/// A surface in R^3 that the host parametrizes.
struct PatchFunctions : FlgPatchFunctions {
    /// The defaults.
    PatchFunctions() { flgPatchFunctionsInit(this, detail::size_of<FlgPatchFunctions>); }
    /// Of the C struct.
    PatchFunctions(const FlgPatchFunctions& c) : FlgPatchFunctions(c) {}
};

/// In the plane only x and y are used. Metres.
struct Obstacle : FlgObstacle {
    /// The defaults.
    Obstacle() { flgObstacleInit(this, detail::size_of<FlgObstacle>); }
    /// Of the C struct.
    Obstacle(const FlgObstacle& c) : FlgObstacle(c) {}
    /// The defaults, with surface.
    Obstacle(FlgSurface surface_) {
        flgObstacleInit(this, detail::size_of<FlgObstacle>);
        surface = surface_;
    }
    /// Sets points and point_count. The array must live until the descriptor is used.
    void set_points(Span<const double> values) {
        points = values.data();
        point_count = detail::count(values.size(), 2);
    }
    /// A list would end before the descriptor is used.
    void set_points(std::initializer_list<double>) = delete;
};

/// FlgObstaclesDesc with its defaults.
struct ObstaclesDesc : FlgObstaclesDesc {
    /// The defaults.
    ObstaclesDesc() { flgObstaclesDescInit(this, detail::size_of<FlgObstaclesDesc>); }
    /// Of the C struct.
    ObstaclesDesc(const FlgObstaclesDesc& c) : FlgObstaclesDesc(c) {}
    /// Sets obstacles and obstacle_count. The array must live until the descriptor is used.
    void set_obstacles(Span<const FlgObstacle> values) {
        obstacles = values.data();
        obstacle_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_obstacles(std::initializer_list<FlgObstacle>) = delete;
};

/// What a curve does at one of its given points besides passing through: leave in a direction, or turn a corner.
struct SplineHandle : FlgSplineHandle {
    /// The defaults.
    SplineHandle() { flgSplineHandleInit(this, detail::size_of<FlgSplineHandle>); }
    /// Of the C struct.
    SplineHandle(const FlgSplineHandle& c) : FlgSplineHandle(c) {}
};

/// FlgSplineDesc with its defaults.
struct SplineDesc : FlgSplineDesc {
    /// The defaults.
    SplineDesc() { flgSplineDescInit(this, detail::size_of<FlgSplineDesc>); }
    /// Of the C struct.
    SplineDesc(const FlgSplineDesc& c) : FlgSplineDesc(c) {}
    /// The defaults, with manifold.
    SplineDesc(FlgManifold manifold_) {
        flgSplineDescInit(this, detail::size_of<FlgSplineDesc>);
        manifold = manifold_;
    }
    /// Sets curve_knots and point_count. The array must live until the descriptor is used.
    void set_curve_knots(Span<const uint32_t> values) {
        curve_knots = values.data();
        point_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_curve_knots(std::initializer_list<uint32_t>) = delete;
    /// Sets sides and side_count. The array must live until the descriptor is used.
    void set_sides(Span<const FlgObstacleSide> values) {
        sides = values.data();
        side_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_sides(std::initializer_list<FlgObstacleSide>) = delete;
    /// Sets handles and handle_count. The array must live until the descriptor is used.
    void set_handles(Span<const FlgSplineHandle> values) {
        handles = values.data();
        handle_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_handles(std::initializer_list<FlgSplineHandle>) = delete;
    /// Sets softness and point_count. The array must live until the descriptor is used.
    void set_softness(Span<const double> values) {
        softness = values.data();
        point_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_softness(std::initializer_list<double>) = delete;
};

/// FlgSplineTraceDesc with its defaults.
struct SplineTraceDesc : FlgSplineTraceDesc {
    /// The defaults.
    SplineTraceDesc() { flgSplineTraceDescInit(this, detail::size_of<FlgSplineTraceDesc>); }
    /// Of the C struct.
    SplineTraceDesc(const FlgSplineTraceDesc& c) : FlgSplineTraceDesc(c) {}
    /// The defaults, with spline.
    SplineTraceDesc(FlgSpline spline_) {
        flgSplineTraceDescInit(this, detail::size_of<FlgSplineTraceDesc>);
        spline = spline_;
    }
};

/// FlgSplineSampleDesc with its defaults.
struct SplineSampleDesc : FlgSplineSampleDesc {
    /// The defaults.
    SplineSampleDesc() { flgSplineSampleDescInit(this, detail::size_of<FlgSplineSampleDesc>); }
    /// Of the C struct.
    SplineSampleDesc(const FlgSplineSampleDesc& c) : FlgSplineSampleDesc(c) {}
    /// The defaults, with spline.
    SplineSampleDesc(FlgSpline spline_) {
        flgSplineSampleDescInit(this, detail::size_of<FlgSplineSampleDesc>);
        spline = spline_;
    }
};

/// FlgSplineSweepDesc with its defaults.
struct SplineSweepDesc : FlgSplineSweepDesc {
    /// The defaults.
    SplineSweepDesc() { flgSplineSweepDescInit(this, detail::size_of<FlgSplineSweepDesc>); }
    /// Of the C struct.
    SplineSweepDesc(const FlgSplineSweepDesc& c) : FlgSplineSweepDesc(c) {}
    /// The defaults, with spline.
    SplineSweepDesc(FlgSpline spline_) {
        flgSplineSweepDescInit(this, detail::size_of<FlgSplineSweepDesc>);
        spline = spline_;
    }
};

/// FlgSplineOffsetDesc with its defaults.
struct SplineOffsetDesc : FlgSplineOffsetDesc {
    /// The defaults.
    SplineOffsetDesc() { flgSplineOffsetDescInit(this, detail::size_of<FlgSplineOffsetDesc>); }
    /// Of the C struct.
    SplineOffsetDesc(const FlgSplineOffsetDesc& c) : FlgSplineOffsetDesc(c) {}
    /// The defaults, with spline.
    SplineOffsetDesc(FlgSpline spline_) {
        flgSplineOffsetDescInit(this, detail::size_of<FlgSplineOffsetDesc>);
        spline = spline_;
    }
};

/// FlgCableHangDesc with its defaults.
struct CableHangDesc : FlgCableHangDesc {
    /// The defaults.
    CableHangDesc() { flgCableHangDescInit(this, detail::size_of<FlgCableHangDesc>); }
    /// Of the C struct.
    CableHangDesc(const FlgCableHangDesc& c) : FlgCableHangDesc(c) {}
    /// Sets points and point_count. The array must live until the descriptor is used.
    void set_points(Span<const double> values) {
        points = values.data();
        point_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_points(std::initializer_list<double>) = delete;
    /// Sets cable_offsets and cable_count. The array must live until the descriptor is used.
    void set_cable_offsets(Span<const uint32_t> values) {
        cable_offsets = values.data();
        cable_count = detail::count(values.empty() ? 0 : values.size() - 1);
    }
    /// A list would end before the descriptor is used.
    void set_cable_offsets(std::initializer_list<uint32_t>) = delete;
};

/// FlgMotionDesc with its defaults.
struct MotionDesc : FlgMotionDesc {
    /// The defaults.
    MotionDesc() { flgMotionDescInit(this, detail::size_of<FlgMotionDesc>); }
    /// Of the C struct.
    MotionDesc(const FlgMotionDesc& c) : FlgMotionDesc(c) {}
    /// Sets times and key_count. The array must live until the descriptor is used.
    void set_times(Span<const double> values) {
        times = values.data();
        key_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_times(std::initializer_list<double>) = delete;
    /// Sets poses and key_count. The array must live until the descriptor is used.
    void set_poses(Span<const double> values) {
        poses = values.data();
        key_count = detail::count(values.size(), 12);
    }
    /// A list would end before the descriptor is used.
    void set_poses(std::initializer_list<double>) = delete;
    /// Sets body_points and body_point_count. The array must live until the descriptor is used.
    void set_body_points(Span<const double> values) {
        body_points = values.data();
        body_point_count = detail::count(values.size(), 3);
    }
    /// A list would end before the descriptor is used.
    void set_body_points(std::initializer_list<double>) = delete;
    /// Sets sides and side_count. The array must live until the descriptor is used.
    void set_sides(Span<const FlgObstacleSide> values) {
        sides = values.data();
        side_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_sides(std::initializer_list<FlgObstacleSide>) = delete;
    /// Sets look_points and look_count. The array must live until the descriptor is used.
    void set_look_points(Span<const double> values) {
        look_points = values.data();
        look_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_look_points(std::initializer_list<double>) = delete;
    /// Sets look_times and look_count. The array must live until the descriptor is used.
    void set_look_times(Span<const double> values) {
        look_times = values.data();
        look_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_look_times(std::initializer_list<double>) = delete;
};

/// FlgPickSceneDesc with its defaults.
struct PickSceneDesc : FlgPickSceneDesc {
    /// The defaults.
    PickSceneDesc() { flgPickSceneDescInit(this, detail::size_of<FlgPickSceneDesc>); }
    /// Of the C struct.
    PickSceneDesc(const FlgPickSceneDesc& c) : FlgPickSceneDesc(c) {}
};

/// FlgCurveSetProjectDesc with its defaults.
struct CurveSetProjectDesc : FlgCurveSetProjectDesc {
    /// The defaults.
    CurveSetProjectDesc() { flgCurveSetProjectDescInit(this, detail::size_of<FlgCurveSetProjectDesc>); }
    /// Of the C struct.
    CurveSetProjectDesc(const FlgCurveSetProjectDesc& c) : FlgCurveSetProjectDesc(c) {}
    /// The defaults, with surface and curves.
    CurveSetProjectDesc(FlgSurface surface_, FlgCurveSet curves_) {
        flgCurveSetProjectDescInit(this, detail::size_of<FlgCurveSetProjectDesc>);
        surface = surface_;
        curves = curves_;
    }
};

/// FlgPullDesc with its defaults.
struct PullDesc : FlgPullDesc {
    /// The defaults.
    PullDesc() { flgPullDescInit(this, detail::size_of<FlgPullDesc>); }
    /// Of the C struct.
    PullDesc(const FlgPullDesc& c) : FlgPullDesc(c) {}
};

/// A point of the surface, and where it is to be.
struct PullHandle : FlgPullHandle {
    /// The defaults.
    PullHandle() { flgPullHandleInit(this, detail::size_of<FlgPullHandle>); }
    /// Of the C struct.
    PullHandle(const FlgPullHandle& c) : FlgPullHandle(c) {}
};

/// FlgPulledDesc with its defaults.
struct PulledDesc : FlgPulledDesc {
    /// The defaults.
    PulledDesc() { flgPulledDescInit(this, detail::size_of<FlgPulledDesc>); }
    /// Of the C struct.
    PulledDesc(const FlgPulledDesc& c) : FlgPulledDesc(c) {}
    /// The defaults, with pull.
    PulledDesc(FlgPull pull_) {
        flgPulledDescInit(this, detail::size_of<FlgPulledDesc>);
        pull = pull_;
    }
    /// Sets handles and handle_count. The array must live until the descriptor is used.
    void set_handles(Span<const FlgPullHandle> values) {
        handles = values.data();
        handle_count = detail::count(values.size());
    }
    /// A list would end before the descriptor is used.
    void set_handles(std::initializer_list<FlgPullHandle>) = delete;
};

/// Positions of handles over time: a record of what somebody dragged, or keyframes.
struct PullKeys : FlgPullKeys {
    /// The defaults.
    PullKeys() { flgPullKeysInit(this, detail::size_of<FlgPullKeys>); }
    /// Of the C struct.
    PullKeys(const FlgPullKeys& c) : FlgPullKeys(c) {}
    /// Sets offsets and handle_count. The array must live until the descriptor is used.
    void set_offsets(Span<const uint32_t> values) {
        offsets = values.data();
        handle_count = detail::count(values.empty() ? 0 : values.size() - 1);
    }
    /// A list would end before the descriptor is used.
    void set_offsets(std::initializer_list<uint32_t>) = delete;
};

/// What to draw, and how.
struct DebugDrawDesc : FlgDebugDrawDesc {
    /// The defaults.
    DebugDrawDesc() { flgDebugDrawDescInit(this, detail::size_of<FlgDebugDrawDesc>); }
    /// Of the C struct.
    DebugDrawDesc(const FlgDebugDrawDesc& c) : FlgDebugDrawDesc(c) {}
};

/// A drawing. The host owns the arrays; an array that is null is counted, but not written.
struct DebugDrawing : FlgDebugDrawing {
    /// The defaults.
    DebugDrawing() { flgDebugDrawingInit(this, detail::size_of<FlgDebugDrawing>); }
    /// Of the C struct.
    DebugDrawing(const FlgDebugDrawing& c) : FlgDebugDrawing(c) {}
};

/// A running or finished piece of work.
class Job : public detail::Owner<FlgJob, flgJobRelease> {
public:
    using Owner::Owner;

    /// The job's state as of the last flgContextTick, but for what it waits for. Cost: tens of nanoseconds, and a
    /// nanosecond for each job that it waited for.
    /// Calls flgJobGetStatus.
    Result<JobStatus> status() const {
        FlgJobStatus out_status;
        flgJobStatusInit(&out_status, detail::size_of<FlgJobStatus>);
        const FlgResult result = flgJobGetStatus(context_, handle_, &out_status);
        return detail::made(result, out_status);
    }

    /// The stages of a finished job in order; FLG_NOT_READY before it finishes. Writes at most `capacity` stages and
    /// sets `out_count` to their total (at most 16). `out_stages` may be null when capacity is 0. Cost: tens of
    /// nanoseconds.
    /// Calls flgJobGetStages.
    Result<std::size_t> stages(Span<FlgStageTime> values) const {
        uint32_t count{};
        const FlgResult result = flgJobGetStages(context_, handle_, values.data(), detail::count(values.size()),
            &count);
        return detail::made(result, std::size_t{count});
    }
    /// All of them, by two calls of flgJobGetStages; empty if not ready.
    Result<std::vector<FlgStageTime>> stages() const {
        uint32_t count{};
        FlgResult result = flgJobGetStages(context_, handle_, nullptr, 0, &count);
        std::vector<FlgStageTime> values(result == FLG_OK ? count : 0);
        if (!values.empty()) {
            result = flgJobGetStages(context_, handle_, values.data(), count, &count);
        }
        return detail::made(result, std::move(values));
    }

    /// Requests cancellation. A later flgContextTick publishes the job with FLG_ERROR_CANCELLED, or with its result if
    /// it had already finished or begun to cut a surface, which completes; a tangle's step is taken back. Its memory is
    /// freed; jobs that depend on it fail. Cancelling a finished job does nothing. Cost: tens of nanoseconds.
    /// Calls flgJobCancel.
    Result<bool> cancel() const {
        const FlgResult result = flgJobCancel(context_, handle_);
        return detail::done(result);
    }

    /// Whether it is published, with whatever result.
    Result<bool> finished() const {
        FlgJobStatus status;
        flgJobStatusInit(&status, detail::size_of<FlgJobStatus>);
        const FlgResult result = flgJobGetStatus(context_, handle_, &status);
        return detail::made(result, status.state == FLG_JOB_STATE_FINISHED);
    }
};

/// Curves in flat arrays; never changes once ready.
class CurveSet : public detail::Owner<FlgCurveSet, flgCurveSetRelease> {
public:
    using Owner::Owner;

    /// The set's arrays. They neither move nor change until the set is released, even while jobs read it. FLG_NOT_READY
    /// while the job that makes the set is unpublished; with partial_results, shows the leading curves complete at the
    /// last flgContextTick instead. Returns the job's error if it failed. Cost: tens of nanoseconds.
    /// Calls flgCurveSetGetView.
    Result<CurveSetView> view() const {
        FlgCurveSetView out_view;
        flgCurveSetViewInit(&out_view, detail::size_of<FlgCurveSetView>);
        const FlgResult result = flgCurveSetGetView(context_, handle_, &out_view);
        return detail::made(result, CurveSetView(out_view));
    }

    /// Starts a job that redistributes points evenly by arc length along a smooth curve through the given points and
    /// carries a moving frame along. The curve is a G1 cubic that keeps straight runs straight, circles round to fourth
    /// order, and turns of more than 50 degrees as corners. Other columns are interpolated linearly; orientations are
    /// normalized. Consecutive repeated points count once. A zero-length curve becomes one point. Cost: about 50 ns a
    /// point.
    /// Calls flgCurveSetResample.
    Result<CurveSet> resample(CurveSetResampleDesc desc = {}, Job* out_job = nullptr) const {
        desc.curves = handle_;
        FlgCurveSet out_set{};
        FlgJob job_made{};
        const FlgResult result = flgCurveSetResample(context_, &desc, &out_set, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, CurveSet(context_, out_set));
    }

    /// Starts a job that keeps the points that curves need, with all their columns: levels of detail as ranges of one
    /// result. With n curves, curve c at level l is curve l * n + c of the result: one vertex buffer holds all levels,
    /// and a level is a range of it. Ends stay, at least every 1024th point, and three points of closed curves. Cost:
    /// about 50 ns a point and level; up to 10 us where few points can be left out of wild curves.
    /// Calls flgCurveSetSimplify.
    Result<CurveSet> simplify(CurveSetSimplifyDesc desc = {}, Job* out_job = nullptr) const {
        desc.curves = handle_;
        FlgCurveSet out_set{};
        FlgJob job_made{};
        const FlgResult result = flgCurveSetSimplify(context_, &desc, &out_set, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, CurveSet(context_, out_set));
    }

    /// The scale of each curve that flgCurveSetStylize has made: the one given, or the one chosen for scale 0. Times
    /// FlgStyleInfo::displacement_rms it is how far the style swings, metres; 0.14 of that is a good radius for curves
    /// that have none. FLG_NOT_READY until the result is published, its job's error if that failed. Cost: tens of
    /// nanoseconds.
    /// Calls flgCurveSetGetScales.
    Result<CurveSetScales> scales() const {
        FlgCurveSetScales out_scales;
        flgCurveSetScalesInit(&out_scales, detail::size_of<FlgCurveSetScales>);
        const FlgResult result = flgCurveSetGetScales(context_, handle_, &out_scales);
        return detail::made(result, CurveSetScales(out_scales));
    }

    /// Starts a job that writes the columns of curves. Cost: that of flgColumnsWrite.
    /// Calls flgCurveSetWrite.
    Result<Job> write(const BufferOutput& output, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgCurveSetWrite(context_, handle_, &output, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgCurveSetView shown;
        flgCurveSetViewInit(&shown, detail::size_of<FlgCurveSetView>);
        return detail::done(flgCurveSetGetView(context_, handle_, &shown));
    }
};

/// A prepared style: guide, displacement and patch graph. Never changes once ready.
class Style : public detail::Owner<FlgStyle, flgStyleRelease> {
public:
    using Owner::Owner;

    /// FLG_NOT_READY until the style is prepared; its job's error if that failed. Cost: tens of nanoseconds.
    /// Calls flgStyleGetInfo.
    Result<StyleInfo> info() const {
        FlgStyleInfo out_info;
        flgStyleInfoInit(&out_info, detail::size_of<FlgStyleInfo>);
        const FlgResult result = flgStyleGetInfo(context_, handle_, &out_info);
        return detail::made(result, StyleInfo(out_info));
    }

    /// The guide as a curve set with as many curves as the style and with TANGENT and NORMAL columns, relative to the
    /// example's origin (of a loaded style 0). The caller releases it. Cost: one copy.
    /// Calls flgStyleGetGuide.
    Result<CurveSet> guide() const {
        FlgCurveSet out_guide{};
        const FlgResult result = flgStyleGetGuide(context_, handle_, &out_guide);
        return detail::made(result, CurveSet(context_, out_guide));
    }

    /// Serializes the prepared style for a file or an asset; the same style gives the same bytes. Writes their number
    /// to `out_size`, and the bytes unless `out_data` is null. FLG_ERROR_LIMIT if `capacity` is too small.
    /// FLG_NOT_READY until the style is prepared. Cost: about a millisecond a megabyte; a style has 150 to 250 bytes a
    /// point.
    /// Calls flgStyleGetData.
    Result<std::size_t> data(Span<uint8_t> values) const {
        size_t count{};
        const FlgResult result = flgStyleGetData(context_, handle_, values.data(), values.size(), &count);
        return detail::made(result, std::size_t{count});
    }
    /// All of them, by two calls of flgStyleGetData; empty if not ready.
    Result<std::vector<uint8_t>> data() const {
        std::size_t count{};
        FlgResult result = flgStyleGetData(context_, handle_, nullptr, 0, &count);
        std::vector<uint8_t> values(result == FLG_OK ? count : 0);
        if (!values.empty()) {
            result = flgStyleGetData(context_, handle_, values.data(), count, &count);
        }
        return detail::made(result, std::move(values));
    }

    /// Starts a job that computes all path trees of a style at a temperature. Live strokes need them and never compute
    /// one. The style keeps those of the last four temperatures requested, including by flgCurveSetStylize and
    /// flgLiveStrokeBegin. `temperature` as in FlgCurveSetStylizeDesc; `job` may be null: defaults. Cost: 0.1 ms of
    /// work for each of up to 256 trees.
    /// Calls flgStyleWarm.
    Result<Job> warm(float temperature = 0.0f, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgStyleWarm(context_, handle_, temperature, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Whether info() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgStyleInfo shown;
        flgStyleInfoInit(&shown, detail::size_of<FlgStyleInfo>);
        return detail::done(flgStyleGetInfo(context_, handle_, &shown));
    }
};

/// Curves on a surface, straight in each triangle. Never change once ready.
class SurfaceCurves : public detail::Owner<FlgSurfaceCurves, flgSurfaceCurvesRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the curves are released. FLG_NOT_READY until their job is published, the job's error if it
    /// failed.
    /// Calls flgSurfaceCurvesGetView.
    Result<SurfaceCurvesView> view() const {
        FlgSurfaceCurvesView out_view;
        flgSurfaceCurvesViewInit(&out_view, detail::size_of<FlgSurfaceCurvesView>);
        const FlgResult result = flgSurfaceCurvesGetView(context_, handle_, &out_view);
        return detail::made(result, SurfaceCurvesView(out_view));
    }

    /// Starts a job that lifts surface curves into space, with POSITION and, from the surface's smooth normals, NORMAL:
    /// flgCurveSetStylize with FLG_FRAME_METHOD_SUPPLIED then decorates them in the surface's frame. Fails if there are
    /// no curves. Cost: about 25 ns a triangle of the surface, for its normals, and 0.1 us a point.
    /// Calls flgSurfaceCurvesLift.
    Result<CurveSet> lift(SurfaceCurvesLiftDesc desc = {}, Job* out_job = nullptr) const {
        desc.curves = handle_;
        FlgCurveSet out_set{};
        FlgJob job_made{};
        const FlgResult result = flgSurfaceCurvesLift(context_, &desc, &out_set, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, CurveSet(context_, out_set));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgSurfaceCurvesView shown;
        flgSurfaceCurvesViewInit(&shown, detail::size_of<FlgSurfaceCurvesView>);
        return detail::done(flgSurfaceCurvesGetView(context_, handle_, &shown));
    }
};

/// One value per vertex of a surface. Never changes once ready.
class Field : public detail::Owner<FlgField, flgFieldRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the field is released. FLG_NOT_READY until its job is published, the job's error if it
    /// failed.
    /// Calls flgFieldGetView.
    Result<FieldView> view() const {
        FlgFieldView out_view;
        flgFieldViewInit(&out_view, detail::size_of<FlgFieldView>);
        const FlgResult result = flgFieldGetView(context_, handle_, &out_view);
        return detail::made(result, FieldView(out_view));
    }

    /// Starts a job that traces isolines: closed ones, and open ones from border to border. Higher values lie to their
    /// left. Open isolines come first, then closed ones, each kind ordered by the triangle it begins in; curve_values
    /// are their levels. Cost: about 9 ns a triangle and 0.2 us a point.
    /// Calls flgFieldTraceIsolines.
    Result<SurfaceCurves> trace_isolines(FieldTraceIsolinesDesc desc = {}, Job* out_job = nullptr) const {
        desc.field = handle_;
        FlgSurfaceCurves out_curves{};
        FlgJob job_made{};
        const FlgResult result = flgFieldTraceIsolines(context_, &desc, &out_curves, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, SurfaceCurves(context_, out_curves));
    }

    /// Starts a job that traces integral curves of a field's gradient. The field rises (falls) strictly along them.
    /// Each ends at the border, at `end_value` or at an extremum of the field. A start outside the regions gives no
    /// curve. Cost: about 0.25 us a point.
    /// Calls flgFieldTraceStreams.
    Result<SurfaceCurves> trace_streams(FieldTraceStreamsDesc desc = {}, Job* out_job = nullptr) const {
        desc.field = handle_;
        FlgSurfaceCurves out_curves{};
        FlgJob job_made{};
        const FlgResult result = flgFieldTraceStreams(context_, &desc, &out_curves, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, SurfaceCurves(context_, out_curves));
    }

    /// Starts a job that writes a field's columns: VALUE and, if it has labels, LABEL; FLG_NO_INDEX becomes the largest
    /// number of a narrow format. Cost: that of flgColumnsWrite.
    /// Calls flgFieldWrite.
    Result<Job> write(const BufferOutput& output, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgFieldWrite(context_, handle_, &output, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgFieldView shown;
        flgFieldViewInit(&shown, detail::size_of<FlgFieldView>);
        return detail::done(flgFieldGetView(context_, handle_, &shown));
    }
};

/// A mesh with its adjacency and data for geodesics. Cutting changes it.
class Surface : public detail::Owner<FlgSurface, flgSurfaceRelease> {
public:
    using Owner::Owner;

    /// The report of the job that made the surface; FLG_NOT_READY until it is published, the job's error if it failed.
    /// Cuts do not change it. Cost: tens of nanoseconds.
    /// Calls flgSurfaceGetReport.
    Result<SurfaceReport> report() const {
        FlgSurfaceReport out_report;
        flgSurfaceReportInit(&out_report, detail::size_of<FlgSurfaceReport>);
        const FlgResult result = flgSurfaceGetReport(context_, handle_, &out_report);
        return detail::made(result, SurfaceReport(out_report));
    }

    /// The surface's arrays, readable until a job that changes the surface is started. FLG_NOT_READY until such a job,
    /// or the one that makes the surface, is published. Cost: tens of nanoseconds.
    /// Calls flgSurfaceGetView.
    Result<SurfaceView> view() const {
        FlgSurfaceView out_view;
        flgSurfaceViewInit(&out_view, detail::size_of<FlgSurfaceView>);
        const FlgResult result = flgSurfaceGetView(context_, handle_, &out_view);
        return detail::made(result, SurfaceView(out_view));
    }

    /// The arrays, readable as those of flgSurfaceGetView. FLG_ERROR_INVALID_ARGUMENT without
    /// FlgSurfaceDesc.provenance; a refined surface has it from the one it was refined from. After Loop's scheme a
    /// vertex lies where it would lie had its edge been split halfway. Cost: tens of nanoseconds.
    /// Calls flgSurfaceGetProvenance.
    Result<SurfaceProvenanceView> provenance() const {
        FlgSurfaceProvenanceView out_view;
        flgSurfaceProvenanceViewInit(&out_view, detail::size_of<FlgSurfaceProvenanceView>);
        const FlgResult result = flgSurfaceGetProvenance(context_, handle_, &out_view);
        return detail::made(result, SurfaceProvenanceView(out_view));
    }

    /// Triangles that are new, have moved or have other vertices since an earlier revision (0: its creation): those to
    /// upload again or to update in a picking scene. Regions may have changed anywhere. Writes at most `capacity`
    /// indices, each once, ascending, and their total number; `out_triangles` may be null when capacity is 0.
    /// FLG_NOT_READY while the view is not ready. Cost: about 0.5 ns a triangle of the surface.
    /// Calls flgSurfaceGetChanges.
    Result<std::size_t> changes(uint32_t since_revision, Span<uint32_t> values) const {
        uint32_t count{};
        const FlgResult result = flgSurfaceGetChanges(context_, handle_, since_revision, values.data(),
            detail::count(values.size()), &count);
        return detail::made(result, std::size_t{count});
    }
    /// All of them, by two calls of flgSurfaceGetChanges; empty if not ready.
    Result<std::vector<uint32_t>> changes(uint32_t since_revision) const {
        uint32_t count{};
        FlgResult result = flgSurfaceGetChanges(context_, handle_, since_revision, nullptr, 0, &count);
        std::vector<uint32_t> values(result == FLG_OK ? count : 0);
        if (!values.empty()) {
            result = flgSurfaceGetChanges(context_, handle_, since_revision, values.data(), count, &count);
        }
        return detail::made(result, std::move(values));
    }

    /// Starts a job that makes a finer surface: splits each triangle into four, `levels` times, and keeps regions and
    /// columns. Fails with FLG_ERROR_LIMIT above 2^30 triangles. Vertices keep their indices; new ones follow. Cost:
    /// about 0.12 us a triangle that is made.
    /// Calls flgSurfaceRefine.
    Result<Surface> refine(SurfaceRefineDesc desc = {}, Job* out_job = nullptr) const {
        desc.surface = handle_;
        FlgSurface out_surface{};
        FlgJob job_made{};
        const FlgResult result = flgSurfaceRefine(context_, &desc, &out_surface, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, Surface(context_, out_surface));
    }

    /// Starts a job that spreads points over the surface, each as far as possible from those before it: Poisson-disk
    /// samples in the geodesic metric (sec. 4.2), at vertices. (Above 16,384 vertices, most are chosen by distance in
    /// space.) The field: distances to the nearest sample; labels: its cell. Cost: some 3 to 4 fields for 130 points.
    /// Calls flgSurfaceSample.
    Result<Field> sample(SurfaceSampleDesc desc = {}, Job* out_job = nullptr) const {
        desc.surface = handle_;
        FlgField out_field{};
        FlgJob job_made{};
        const FlgResult result = flgSurfaceSample(context_, &desc, &out_field, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, Field(context_, out_field));
    }

    /// Starts a job that places points evenly along the borders of a region: one closed curve per border. Such a curve
    /// is not straight in triangles between its points and cannot be cut in. Cost: about 8 ns a triangle.
    /// Calls flgSurfaceSampleBorders.
    Result<SurfaceCurves> sample_borders(SurfaceSampleBordersDesc desc = {}, Job* out_job = nullptr) const {
        desc.surface = handle_;
        FlgSurfaceCurves out_curves{};
        FlgJob job_made{};
        const FlgResult result = flgSurfaceSampleBorders(context_, &desc, &out_curves, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, SurfaceCurves(context_, out_curves));
    }

    /// Starts a job that writes columns, indices and regions of a surface, as it is after the changes that were started
    /// before. Later changes wait for the job. Cost: that of flgColumnsWrite and flgIndicesWrite.
    /// Calls flgSurfaceWrite.
    Result<Job> write(const BufferOutput& output, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgSurfaceWrite(context_, handle_, &output, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgSurfaceView shown;
        flgSurfaceViewInit(&shown, detail::size_of<FlgSurfaceView>);
        return detail::done(flgSurfaceGetView(context_, handle_, &shown));
    }
};

/// A surface, the tree of its regions, and the steps that made them.
class Tangle : public detail::Owner<FlgTangle, flgTangleRelease> {
public:
    using Owner::Owner;

    /// Starts a job that divides regions by an operator. If it leaves them whole (delta beyond the field, no room for
    /// samples, a line that does not separate), the step changes nothing. What it cuts off a region that is smaller
    /// than a millionth of the surface stays with the part beside it. Fails if a region does not exist, if requested
    /// borders do not exist, if streams have no line to start on, or above FLG_REGION_MAX regions. Cost: a field (40 ns
    /// a triangle of the regions; with b two, with samples two more), and the cut (flgSurfaceCutIsolines). On 2 million
    /// triangles a region of 10,000 takes some 10 ms where many edges are flipped.
    /// Calls flgTangleDivide.
    Result<Job> divide(TangleDivideDesc desc = {}) const {
        desc.tangle = handle_;
        FlgJob out_job{};
        const FlgResult result = flgTangleDivide(context_, &desc, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that applies a macro as one step, undone as a whole. Parts are grouped as by
    /// FLG_TANGLE_GROUPING_TWO. Fails as its operators do; sunbursts and grids also fail if the regions together have
    /// fewer than two borders. Cost: its operators'.
    /// Calls flgTangleApplyMacro.
    Result<Job> apply_macro(TangleApplyMacroDesc desc = {}) const {
        desc.tangle = handle_;
        FlgJob out_job{};
        const FlgResult result = flgTangleApplyMacro(context_, &desc, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that displaces regions, as a step. Fails if they have no borders. Cost: a field and about 1 us a
    /// vertex that moves.
    /// Calls flgTangleDisplace.
    Result<Job> displace(TangleDisplaceDesc desc = {}) const {
        desc.tangle = handle_;
        FlgJob out_job{};
        const FlgResult result = flgTangleDisplace(context_, &desc, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that puts these regions into one new group, sec. 3.4 and appendix A, as a step. Regions may be
    /// leaves or not; fails if one does not exist. Cost: tens of nanoseconds a region.
    /// Calls flgTangleGroup.
    Result<Job> group(Span<const uint32_t> regions, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleGroup(context_, handle_, regions.data(), detail::count(regions.size()), job,
            &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that gives each region of the group its own new group, as a step. Fails if there is no such group.
    /// Cost: tens of nanoseconds a region of the tangle.
    /// Calls flgTangleUngroup.
    Result<Job> ungroup(uint32_t group, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleUngroup(context_, handle_, group, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that joins the leaves of these regions into one region, with their lowest identifier, as a step.
    /// Fails if they are not connected. Cost: about 20 ns a triangle of the surface.
    /// Calls flgTangleJoin.
    Result<Job> join(Span<const uint32_t> regions, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleJoin(context_, handle_, regions.data(), detail::count(regions.size()), job,
            &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that returns the visible borders as curves on the surface, chains of its edges. Lift them into
    /// space (flgSurfaceCurvesLift), stylize them, or draw them as ribbons and tubes. Open curves, from junction to
    /// junction, come first, then closed ones; curve_values are lengths. There are none if all looks are the same.
    /// Cost: about 30 ns a triangle.
    /// Calls flgTangleTraceBorders.
    Result<SurfaceCurves> trace_borders(const FlgJobOptions* job = nullptr, Job* out_job = nullptr) const {
        FlgSurfaceCurves out_curves{};
        FlgJob job_made{};
        const FlgResult result = flgTangleTraceBorders(context_, handle_, job, &out_curves,
            out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, SurfaceCurves(context_, out_curves));
    }

    /// Starts a job that undoes the last step, or the last edit of the history if that came later; fails if there is
    /// neither. (A failed job makes no step.) Cost: that of what the step changed; of an edit, that of the steps it
    /// computed or put elsewhere, before and after.
    /// Calls flgTangleUndo.
    Result<Job> undo(const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleUndo(context_, handle_, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that redoes the last undone step or edit. A new step or edit discards what was undone. Cost: that
    /// of what the step changes.
    /// Calls flgTangleRedo.
    Result<Job> redo(const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleRedo(context_, handle_, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// The arrays live until a job that changes the tangle is started, the function is called again for it, or the
    /// tangle is released. FLG_NOT_READY while the info is not ready. Cost: about 1 us a step and some ns a point.
    /// Calls flgTangleGetHistory.
    Result<TangleHistory> history() const {
        FlgTangleHistory out_history;
        flgTangleHistoryInit(&out_history, detail::size_of<FlgTangleHistory>);
        const FlgResult result = flgTangleGetHistory(context_, handle_, &out_history);
        return detail::made(result, TangleHistory(out_history));
    }

    /// Starts a job that repeats all steps of a history on a tangle without steps, then undoes those that were undone;
    /// the steps become the tangle's own. On the same mesh, to the bit, this restores the original tangle, to the bit.
    /// On another mesh of that shape, such as a finer one, it locates points, samples, lines, borders and regions by
    /// their positions, each snapped to the surface. This call copies everything. Fails, and changes nothing, if the
    /// tangle has steps, if a step fails (the message names it), or if the meshes' boxes differ by more than 1/20 of
    /// their diagonal. Also refuses whatever flgTangleDivide and the other functions would refuse. Cost: that of the
    /// steps; on another mesh also about 0.2 us a triangle for each step that has points or made regions.
    /// Calls flgTangleReplay.
    Result<Job> replay(const FlgTangleHistory& history, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleReplay(context_, handle_, &history, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that replaces the arguments of a step. `desc` is read as flgTangleReplay reads a step of a history,
    /// so one from flgTangleGetHistory with other numbers will do; its regions are those before the step. The array is
    /// copied. Points are on the surface as it was then: where that is not known, set `placed` and give positions. A
    /// muted step stays muted. Fails if the step cannot be made. Cost: as above.
    /// Calls flgTangleEditStep.
    Result<Job> edit_step(uint32_t step, const TangleStep& desc, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleEditStep(context_, handle_, step, &desc, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Likewise for a new step, which gets the index `step`: at most the number of steps that are not undone. Cost: as
    /// above.
    /// Calls flgTangleInsertStep.
    Result<Job> insert_step(uint32_t step, const TangleStep& desc, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleInsertStep(context_, handle_, step, &desc, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that moves a step to another index, which it has afterwards. Before the step that makes its regions
    /// it is lost. Cost: as above.
    /// Calls flgTangleMoveStep.
    Result<Job> move_step(uint32_t step, uint32_t to, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleMoveStep(context_, handle_, step, to, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that removes a step. Cost: as above.
    /// Calls flgTangleRemoveStep.
    Result<Job> remove_step(uint32_t step, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleRemoveStep(context_, handle_, step, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Starts a job that mutes a step (`muted` nonzero), so that it does nothing, or makes it again (0). Cost: as
    /// above.
    /// Calls flgTangleMuteStep.
    Result<Job> mute_step(uint32_t step, uint32_t muted, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgTangleMuteStep(context_, handle_, step, muted, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// FLG_NOT_READY until a job that changes the tangle is published; the surface's error if that failed. Cost: tens
    /// of nanoseconds a region.
    /// Calls flgTangleGetInfo.
    Result<TangleInfo> info() const {
        FlgTangleInfo out_info;
        flgTangleInfoInit(&out_info, detail::size_of<FlgTangleInfo>);
        const FlgResult result = flgTangleGetInfo(context_, handle_, &out_info);
        return detail::made(result, out_info);
    }

    /// FLG_NOT_READY while the info is not ready. Cost: tens of nanoseconds.
    /// Calls flgTangleGetRegion.
    Result<TangleRegion> region(uint32_t region) const {
        FlgTangleRegion out_region;
        flgTangleRegionInit(&out_region, detail::size_of<FlgTangleRegion>);
        const FlgResult result = flgTangleGetRegion(context_, handle_, region, &out_region);
        return detail::made(result, out_region);
    }

    /// Starts a job that draws maps of a tangle as it is after the changes that were started before; later changes wait
    /// for the job. It writes the maps and, for the padding, reads them back, on a worker or inside flgContextTick:
    /// they must live until it is published, and must not overlap. A job that fails or is cancelled may have written a
    /// part. Fails with FLG_ERROR_INVALID_ARGUMENT if a texture coordinate is not finite or outside 0 to 1, if
    /// triangles overlap, if none covers a texel, or if `mesh` is not what the surface was made of. Cost: about 60 ns a
    /// texel that is covered, and 0.5 us a triangle of the surface.
    /// Calls flgTangleBake.
    Result<Job> bake(TangleBakeDesc desc = {}) const {
        desc.tangle = handle_;
        FlgJob out_job{};
        const FlgResult result = flgTangleBake(context_, &desc, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Whether info() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgTangleInfo shown;
        flgTangleInfoInit(&shown, detail::size_of<FlgTangleInfo>);
        return detail::done(flgTangleGetInfo(context_, handle_, &shown));
    }
};

/// The straight skeleton of a contour. Never changes once ready.
class StraightSkeleton : public detail::Owner<FlgStraightSkeleton, flgStraightSkeletonRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the skeleton is released. FLG_NOT_READY until its job is published, the job's error if it
    /// failed.
    /// Calls flgStraightSkeletonGetView.
    Result<StraightSkeletonView> view() const {
        FlgStraightSkeletonView out_view;
        flgStraightSkeletonViewInit(&out_view, detail::size_of<FlgStraightSkeletonView>);
        const FlgResult result = flgStraightSkeletonGetView(context_, handle_, &out_view);
        return detail::made(result, StraightSkeletonView(out_view));
    }

    /// The contour moved inwards by a distance, with sharp corners. Rings have their inside on the left; each starts at
    /// the side of its lowest-numbered edge, and rings are ordered by these edges. 0 gives the contour; beyond the last
    /// node's time nothing is left. Writes the counts, and the arrays if everything fits: call it without arrays to
    /// query the size. FLG_NOT_READY until the skeleton's job is published, its error if it failed;
    /// FLG_ERROR_INVALID_ARGUMENT for a distance below 0 or not finite. Cost: about 50 ns a point of the contour, each
    /// time.
    /// Calls flgStraightSkeletonOffset.
    Result<bool> offset(double distance, FlgOffsetPolygons& polygons) const {
        const FlgResult result = flgStraightSkeletonOffset(context_, handle_, distance, &polygons);
        return detail::done(result);
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgStraightSkeletonView shown;
        flgStraightSkeletonViewInit(&shown, detail::size_of<FlgStraightSkeletonView>);
        return detail::done(flgStraightSkeletonGetView(context_, handle_, &shown));
    }

    /// A front: what is inside lies to the left of each ring.
    struct Rings {
        std::vector<double> points;     ///< 2 per point
        std::vector<uint32_t> edges;    ///< one per point: the edge that made the side from it to the next
        std::vector<uint32_t> offsets;  ///< where each ring begins, and the end; empty until ready
    };
    /// The front in arrays of its own, by the same function.
    Result<Rings> offset(double distance) const {
        FlgOffsetPolygons polygons;
        flgOffsetPolygonsInit(&polygons, detail::size_of<FlgOffsetPolygons>);
        Rings rings;
        FlgResult result = flgStraightSkeletonOffset(context_, handle_, distance, &polygons);
        if (result != FLG_OK) return detail::made(result, std::move(rings));
        rings.points.resize(2 * std::size_t{polygons.point_count});
        rings.edges.resize(polygons.point_count);
        rings.offsets.resize(std::size_t{polygons.ring_count} + 1);
        polygons.point_capacity = polygons.point_count;
        polygons.ring_capacity = polygons.ring_count;
        polygons.points = rings.points.data();
        polygons.edges = rings.edges.data();
        polygons.ring_offsets = rings.offsets.data();
        result = flgStraightSkeletonOffset(context_, handle_, distance, &polygons);
        return detail::made(result, std::move(rings));
    }
};

/// A surface's silhouette from afar, as a contour. Never changes once ready.
class Outline : public detail::Owner<FlgOutline, flgOutlineRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the outline is released. FLG_NOT_READY until its job is published, the job's error if it
    /// failed.
    /// Calls flgOutlineGetView.
    Result<OutlineView> view() const {
        FlgOutlineView out_view;
        flgOutlineViewInit(&out_view, detail::size_of<FlgOutlineView>);
        const FlgResult result = flgOutlineGetView(context_, handle_, &out_view);
        return detail::made(result, OutlineView(out_view));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgOutlineView shown;
        flgOutlineViewInit(&shown, detail::size_of<FlgOutlineView>);
        return detail::done(flgOutlineGetView(context_, handle_, &shown));
    }
};

/// A drawn contour with its axis. Never changes once ready.
class Part : public detail::Owner<FlgPart, flgPartRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the part is released. FLG_NOT_READY until its job is published, the job's error if it
    /// failed.
    /// Calls flgPartGetView.
    Result<PartView> view() const {
        FlgPartView out_view;
        flgPartViewInit(&out_view, detail::size_of<FlgPartView>);
        const FlgResult result = flgPartGetView(context_, handle_, &out_view);
        return detail::made(result, PartView(out_view));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgPartView shown;
        flgPartViewInit(&shown, detail::size_of<FlgPartView>);
        return detail::done(flgPartGetView(context_, handle_, &shown));
    }
};

/// A part's own inflated surface. Never changes once ready.
class PartMesh : public detail::Owner<FlgPartMesh, flgPartMeshRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the mesh is released. FLG_NOT_READY until its job is published, the job's error if it
    /// failed.
    /// Calls flgPartMeshGetView.
    Result<PartMeshView> view() const {
        FlgPartMeshView out_view;
        flgPartMeshViewInit(&out_view, detail::size_of<FlgPartMeshView>);
        const FlgResult result = flgPartMeshGetView(context_, handle_, &out_view);
        return detail::made(result, PartMeshView(out_view));
    }

    /// Starts a job that writes indices and column POSITION of a part's body. Cost: that of flgColumnsWrite and
    /// flgIndicesWrite.
    /// Calls flgPartMeshWrite.
    Result<Job> write(const BufferOutput& output, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgPartMeshWrite(context_, handle_, &output, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgPartMeshView shown;
        flgPartMeshViewInit(&shown, detail::size_of<FlgPartMeshView>);
        return detail::done(flgPartMeshGetView(context_, handle_, &shown));
    }
};

/// Parts in their places and one tree of joints. Never changes once ready.
class Model : public detail::Owner<FlgModel, flgModelRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the model is released. FLG_NOT_READY until its job is published, the job's error if it
    /// failed.
    /// Calls flgModelGetView.
    Result<ModelView> view() const {
        FlgModelView out_view;
        flgModelViewInit(&out_view, detail::size_of<FlgModelView>);
        const FlgResult result = flgModelGetView(context_, handle_, &out_view);
        return detail::made(result, ModelView(out_view));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgModelView shown;
        flgModelViewInit(&shown, detail::size_of<FlgModelView>);
        return detail::done(flgModelGetView(context_, handle_, &shown));
    }
};

/// A model's surface, bound to its joints. Never changes once ready.
class Skin : public detail::Owner<FlgSkin, flgSkinRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the skin is released. FLG_NOT_READY until its job is published, the job's error if it
    /// failed.
    /// Calls flgSkinGetView.
    Result<SkinView> view() const {
        FlgSkinView out_view;
        flgSkinViewInit(&out_view, detail::size_of<FlgSkinView>);
        const FlgResult result = flgSkinGetView(context_, handle_, &out_view);
        return detail::made(result, SkinView(out_view));
    }

    /// Starts a job that makes a level of detail: the same surface, parts and joints with fewer vertices. Edges are
    /// collapsed, those first that change the shape least; where weights change more stay. Borders of parts and sharp
    /// corners stay where they are, pieces and holes remain, and a vertex has the weights of its place on the surface.
    /// So few vertices may not be reachable: then the result has the fewest that are. With as many as the skin has, or
    /// more, it is a copy. Cost: about 2 us a vertex of the skin and 20 us for each that goes.
    /// Calls flgSkinSimplify.
    Result<Skin> simplify(SkinSimplifyDesc desc = {}, Job* out_job = nullptr) const {
        desc.skin = handle_;
        FlgSkin out_skin{};
        FlgJob job_made{};
        const FlgResult result = flgSkinSimplify(context_, &desc, &out_skin, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, Skin(context_, out_skin));
    }

    /// Starts a job that makes the same skin with other weights, as painted ones: all else is the source's, which stays
    /// as it is. Weights get the sum 1 and the largest first; a joint that a vertex has twice gets both weights.
    /// Weights out of range are refused at once; another vertex_count than the skin's, or a joint that it does not
    /// have, makes the job fail with FLG_ERROR_INVALID_ARGUMENT. Cost: 20 ns a vertex in the call, 0.1 us in the job.
    /// Calls flgSkinSetWeights.
    Result<Skin> set_weights(SkinSetWeightsDesc desc = {}, Job* out_job = nullptr) const {
        desc.skin = handle_;
        FlgSkin out_skin{};
        FlgJob job_made{};
        const FlgResult result = flgSkinSetWeights(context_, &desc, &out_skin, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, Skin(context_, out_skin));
    }

    /// Starts a job that writes a skin's indices and columns: POSITION, NORMAL, JOINTS, WEIGHTS and PART. As UNORM8 and
    /// UNORM16 the largest weight gets what makes the sum exactly 1. (flgSkinPose writes matrices into the host's
    /// memory anyway.) Cost: that of flgColumnsWrite and flgIndicesWrite.
    /// Calls flgSkinWrite.
    Result<Job> write(const BufferOutput& output, const FlgJobOptions* job = nullptr) const {
        FlgJob out_job{};
        const FlgResult result = flgSkinWrite(context_, handle_, &output, job, &out_job);
        return detail::made(result, Job(context_, out_job));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgSkinView shown;
        flgSkinViewInit(&shown, detail::size_of<FlgSkinView>);
        return detail::done(flgSkinGetView(context_, handle_, &shown));
    }
};

/// A stroke being drawn. Strokes are independent of each other.
class LiveStroke : public detail::Owner<FlgLiveStroke, flgLiveStrokeRelease> {
public:
    using Owner::Owner;

    /// [any thread, one per stroke] Adds samples; out_new (may be null) shows the points this call made. Checks all
    /// samples first: if one is invalid, none is added, and the stroke stays unchanged and can continue:
    ///   FLG_ERROR_INVALID_ARGUMENT  a number that is not finite or out of range, or a time before the previous
    ///                               sample's
    ///   FLG_ERROR_LIMIT             a jump beyond max_jump (end the stroke there and begin another), more than
    ///                               max_samples, or the stroke is cut at max_points (FlgLiveStrokeInfo::cut): it can
    ///                               still be ended, and samples undone
    /// Repeated samples are accepted but make no points; nor do samples closer than 0.001 of a step to the last
    /// distinct one, or, with smoothing, samples with the same time as the previous one. The view lives until the next
    /// call for this stroke, its arrays until the stroke is released; curve_count is 0 if there is nothing new. After
    /// flgLiveStrokeEnd: FLG_ERROR_INVALID_ARGUMENT. Cost: about 0.2 us a sample and 0.1 us a point.
    /// Calls flgLiveStrokePush.
    Result<CurveSetView> push(const LiveSampleView& samples) const {
        FlgCurveSetView out_new;
        flgCurveSetViewInit(&out_new, detail::size_of<FlgCurveSetView>);
        const FlgResult result = flgLiveStrokePush(context_, handle_, &samples, &out_new);
        return detail::made(result, CurveSetView(out_new));
    }

    /// [any thread, one per stroke] All points so far; lives as long as flgLiveStrokePush's view. Once the job of
    /// flgLiveStrokeEnd is published: the whole stroke. Cost: tens of nanoseconds.
    /// Calls flgLiveStrokeGetPoints.
    Result<CurveSetView> points() const {
        FlgCurveSetView out_view;
        flgCurveSetViewInit(&out_view, detail::size_of<FlgCurveSetView>);
        const FlgResult result = flgLiveStrokeGetPoints(context_, handle_, &out_view);
        return detail::made(result, CurveSetView(out_view));
    }

    /// [any thread, one per stroke] Where the stroke would be if it ended now, so that what is drawn is not a sample
    /// behind the hand: a curve of the last point so far, if there is one, and the points that flgLiveStrokeEnd would
    /// add, bit for bit. All columns of flgLiveStrokeGetPoints. curve_count is 0 if the end would add nothing. Draw it
    /// for a frame, then drop it: the next sample bends it, and these points never become part of the stroke. The call
    /// changes no other result. It looks ahead by at most 256 points, fewer only where samples wait (4 less for each
    /// sample read); beyond that the tip stops short of the hand. Allocates nothing. The view and its arrays live until
    /// the next call of this function for this stroke, or the stroke's release. Works after flgLiveStrokeEnd too, until
    /// its job is published: then there is no tip any more. Cost: about 0.5 us, and 30 ns a point.
    /// Calls flgLiveStrokeGetTip.
    Result<CurveSetView> tip() const {
        FlgCurveSetView out_tip;
        flgCurveSetViewInit(&out_tip, detail::size_of<FlgCurveSetView>);
        const FlgResult result = flgLiveStrokeGetTip(context_, handle_, &out_tip);
        return detail::made(result, CurveSetView(out_tip));
    }

    /// [any thread, one per stroke] The stroke's progress; set struct_size. Cost: tens of nanoseconds.
    /// Calls flgLiveStrokeGetInfo.
    Result<LiveStrokeInfo> info() const {
        FlgLiveStrokeInfo out_info;
        flgLiveStrokeInfoInit(&out_info, detail::size_of<FlgLiveStrokeInfo>);
        const FlgResult result = flgLiveStrokeGetInfo(context_, handle_, &out_info);
        return detail::made(result, out_info);
    }

    /// [any thread, one per stroke] Removes the last `count` samples and the points they made: restores the stroke as
    /// it was before they were pushed, to the bit. out_point_count (may be null): points left. Refused for an ended
    /// stroke: resume it first. Cost: that of pushing up to 5 samples.
    /// Calls flgLiveStrokeUndo.
    Result<uint32_t> undo(uint32_t count) const {
        uint32_t out_point_count{};
        const FlgResult result = flgLiveStrokeUndo(context_, handle_, count, &out_point_count);
        return detail::made(result, out_point_count);
    }

    /// What end() makes.
    struct EndResults {
        CurveSet stylized;  ///< out_stylized of flgLiveStrokeEnd
        CurveSet samples;  ///< out_samples of flgLiveStrokeEnd
    };
    /// Ends a stroke: starts a job that follows the curve to its last sample. The job copies the stylized points into
    /// one set and the samples into another (POSITION, ORIENTATION, PRESSURE, TIME since the first one, s, RADIUS).
    /// Both can be used as inputs at once: `out_samples` as the style of flgStyleCreate, or as the target of
    /// flgCurveSetStylize. The last point lies up to one step before the last sample. A zero-length stroke is one
    /// point, not displaced. Either set may be null if not needed. `job` may be null: FLG_PRIORITY_HIGH then, since
    /// somebody waits for it. The handle stays valid, for flgLiveStrokeResume, until it is released; if the job fails,
    /// the stroke continues as if it had not been ended. Refused for a stroke without samples. A stroke that reaches
    /// max_points is cut there, and the job succeeds with the points made so far; once the job is published,
    /// FlgLiveStrokeInfo::cut is set. `out_samples` has all samples, so the whole stroke can be stylized from it. Cost:
    /// about 6 ns a point.
    /// Calls flgLiveStrokeEnd.
    Result<EndResults> end(const FlgJobOptions* job = nullptr, Job* out_job = nullptr) const {
        FlgCurveSet out_stylized{};
        FlgCurveSet out_samples{};
        FlgJob job_made{};
        const FlgResult result = flgLiveStrokeEnd(context_, handle_, job, &out_stylized, &out_samples,
            out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, EndResults{CurveSet(context_, out_stylized), CurveSet(context_, out_samples)});
    }

    /// Resumes an ended stroke, as if it had never been ended: removes the points its end added without knowing the
    /// next sample. FLG_NOT_READY while a job still reads the stroke. Sets already made do not change. Cost: that of
    /// pushing up to 5 samples.
    /// Calls flgLiveStrokeResume.
    Result<bool> resume() const {
        const FlgResult result = flgLiveStrokeResume(context_, handle_);
        return detail::done(result);
    }

    /// What split() makes.
    struct SplitResults {
        CurveSet first;  ///< out_first of flgLiveStrokeSplit
        CurveSet second;  ///< out_second of flgLiveStrokeSplit
    };
    /// Starts a job that splits an ended stroke into two copies that meet: points 0 to `point`, and `point` to the
    /// last. `job` as for flgLiveStrokeEnd. FLG_NOT_READY until the job of flgLiveStrokeEnd is published. Cost: about
    /// 10 ns a point.
    /// Calls flgLiveStrokeSplit.
    Result<SplitResults> split(uint32_t point, const FlgJobOptions* job = nullptr, Job* out_job = nullptr) const {
        FlgCurveSet out_first{};
        FlgCurveSet out_second{};
        FlgJob job_made{};
        const FlgResult result = flgLiveStrokeSplit(context_, handle_, point, job, &out_first, &out_second,
            out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, SplitResults{CurveSet(context_, out_first), CurveSet(context_, out_second)});
    }
};

/// A surface of dimension k in R^n that curves stay on. Never changes once ready.
class Manifold : public detail::Owner<FlgManifold, flgManifoldRelease> {
public:
    using Owner::Owner;

    /// FLG_NOT_READY until the manifold's job is published, the job's error if it failed.
    /// Calls flgManifoldGetView.
    Result<ManifoldView> view() const {
        FlgManifoldView out_view;
        flgManifoldViewInit(&out_view, detail::size_of<FlgManifoldView>);
        const FlgResult result = flgManifoldGetView(context_, handle_, &out_view);
        return detail::made(result, out_view);
    }

    /// Projects up to 64 points, relative to the manifold's origin, onto it at once, such as a cursor's. out_distances
    /// (metres) may be null; a point that cannot be projected stays unchanged and gets HUGE_VAL. FLG_NOT_READY until
    /// the manifold's job is published. Cost: some us a point.
    /// Calls flgManifoldProject.
    Result<bool> project(double* points, uint32_t point_count, double* out_distances = nullptr) const {
        const FlgResult result = flgManifoldProject(context_, handle_, points, point_count, out_distances);
        return detail::done(result);
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgManifoldView shown;
        flgManifoldViewInit(&shown, detail::size_of<FlgManifoldView>);
        return detail::done(flgManifoldGetView(context_, handle_, &shown));
    }
};

/// A curve through points of a manifold. Never changes once ready.
class Spline : public detail::Owner<FlgSpline, flgSplineRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the spline is released; while it runs, until the next flgContextTick. FLG_NOT_READY until
    /// its job is published (with partial_results: until its first round), the job's error if it failed.
    /// Calls flgSplineGetView.
    Result<SplineView> view() const {
        FlgSplineView out_view;
        flgSplineViewInit(&out_view, detail::size_of<FlgSplineView>);
        const FlgResult result = flgSplineGetView(context_, handle_, &out_view);
        return detail::made(result, SplineView(out_view));
    }

    /// Starts a job that lays a spline onto the triangles of its mesh, as that is by then: a curve to cut along
    /// (flgSurfaceCutCurves) or to grow from. Its nodes go to the nearest points of triangles; from one to the next it
    /// follows the plane through both and the surface's normal and, where no such way leads there, a shortest path.
    /// Cost: about 2 us a node and 100 ns a triangle.
    /// Calls flgSplineTrace.
    Result<SurfaceCurves> trace(SplineTraceDesc desc = {}, Job* out_job = nullptr) const {
        desc.spline = handle_;
        FlgSurfaceCurves out_curves{};
        FlgJob job_made{};
        const FlgResult result = flgSplineTrace(context_, &desc, &out_curves, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, SurfaceCurves(context_, out_curves));
    }

    /// Starts a job that copies a spline into a curve set with POSITION, TIME (its parameter) and, on a surface in R^3,
    /// NORMAL. Stylize it in the surface's frame (FLG_FRAME_METHOD_SUPPLIED), draw it, project it, or cut along it.
    /// Cost: about 3 ns a node; with a spacing 300 ns a point.
    /// Calls flgSplineSample.
    Result<CurveSet> sample(SplineSampleDesc desc = {}, Job* out_job = nullptr) const {
        desc.spline = handle_;
        FlgCurveSet out_set{};
        FlgJob job_made{};
        const FlgResult result = flgSplineSample(context_, &desc, &out_set, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, CurveSet(context_, out_set));
    }

    /// Starts a job that makes a ribbon or road along a spline: a new surface with the spline's origin and columns
    /// POSITION, NORMAL, UV (u across from left to right, v along) and WIDTH (of the row, metres). On the inner side of
    /// a bend tighter than it is wide rows end before they would cross their neighbours, so WIDTH is less there. A
    /// closed ribbon's last row repeats the first, for the texture. Cost: about 0.5 us a vertex; 3 us a row that
    /// conforms. Fails with FLG_ERROR_LIMIT above 2^26 vertices or 2^20 rows.
    /// Calls flgSplineSweep.
    Result<Surface> sweep(SplineSweepDesc desc = {}, Job* out_job = nullptr) const {
        desc.spline = handle_;
        FlgSurface out_surface{};
        FlgJob job_made{};
        const FlgResult result = flgSplineSweep(context_, &desc, &out_surface, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, Surface(context_, out_surface));
    }

    /// Starts a job that makes the curve beside a spline, `left` and `above`: a curve set with the spline's origin and
    /// POSITION, TIME (the spline's parameter beside it) and NORMAL (upwards). On a surface, without an `up`, it lies
    /// on the surface, as the manifold has it, `above` it where asked for; where the surface ends before it is `left`
    /// metres away it lies at its end. Farther away than the radius of a bend it would run back in a loop: loops are
    /// cut off where the curve crosses itself (in space, half way between where its ends are nearest), which leaves a
    /// corner, and TIME jumps there. At corners of the spline its outer side is cut straight. Fails where nothing is
    /// left without loops, and with FLG_ERROR_LIMIT above 2^20 points. Cost: about 0.5 us a point; over a surface 3 us
    /// a point and each 256th of the surface's size.
    /// Calls flgSplineOffset.
    Result<CurveSet> offset(SplineOffsetDesc desc = {}, Job* out_job = nullptr) const {
        desc.spline = handle_;
        FlgCurveSet out_set{};
        FlgJob job_made{};
        const FlgResult result = flgSplineOffset(context_, &desc, &out_set, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(context_, job_made);
        return detail::made(result, CurveSet(context_, out_set));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgSplineView shown;
        flgSplineViewInit(&shown, detail::size_of<FlgSplineView>);
        return detail::done(flgSplineGetView(context_, handle_, &shown));
    }
};

/// Solids that curves in the plane or in space avoid. Never change once ready.
class Obstacles : public detail::Owner<FlgObstacles, flgObstaclesRelease> {
public:
    using Owner::Owner;
};

/// A motion of a rigid body. Never changes once ready.
class Motion : public detail::Owner<FlgMotion, flgMotionRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the motion is released; while it runs, until the next flgContextTick. FLG_NOT_READY until
    /// its job is published (with partial_results: until its first round), the job's error if it failed.
    /// Calls flgMotionGetView.
    Result<MotionView> view() const {
        FlgMotionView out_view;
        flgMotionViewInit(&out_view, detail::size_of<FlgMotionView>);
        const FlgResult result = flgMotionGetView(context_, handle_, &out_view);
        return detail::made(result, MotionView(out_view));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgMotionView shown;
        flgMotionViewInit(&shown, detail::size_of<FlgMotionView>);
        return detail::done(flgMotionGetView(context_, handle_, &shown));
    }
};

/// What pulling needs of a mesh. Never changes once ready.
class Pull : public detail::Owner<FlgPull, flgPullRelease> {
public:
    using Owner::Owner;
};

/// A mesh as handles pull it. Never changes once ready.
class Pulled : public detail::Owner<FlgPulled, flgPulledRelease> {
public:
    using Owner::Owner;

    /// The arrays live until the mesh is released. FLG_NOT_READY until its job is published, the job's error if it
    /// failed.
    /// Calls flgPulledGetView.
    Result<PulledView> view() const {
        FlgPulledView out_view;
        flgPulledViewInit(&out_view, detail::size_of<FlgPulledView>);
        const FlgResult result = flgPulledGetView(context_, handle_, &out_view);
        return detail::made(result, PulledView(out_view));
    }

    /// Whether view() has something to show. Fails as the job that makes it did.
    Result<bool> ready() const {
        FlgPulledView shown;
        flgPulledViewInit(&shown, detail::size_of<FlgPulledView>);
        return detail::done(flgPulledGetView(context_, handle_, &shown));
    }
};

/// Curves read from a file, with their memory.
class CurveFile : public detail::Object<FlgCurveFile, flgCurveFileRelease> {
public:
    using Object::Object;

    /// Reads all curves of a file. Reads the whole file, checks it, and refuses it at the first error; mere oddities
    /// become warnings (flgCurveFileGetInfo). `desc` may be null: all defaults. Limits: 2 GiB a file (unpacked too),
    /// 2^31 points. Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT, FLG_ERROR_OUT_OF_MEMORY. Cost: 0.1 to
    /// 0.2 us a point.
    /// Calls flgCurveFileRead.
    static Result<CurveFile> read(const char* path, const CurveFileReadDesc& desc = CurveFileReadDesc()) {
        FlgCurveFile out_file{};
        const FlgResult result = flgCurveFileRead(path, &desc, &out_file);
        return detail::made<flgIoErrorGetMessage>(result, CurveFile(out_file));
    }

    /// The curves, ready for flgCurveSetCreate; lives until the file is released.
    /// Calls flgCurveFileGetView.
    Result<CurveSetView> view() const {
        FlgCurveSetView out_view;
        flgCurveSetViewInit(&out_view, detail::size_of<FlgCurveSetView>);
        const FlgResult result = flgCurveFileGetView(handle_, &out_view);
        return detail::made<flgIoErrorGetMessage>(result, CurveSetView(out_view));
    }

    /// The file's contents and warnings. Set struct_size.
    /// Calls flgCurveFileGetInfo.
    Result<CurveFileInfo> info() const {
        FlgCurveFileInfo out_info;
        flgCurveFileInfoInit(&out_info, detail::size_of<FlgCurveFileInfo>);
        const FlgResult result = flgCurveFileGetInfo(handle_, &out_info);
        return detail::made<flgIoErrorGetMessage>(result, CurveFileInfo(out_info));
    }

    /// The stroke of a curve, 0 to the info's stroke_count - 1. Set struct_size.
    /// Calls flgCurveFileGetStroke.
    Result<Stroke> stroke(uint32_t curve) const {
        FlgStroke out_stroke;
        flgStrokeInit(&out_stroke, detail::size_of<FlgStroke>);
        const FlgResult result = flgCurveFileGetStroke(handle_, curve, &out_stroke);
        return detail::made<flgIoErrorGetMessage>(result, out_stroke);
    }

    /// Writes curves to .xyz, .obj or .glb, completely or not at all, also when the power goes: a temporary file beside
    /// it is flushed to the disk and renamed when complete (for an FlgFileSystem its `close` does so). The mode and
    /// owner of a file that it replaces stay. So do all functions that write files. `desc` may be null. Curves without
    /// a NORMAL column get frames by double reflection. Colours in .glb are clamped to 0 to 1; .glb cannot hold USER
    /// columns of more than 4 floats. Lines of one point are written with that point twice; ribbons and tubes omit
    /// zero-length curves. Errors: FLG_ERROR_INVALID_ARGUMENT (also for no curves at all), FLG_ERROR_FORMAT for another
    /// extension, FLG_ERROR_FILE, FLG_ERROR_LIMIT (.glb: 2 GiB). Text leaves while it is made, in parts of 64 KiB, and
    /// may be of any size; above 2 GiB it can't be read again. Cost: .glb 0.1 us a point, text 0.5 to 0.8.
    /// Calls flgCurveFileWrite.
    static Result<bool> write(const char* path, const FlgCurveSetView& view, const CurveFileWriteDesc& desc =
        CurveFileWriteDesc()) {
        const FlgResult result = flgCurveFileWrite(path, &view, &desc);
        return detail::done<flgIoErrorGetMessage>(result);
    }
};

/// A mesh read from a file, with its memory.
class MeshFile : public detail::Object<FlgMeshFile, flgMeshFileRelease> {
public:
    using Object::Object;

    /// Reads the mesh of a file as stored: nothing is welded, reversed or dropped, except triangles of strips and fans
    /// that use a vertex twice. Splits faces of more than three corners into triangles: convex ones as fans from their
    /// first corner, others of at most 1024 corners by ear clipping. Like flgCurveFileRead, refuses errors (indices out
    /// of range, faces of fewer than three corners, values that are not finite, counts too large for the file, no faces
    /// at all) and warns of oddities. Cost: one core, some 400 MB/s of binary and 250 MB/s of text (2 M triangles: 0.1
    /// s and 0.3 s). `desc` may be null: all defaults. Limits: 2 GiB a file, and 2 GiB for the result. Errors:
    /// FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT.
    /// Calls flgMeshFileRead.
    static Result<MeshFile> read(const char* path, const MeshFileReadDesc& desc = MeshFileReadDesc()) {
        FlgMeshFile out_file{};
        const FlgResult result = flgMeshFileRead(path, &desc, &out_file);
        return detail::made<flgIoErrorGetMessage>(result, MeshFile(out_file));
    }

    /// The mesh; lives until the file is released. `regions` is null if the file has none.
    /// Calls flgMeshFileGetView.
    Result<MeshView> view() const {
        FlgMeshView out_view;
        flgMeshViewInit(&out_view, detail::size_of<FlgMeshView>);
        const FlgResult result = flgMeshFileGetView(handle_, &out_view);
        return detail::made<flgIoErrorGetMessage>(result, MeshView(out_view));
    }

    /// An integer property of a .ply file's faces besides `region`, 0 to the info's face_column_count - 1. All
    /// triangles of a face have its values; negative values are stored plus 2^32. Its arrays live until the file is
    /// released.
    /// Calls flgMeshFileGetFaceColumn.
    Result<MeshFaceColumn> face_column(uint32_t column) const {
        FlgMeshFaceColumn out_column;
        flgMeshFaceColumnInit(&out_column, detail::size_of<FlgMeshFaceColumn>);
        const FlgResult result = flgMeshFileGetFaceColumn(handle_, column, &out_column);
        return detail::made<flgIoErrorGetMessage>(result, MeshFaceColumn(out_column));
    }

    /// The material of a region in a .gltf or .glb file, in an .obj file's `mtllib`, of a .ply file's textures, 0 to
    /// the info's material_count - 1. Missing factors get glTF's defaults: white, metallic 1, roughness 1; in .obj and
    /// .ply files metallic 0. Lines are read only from this library's files: glTF has none. Its name lives until the
    /// file is released.
    /// Calls flgMeshFileGetMaterial.
    Result<MeshMaterial> material(uint32_t material) const {
        FlgMeshMaterial out_material;
        flgMeshMaterialInit(&out_material, detail::size_of<FlgMeshMaterial>);
        const FlgResult result = flgMeshFileGetMaterial(handle_, material, &out_material);
        return detail::made<flgIoErrorGetMessage>(result, MeshMaterial(out_material));
    }

    /// A texture of a material, 0 to the info's texture_count - 1. Its picture is not decoded; it lives until the file
    /// is released.
    /// Calls flgMeshFileGetTexture.
    Result<Texture> texture(uint32_t texture) const {
        FlgTexture out_texture;
        flgTextureInit(&out_texture, detail::size_of<FlgTexture>);
        const FlgResult result = flgMeshFileGetTexture(handle_, texture, &out_texture);
        return detail::made<flgIoErrorGetMessage>(result, Texture(out_texture));
    }

    /// The file's contents and warnings. Set struct_size.
    /// Calls flgMeshFileGetInfo.
    Result<MeshFileInfo> info() const {
        FlgMeshFileInfo out_info;
        flgMeshFileInfoInit(&out_info, detail::size_of<FlgMeshFileInfo>);
        const FlgResult result = flgMeshFileGetInfo(handle_, &out_info);
        return detail::made<flgIoErrorGetMessage>(result, MeshFileInfo(out_info));
    }

    /// Writes a mesh to .ply, .obj, .off or .glb, completely or not at all, as flgCurveFileWrite. `desc` may be null.
    /// .ply and .glb keep every bit of positions; text has 9 digits. A column FLG_ATTRIBUTE_UV, with v downwards,
    /// becomes TEXCOORD_0 in .glb, `vt` in .obj, `s` and `t` in .ply; .off has none. .glb gets normals: the column's,
    /// else area-weighted ones. Errors: FLG_ERROR_INVALID_ARGUMENT (also for no triangles, and for indices out of
    /// range), FLG_ERROR_FORMAT for another extension, FLG_ERROR_FILE, FLG_ERROR_LIMIT (.ply, .glb: 2 GiB). Cost: 0.2
    /// to 0.5 us a triangle.
    /// Calls flgMeshFileWrite.
    static Result<bool> write(const char* path, const FlgMeshView& view, const MeshFileWriteDesc& desc =
        MeshFileWriteDesc()) {
        const FlgResult result = flgMeshFileWrite(path, &view, &desc);
        return detail::done<flgIoErrorGetMessage>(result);
    }
};

/// A skin read from a .gltf or .glb file, with its animations and its memory.
class SkinFile : public detail::Object<FlgSkinFile, flgSkinFileRelease> {
public:
    using Object::Object;

    /// Reads the skinned mesh in a file's scene: all nodes with a mesh and the first skin found; other meshes are
    /// skipped, with a warning. The rest pose is that of the skin's inverseBindMatrices, whatever the nodes say. Joints
    /// rotated in that pose are read without the rotation; animation rotations change so that each vertex moves as
    /// before. The keys of all channels of an animation are merged. Joints come parents first; joints below other nodes
    /// attach to the nearest joint above. Weights are sorted and normalized to sum 1; only the first four joints of a
    /// vertex are read. Missing normals are computed. Parts come from the column _PART, else from the materials.
    /// TEXCOORD_0 becomes the view's corner_uvs. Morph targets are read if all primitives have as many; their
    /// animations must be LINEAR. Refused, as FlgSkinAnimation cannot represent them: scaled joints, joints that an
    /// animation moves away from their parents, roots that move differently, keys that are not LINEAR. Also refused:
    /// missing, out-of-range or non-finite joints or weights, cycles of nodes, inconsistent counts. If the scene has no
    /// skin the result is FLG_OK and `out_file` null. `desc` may be null: all defaults. Cost: one core, about 0.4 us a
    /// vertex. Errors: FLG_ERROR_FILE, FLG_ERROR_FORMAT, FLG_ERROR_LIMIT (2 GiB a file and for the result; 65535
    /// joints).
    /// Calls flgSkinFileRead.
    static Result<SkinFile> read(const char* path, const SkinFileReadDesc& desc = SkinFileReadDesc()) {
        FlgSkinFile out_file{};
        const FlgResult result = flgSkinFileRead(path, &desc, &out_file);
        return detail::made<flgIoErrorGetMessage>(result, SkinFile(out_file));
    }

    /// The skin; lives until the file is released.
    /// Calls flgSkinFileGetView.
    Result<SkinView> view() const {
        FlgSkinView out_view;
        flgSkinViewInit(&out_view, detail::size_of<FlgSkinView>);
        const FlgResult result = flgSkinFileGetView(handle_, &out_view);
        return detail::made<flgIoErrorGetMessage>(result, SkinView(out_view));
    }

    /// An animation, 0 to the info's animation_count - 1, in the file's order. Its arrays live until the file is
    /// released.
    /// Calls flgSkinFileGetAnimation.
    Result<SkinAnimation> animation(uint32_t animation) const {
        FlgSkinAnimation out_animation;
        flgSkinAnimationInit(&out_animation, detail::size_of<FlgSkinAnimation>);
        const FlgResult result = flgSkinFileGetAnimation(handle_, animation, &out_animation);
        return detail::made<flgIoErrorGetMessage>(result, SkinAnimation(out_animation));
    }

    /// The material of a part, 0 to the info's material_count - 1. As flgMeshFileGetMaterial.
    /// Calls flgSkinFileGetMaterial.
    Result<MeshMaterial> material(uint32_t material) const {
        FlgMeshMaterial out_material;
        flgMeshMaterialInit(&out_material, detail::size_of<FlgMeshMaterial>);
        const FlgResult result = flgSkinFileGetMaterial(handle_, material, &out_material);
        return detail::made<flgIoErrorGetMessage>(result, MeshMaterial(out_material));
    }

    /// A texture of a material, 0 to the info's texture_count - 1. As flgMeshFileGetTexture.
    /// Calls flgSkinFileGetTexture.
    Result<Texture> texture(uint32_t texture) const {
        FlgTexture out_texture;
        flgTextureInit(&out_texture, detail::size_of<FlgTexture>);
        const FlgResult result = flgSkinFileGetTexture(handle_, texture, &out_texture);
        return detail::made<flgIoErrorGetMessage>(result, Texture(out_texture));
    }

    /// A morph target, 0 to the info's morph_count - 1. Its arrays live until the file is released; `normal_moves` are
    /// 0 where the file has none.
    /// Calls flgSkinFileGetMorphTarget.
    Result<MorphTarget> morph_target(uint32_t target) const {
        FlgMorphTarget out_target;
        flgMorphTargetInit(&out_target, detail::size_of<FlgMorphTarget>);
        const FlgResult result = flgSkinFileGetMorphTarget(handle_, target, &out_target);
        return detail::made<flgIoErrorGetMessage>(result, MorphTarget(out_target));
    }

    /// What animates morph targets, 0 to the info's morph_animation_count - 1. Its arrays live until the file is
    /// released.
    /// Calls flgSkinFileGetMorphAnimation.
    Result<MorphAnimation> morph_animation(uint32_t animation) const {
        FlgMorphAnimation out_animation;
        flgMorphAnimationInit(&out_animation, detail::size_of<FlgMorphAnimation>);
        const FlgResult result = flgSkinFileGetMorphAnimation(handle_, animation, &out_animation);
        return detail::made<flgIoErrorGetMessage>(result, MorphAnimation(out_animation));
    }

    /// The file's contents and warnings. Set struct_size.
    /// Calls flgSkinFileGetInfo.
    Result<SkinFileInfo> info() const {
        FlgSkinFileInfo out_info;
        flgSkinFileInfoInit(&out_info, detail::size_of<FlgSkinFileInfo>);
        const FlgResult result = flgSkinFileGetInfo(handle_, &out_info);
        return detail::made<flgIoErrorGetMessage>(result, SkinFileInfo(out_info));
    }

    /// Writes a skin with its animations to .glb, completely or not at all, as flgCurveFileWrite: a node with the mesh,
    /// a node above all roots, which the skin names as its skeleton, and one node per joint. Vertices have POSITION,
    /// NORMAL, JOINTS_0 (16 bits), WEIGHTS_0 (float), _PART, with corner_uvs TEXCOORD_0, with vertex_colors COLOR_0.
    /// They keep their order; of those whose corners differ in texture coordinates, copies follow after all. Morph
    /// targets have POSITION and NORMAL, sparse where few vertices move; their weights are animated at the mesh's node,
    /// and at those of levels that have them. Levels of detail are meshes of the same skin, named NAME_LOD0, NAME_LOD1,
    /// ...; the first is in the scene and refers to the others by MSFT_lod, so programs that do not know it show the
    /// finest alone. Rotations that stay at identity are omitted. Refuses what glTF forbids: joints out of range or
    /// twice at a vertex, weights that do not sum to 1 within 0.0001, quaternions that are not of length 1 within
    /// 0.001, times that do not rise, values that are not finite, parents that do not come first. Cost: about 0.8 us a
    /// vertex. Errors: FLG_ERROR_INVALID_ARGUMENT, FLG_ERROR_FORMAT for another extension, FLG_ERROR_FILE,
    /// FLG_ERROR_LIMIT (2 GiB).
    /// Calls flgSkinFileWrite.
    static Result<bool> write(const char* path, const SkinFileWriteDesc& desc) {
        const FlgResult result = flgSkinFileWrite(path, &desc);
        return detail::done<flgIoErrorGetMessage>(result);
    }
};

/// A history read from a file, with its memory.
class TangleFile : public detail::Object<FlgTangleFile, flgTangleFileRelease> {
public:
    using Object::Object;

    /// Writes a tangle's history (flgTangleGetHistory) as readable JSON, with arrays of more than twelve numbers in a
    /// side file beside it: `PATH.CHECKSUM.bin`. The JSON is put in place last; then the previous document's side file
    /// is removed: an interrupted save leaves the previous document intact. No side file is written if none is needed.
    /// The same history gives the same bytes. `desc` may be null: all defaults. An FlgFileSystem opens and closes one
    /// file after the other. Errors: FLG_ERROR_INVALID_ARGUMENT (null, values that are not finite), FLG_ERROR_FILE,
    /// FLG_ERROR_LIMIT (8 MiB of JSON, 2 GiB of arrays). Cost: some us a step and what the disk takes.
    /// Calls flgTangleFileWrite.
    static Result<bool> write(const char* path, const FlgTangleHistory& history, const TangleFileWriteDesc& desc =
        TangleFileWriteDesc()) {
        const FlgResult result = flgTangleFileWrite(path, &history, &desc);
        return detail::done<flgIoErrorGetMessage>(result);
    }

    /// Reads a document and checks what can be checked without its mesh: version, keys, types, sizes, the side file's
    /// size and checksum, finite numbers. flgTangleReplay checks the values' ranges. Nothing is read twice, so the
    /// result is at most some multiple of the file's size. `desc` may be null: all defaults. Errors: FLG_ERROR_FILE,
    /// FLG_ERROR_FORMAT, FLG_ERROR_LIMIT. Cost: some us a step and what the disk takes.
    /// Calls flgTangleFileRead.
    static Result<TangleFile> read(const char* path, const TangleFileReadDesc& desc = TangleFileReadDesc()) {
        FlgTangleFile out_file{};
        const FlgResult result = flgTangleFileRead(path, &desc, &out_file);
        return detail::made<flgIoErrorGetMessage>(result, TangleFile(out_file));
    }

    /// The history, ready for flgTangleReplay; lives until the file is released.
    /// Calls flgTangleFileGetHistory.
    Result<TangleHistory> history() const {
        FlgTangleHistory out_history;
        flgTangleHistoryInit(&out_history, detail::size_of<FlgTangleHistory>);
        const FlgResult result = flgTangleFileGetHistory(handle_, &out_history);
        return detail::made<flgIoErrorGetMessage>(result, TangleHistory(out_history));
    }
};

/// Embree's acceleration structures over copies of surfaces and curves.
class PickScene : public detail::Object<FlgPickScene, flgPickSceneDestroy> {
public:
    using Object::Object;

    /// `desc` may be null: all defaults. Cost: 0.2 to 1 ms.
    /// Calls flgPickSceneCreate.
    static Result<PickScene> create(const PickSceneDesc& desc = PickSceneDesc()) {
        FlgPickScene out_scene{};
        const FlgResult result = flgPickSceneCreate(&desc, &out_scene);
        return detail::made<flgPickErrorGetMessage>(result, PickScene(out_scene));
    }

    /// Adds a surface to the scene under an index of the host's choice, or updates the one there; anything else under
    /// that index is removed. With `changed` (flgSurfaceGetChanges since the revision last set in the scene; triangles
    /// beyond those set count as changed) only these triangles are added beside the existing structure. The structure
    /// is rebuilt once a quarter of the triangles has changed, or with `changed` null. Takes effect with
    /// flgPickSceneCommit. Cost: about 1 us a triangle that is new, with flgPickSceneCommit.
    /// Calls flgPickSceneSetSurface.
    Result<bool> set_surface(uint32_t object, const FlgSurfaceView& surface, Span<const uint32_t> changed = {}) const {
        const FlgResult result = flgPickSceneSetSurface(handle_, object, &surface, changed.data(),
            detail::count(changed.size()));
        return detail::done<flgPickErrorGetMessage>(result);
    }

    /// Likewise for curves, as round tubes: with their RADIUS, or half their WIDTH, but at least `min_radius` (metres,
    /// > 0), so that thin lines can be hit. Cost: about 1.6 us a point that is new, with flgPickSceneCommit.
    /// Calls flgPickSceneSetCurves.
    Result<bool> set_curves(uint32_t object, const FlgCurveSetView& curves, float min_radius) const {
        const FlgResult result = flgPickSceneSetCurves(handle_, object, &curves, min_radius);
        return detail::done<flgPickErrorGetMessage>(result);
    }

    /// FLG_ERROR_INVALID_ARGUMENT if nothing is under that index.
    /// Calls flgPickSceneRemove.
    Result<bool> remove(uint32_t object) const {
        const FlgResult result = flgPickSceneRemove(handle_, object);
        return detail::done<flgPickErrorGetMessage>(result);
    }

    /// Builds what was set since the last commit. Queries before the first commit hit nothing. Cost: with
    /// flgPickSceneSetSurface, see there.
    /// Calls flgPickSceneCommit.
    Result<bool> commit() const {
        const FlgResult result = flgPickSceneCommit(handle_);
        return detail::done<flgPickErrorGetMessage>(result);
    }

    /// [any thread] The first hit of each ray, on both sides of surfaces. FLG_ERROR_INVALID_ARGUMENT names the first
    /// invalid ray; no ray is then shot. Cost, with 2 million triangles: about a microsecond a ray, half of that for
    /// 10,000 rays or more at a time.
    /// Calls flgPickSceneCastRays.
    Result<bool> cast_rays(Span<const FlgRay> rays, FlgHit* out_hits) const {
        const FlgResult result = flgPickSceneCastRays(handle_, rays.data(), detail::count(rays.size()), out_hits);
        return detail::done<flgPickErrorGetMessage>(result);
    }

    /// [any thread] The nearest point within `max_distance` (metres, > 0, may be infinite). Cost: some us, tens if it
    /// is far.
    /// Calls flgPickSceneFindNearest.
    Result<Hit> find_nearest(const float point[3], float max_distance) const {
        FlgHit out_hit{};
        const FlgResult result = flgPickSceneFindNearest(handle_, point, max_distance, &out_hit);
        return detail::made<flgPickErrorGetMessage>(result, out_hit);
    }
};

/// A context owns everything else. At most 1024 exist at a time in a process.
class Context : public detail::ContextOwner {
public:
    using ContextOwner::ContextOwner;

    /// Creates a context and starts its workers. `desc` may be null: all defaults. Cost: below a millisecond.
    /// Calls flgContextCreate.
    static Result<Context> create(const ContextDesc& desc = ContextDesc()) {
        FlgContext out_context{};
        const FlgResult result = flgContextCreate(&desc, &out_context);
        return detail::made(result, Context(out_context));
    }

    /// Runs one frame: publishes finished jobs until `budget_us` is spent (the rest next time), calls their callbacks,
    /// and, in a context without workers, advances jobs until it is spent, by one slice at least. A budget of 0
    /// publishes at most one job and advances none; with FLG_UNLIMITED a context without workers runs all its jobs to
    /// the end. Ends at most one slice after its budget. `report` may be null; set its struct_size. Allocates nothing
    /// in steady state. Frees results released before their job was done, at the cost of their release.
    /// Calls flgContextTick.
    Result<FrameReport> tick(uint32_t budget_us) const {
        FlgFrameReport report;
        flgFrameReportInit(&report, detail::size_of<FlgFrameReport>);
        const FlgResult result = flgContextTick(handle_, budget_us, &report);
        return detail::made(result, report);
    }

    /// [any thread] What the context holds of one kind, or of all. The kinds sum to what the allocator has handed out
    /// and not got back, to the byte, with the 8 bytes or so that the library adds to each block. Without an allocator
    /// of the host's, up to 32 MB of large blocks that are free wait to be used again; they are not counted. While jobs
    /// run, a block that moves from one kind to another may be seen in both. An object counts as its kind once its job
    /// has ended; the copies of inputs that a job waits with count as the kind of its result. Cost: tens of
    /// nanoseconds. Allocates nothing.
    /// Calls flgContextGetMemory.
    Result<MemoryUse> memory(FlgMemoryKind kind) const {
        FlgMemoryUse out_use;
        flgMemoryUseInit(&out_use, detail::size_of<FlgMemoryUse>);
        const FlgResult result = flgContextGetMemory(handle_, kind, &out_use);
        return detail::made(result, out_use);
    }

    /// Limits what the context may hold of one kind, or of all, in bytes; 0: no limit. What would exceed it fails with
    /// FLG_ERROR_OUT_OF_MEMORY, as if the allocator had returned null: a call, or a job, whose result counts as its
    /// kind when it ends. Takes nothing away: with more in use than the limit nothing further is taken.
    /// FlgContextDesc's memory_limit is the limit of FLG_MEMORY_KIND_TOTAL from the start. Cost: nanoseconds.
    /// Calls flgContextSetMemoryLimit.
    Result<bool> set_memory_limit(FlgMemoryKind kind, uint64_t bytes) const {
        const FlgResult result = flgContextSetMemoryLimit(handle_, kind, bytes);
        return detail::done(result);
    }

    /// For tools and loading screens: sleeps until flgContextTick has something to publish, no job is left, or the
    /// timeout passes. Returns FLG_OK if there is something to publish or no job is left, FLG_NOT_READY otherwise.
    /// Returns at once in a context without workers, where flgContextTick does the work.
    /// Calls flgContextWait.
    Result<bool> wait(uint32_t timeout_us) const {
        const FlgResult result = flgContextWait(handle_, timeout_us);
        return detail::done(result);
    }

    /// For tools, tests and loading screens: ticks and sleeps until `jobs` are finished, or with a count of 0 until the
    /// context has no job left, or until `seconds` (0 to 1e9, by the wall) are over. Returns FLG_OK, the result of the
    /// first of `jobs` that failed, or FLG_NOT_READY when the time is over. Callbacks of jobs run as in flgContextTick.
    /// Not from callbacks.
    /// Calls flgContextRun.
    Result<bool> run(Span<const FlgJob> jobs = {}, double seconds = 1e9) const {
        const FlgResult result = flgContextRun(handle_, jobs.data(), detail::count(jobs.size()), seconds);
        return detail::done(result);
    }

    /// Copies curves into the context. Every curve needs at least one point; magnitudes must not exceed 1e30. Accepts
    /// repeated points and zero-length curves unchanged; each function documents how it treats them. Cost: one pass
    /// over the data, about 2 ms for a million points.
    /// Calls flgCurveSetCreate.
    Result<CurveSet> curve_set(const FlgCurveSetView& view) const {
        FlgCurveSet out_set{};
        const FlgResult result = flgCurveSetCreate(handle_, &view, &out_set);
        return detail::made(result, CurveSet(handle_, out_set));
    }

    /// The same for one curve through `count` points, at least 1, of 3 floats each, metres. `flags`: 0 or
    /// FLG_CURVE_CLOSED. Cost: one pass over the points.
    /// Calls flgCurveSetCreateFromPoints.
    Result<CurveSet> curve_set_from_points(Span<const float> points, uint8_t flags = 0) const {
        FlgCurveSet out_set{};
        const FlgResult result = flgCurveSetCreateFromPoints(handle_, points.data(), detail::count(points.size(), 3),
            flags, &out_set);
        return detail::made(result, CurveSet(handle_, out_set));
    }

    /// Starts a job that prepares a style: guide, matching, displacement, patch graph. The handle can be passed to
    /// flgCurveSetStylize at once; its job then waits for this one. Cost: below 2 ms of work for 600 points.
    /// Calls flgStyleCreate.
    Result<Style> style(const StyleDesc& desc, Job* out_job = nullptr) const {
        FlgStyle out_style{};
        FlgJob job_made{};
        const FlgResult result = flgStyleCreate(handle_, &desc, &out_style, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Style(handle_, out_style));
    }

    /// Loads a style from such bytes, ready at once; it gives the same results, bit for bit. The bytes need no
    /// alignment and may be freed afterwards. FLG_ERROR_FORMAT for truncated, damaged or malicious bytes, or another
    /// format version. Cost: about a millisecond a megabyte.
    /// Calls flgStyleCreateFromData.
    Result<Style> style_from_data(Span<const uint8_t> data) const {
        FlgStyle out_style{};
        const FlgResult result = flgStyleCreateFromData(handle_, data.data(), data.size(), &out_style);
        return detail::made(result, Style(handle_, out_style));
    }

    /// Starts a job that applies a style to curves (Algorithm 1, ApplyStyle). The result has each target curve once per
    /// stroke, resampled to the style's spacing times scale. Columns: POSITION, TANGENT and NORMAL (the target's
    /// frame), STYLE_INDEX, DISPLACEMENT if requested, the style's attributes and the target's other columns. A target
    /// curve shorter than one step gets two points; a zero-length curve gets one, not displaced. Targets shorter than
    /// the style get part of it. Closed targets give closed results: their last path, of up to 256 points, leads back
    /// to the style point that the curve began with, by one jump. The runs before and behind it are cross-faded over 6
    /// p points, if need be on over the curve's first ones. For that curves begin 64 points into the style at least, or
    /// in the middle of a shorter one. So sizes, frames and ribbons cross the curve's start as evenly as elsewhere.
    /// Displacements are those of the style at STYLE_INDEX. After a jump from style point i to point j, the gap d[i +
    /// 1] - d[j] and that of the steps there are added and fade to zero by a cubic over p to 4 p points: results go on
    /// where they were and as they went, with no steps and turns that the style lacks. Attributes take the style's
    /// values at STYLE_INDEX; RADIUS, WIDTH and the half axes of RADII are multiplied by scale. After jumps attributes
    /// blend as displacements do: angles the shorter way round, others kept within the style's least and largest value.
    /// Angles are continuous along a curve: whole turns (PROJECTIVE: half turns) are added as needed. As floats, they
    /// keep a precision of 1e-4 rad after 150 turns. ANGLE also turns the result's NORMAL about its tangent. With SPEED
    /// the result has TIME, starting at the target's first TIME value, or 0; each step takes its length divided by the
    /// mean speed of its ends. Results obey the limits of curve sets: if a coordinate, a length or a time would exceed
    /// 1e30, the job fails with FLG_ERROR_INVALID_ARGUMENT and names it. Cost: about 50 ns a point of the result, and
    /// once for each style and temperature the path trees, 0.1 ms each.
    /// Calls flgCurveSetStylize.
    Result<CurveSet> stylize(const CurveSetStylizeDesc& desc, Job* out_job = nullptr) const {
        FlgCurveSet out_set{};
        FlgJob job_made{};
        const FlgResult result = flgCurveSetStylize(handle_, &desc, &out_set, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, CurveSet(handle_, out_set));
    }

    /// Starts a job that makes a manifold surface from any triangles; flgSurfaceGetReport reports its repairs. This
    /// call copies the arrays: about 10 ms for 2 million triangles. The job fails with FLG_ERROR_INVALID_ARGUMENT if an
    /// index is out of range, a position is not finite, or no triangle is left; also if the mesh lies so far from its
    /// origin that floats cannot hold its shape: if most edges are shorter than 8 times the spacing of floats at their
    /// ends. Cost: about 0.3 us a triangle.
    /// Calls flgSurfaceCreate.
    Result<Surface> surface(const SurfaceDesc& desc, Job* out_job = nullptr) const {
        FlgSurface out_surface{};
        FlgJob job_made{};
        const FlgResult result = flgSurfaceCreate(handle_, &desc, &out_surface, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Surface(handle_, out_surface));
    }

    /// The same with all defaults for plain arrays: 3 floats a vertex, metres, and 3 vertices a triangle. Cost: that of
    /// flgSurfaceCreate.
    /// Calls flgSurfaceCreateFromTriangles.
    Result<Surface> surface_from_triangles(Span<const float> positions, Span<const uint32_t> triangles,
        const FlgJobOptions* job = nullptr, Job* out_job = nullptr) const {
        FlgSurface out_surface{};
        FlgJob job_made{};
        const FlgResult result = flgSurfaceCreateFromTriangles(handle_, positions.data(),
            detail::count(positions.size(), 3), triangles.data(), detail::count(triangles.size(), 3), job,
            &out_surface, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Surface(handle_, out_surface));
    }

    /// Starts a job that computes distances along the surface from the nearest source to every vertex. It unfolds
    /// fronts over triangles; the error is below 0.2 % (RMS) on natural meshes, and below 0.6 % on them stretched to
    /// twenty times their length: where triangles are obtuse, others of the same shape are unfolded (intrinsic edge
    /// flips), and the surface is not changed. No distance exceeds that along edges by more than 3e-5 of it. From
    /// points and vertices alone, at most 16 or with labels, none is less than the straight line. The first job on a
    /// surface also builds the solver's data (about 0.15 us a triangle; kept, and updated by cuts). Cost then: about 40
    /// ns a triangle within the limits and below 1 ns for each other one, as every vertex has a value. If sources lie
    /// outside the regions, all distances are infinite. FLG_ERROR_OUT_OF_MEMORY also if memory runs out while building
    /// that data.
    /// Calls flgFieldCreateGeodesic.
    Result<Field> field_geodesic(const FieldGeodesicDesc& desc, Job* out_job = nullptr) const {
        FlgField out_field{};
        FlgJob job_made{};
        const FlgResult result = flgFieldCreateGeodesic(handle_, &desc, &out_field, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Field(handle_, out_field));
    }

    /// A field from the host, one value per vertex of the current surface (FLG_NOT_READY while it changes); values may
    /// be infinite, but not NaN. Cost: a copy.
    /// Calls flgFieldCreate.
    Result<Field> field(FlgSurface surface, Span<const float> values) const {
        FlgField out_field{};
        const FlgResult result = flgFieldCreate(handle_, surface, values.data(), detail::count(values.size()),
            &out_field);
        return detail::made(result, Field(handle_, out_field));
    }

    /// Starts a job that blends two distance fields of one surface: from / (from + to), sec. 3.2. 0.5 where both are 0;
    /// infinite where both are infinite. Cost: about 5 ns a vertex.
    /// Calls flgFieldBlend.
    Result<Field> blend(const FieldBlendDesc& desc, Job* out_job = nullptr) const {
        FlgField out_field{};
        FlgJob job_made{};
        const FlgResult result = flgFieldBlend(handle_, &desc, &out_field, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Field(handle_, out_field));
    }

    /// Starts a job that joins points by locally shortest paths: straight across edges, and at vertices no shorter on
    /// either side (to 1e-6). The job fails if no path joins two points; zero-length paths are omitted. Cost: a field
    /// for each two points, up to where they meet, and its copy.
    /// Calls flgFieldTracePaths.
    Result<SurfaceCurves> trace_paths(const FieldTracePathsDesc& desc, Job* out_job = nullptr) const {
        FlgSurfaceCurves out_curves{};
        FlgJob job_made{};
        const FlgResult result = flgFieldTracePaths(handle_, &desc, &out_curves, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, SurfaceCurves(handle_, out_curves));
    }

    /// Starts a job that cuts a surface along isolines, all levels in one pass: they become chains of edges. Crossings
    /// nearer to a vertex than 1/100 of their edge move to it, to avoid slivers. Nothing else moves; the surface keeps
    /// its area and topology. New vertices and triangles are appended, with interpolated columns. `out_field` (may be
    /// null): the field on the cut surface. Cost: about 10 ns a triangle of the surface and 0.5 us a triangle cut.
    /// Calls flgSurfaceCutIsolines.
    Result<Field> cut_isolines(const SurfaceCutIsolinesDesc& desc, Job* out_job = nullptr) const {
        FlgField out_field{};
        FlgJob job_made{};
        const FlgResult result = flgSurfaceCutIsolines(handle_, &desc, &out_field, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Field(handle_, out_field));
    }

    /// Starts a job that cuts a surface along curves, which may cross, touch, and end anywhere. The job first works out
    /// how to divide triangles, which takes longest; until then the surface does not change and the job can be
    /// cancelled. Cost: as flgSurfaceCutIsolines; n curves that cross each other in one triangle take about n * n us
    /// there.
    /// Calls flgSurfaceCutCurves.
    Result<Job> cut_curves(const SurfaceCutCurvesDesc& desc) const {
        FlgJob out_job{};
        const FlgResult result = flgSurfaceCutCurves(handle_, &desc, &out_job);
        return detail::made(result, Job(handle_, out_job));
    }

    /// Starts a job that makes a whole surface the root of a tangle: all labels become 0. The surface's own job may
    /// still run. Cost: about 5 ns a triangle.
    /// Calls flgTangleCreate.
    Result<Tangle> tangle(FlgSurface surface, const FlgJobOptions* job = nullptr, Job* out_job = nullptr) const {
        FlgTangle out_tangle{};
        FlgJob job_made{};
        const FlgResult result = flgTangleCreate(handle_, surface, job, &out_tangle, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Tangle(handle_, out_tangle));
    }

    /// Starts a job that makes the straight skeleton of a contour: the paths of its corners as all edges move inwards
    /// at unit speed. This call copies and cleans the contour: it orients rings (ring 0 counter-clockwise, holes
    /// clockwise) and merges consecutive points closer than 1e-11 of the drawing's size into the first. Collinear
    /// points stay, each with a face. The call refuses numbers that are not finite and rings without three points or an
    /// area; it takes about 20 ns a point. The job fails with FLG_ERROR_INVALID_ARGUMENT where edges cross or touch, or
    /// a hole is not inside; the message names points and place. FLG_ERROR_INTERNAL if too much happens at one time to
    /// find a valid skeleton: not known to occur. Cost: about 3 us a point, growing with n log n. With `repair` none of
    /// this fails while an area is left. The contour becomes the border of the area that ring 0 winds around, either
    /// way, minus the areas other rings wind around; of its connected parts, the largest is kept, with its holes. Where
    /// nothing crosses or touches, points do not move, to the bit. Elsewhere they move by less than 1e-7 of the
    /// drawing's size (about 1e-6 at points where the contour touches itself). Crossings get new points, whose
    /// input_points are FLG_NO_INDEX. Repair adds about 2 us a point.
    /// Calls flgStraightSkeletonCreate.
    Result<StraightSkeleton> straight_skeleton(const StraightSkeletonDesc& desc, Job* out_job = nullptr) const {
        FlgStraightSkeleton out_skeleton{};
        FlgJob job_made{};
        const FlgResult result = flgStraightSkeletonCreate(handle_, &desc, &out_skeleton,
            out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, StraightSkeleton(handle_, out_skeleton));
    }

    /// Starts a job that finds the silhouette of a surface or its regions from afar, or the border of a flat region; of
    /// several pieces the largest, with its holes. Fails if there are no such triangles or nothing is visible. Without
    /// a direction it also fails if the normals cancel out, as on a closed surface. Cost: 40 ns a triangle and 3 us a
    /// side of the borders.
    /// Calls flgOutlineCreate.
    Result<Outline> outline(const OutlineDesc& desc, Job* out_job = nullptr) const {
        FlgOutline out_outline{};
        FlgJob job_made{};
        const FlgResult result = flgOutlineCreate(handle_, &desc, &out_outline, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Outline(handle_, out_outline));
    }

    /// Starts a job that finds the axis of a contour, sec. 3.1 of the paper. It resamples the contour at equal
    /// distances, keeps the points that matter (the outline), and makes their straight skeleton. It drops arcs that end
    /// on the outline and short arcs, then fits smooth curves to the branches and cuts slices across them. Where the
    /// outline would cross itself, the job reduces the tolerance, down to the line as drawn. Reports invalid contours
    /// as flgStraightSkeletonCreate does; it may smooth away crossings much smaller than the spacing. Around a hole the
    /// axis passes on one side only: bones cannot form cycles. Cost: 0.1 to 0.3 ms for a drawn contour.
    /// Calls flgPartCreate.
    Result<Part> part(const PartDesc& desc, Job* out_job = nullptr) const {
        FlgPart out_part{};
        FlgJob job_made{};
        const FlgResult result = flgPartCreate(handle_, &desc, &out_part, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Part(handle_, out_part));
    }

    /// Starts a job that inflates a part, sec. 4.1: it triangulates the contour with interior points, solves a Poisson
    /// equation for the height, and joins both sides. The surface is closed and manifold, also around holes. Cost: 3 ms
    /// for 700 vertices.
    /// Calls flgPartMeshCreate.
    Result<PartMesh> part_mesh(const PartMeshDesc& desc, Job* out_job = nullptr) const {
        FlgPartMesh out_mesh{};
        FlgJob job_made{};
        const FlgResult result = flgPartMeshCreate(handle_, &desc, &out_mesh, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, PartMesh(handle_, out_mesh));
    }

    /// Starts a job that makes one skeleton from the parts, sec. 3.1 (BoundedDP), 3.2 and 3.3 of the paper: it places
    /// joints along the branches, connects parts, merges junctions, and removes short branches and bones. The hierarchy
    /// begins in the middle of the trunk; a part that meets no other is another root. Joints of one contour that is its
    /// own mirror image are mirror images too. The job fails if an edit pins a joint outside of its part, merges a root
    /// or gives two joints one name; the model before it stays as it was. FLG_ERROR_LIMIT above 65535 joints. Cost: 20
    /// us a part.
    /// Calls flgModelCreate.
    Result<Model> model(const ModelDesc& desc, Job* out_job = nullptr) const {
        FlgModel out_model{};
        FlgJob job_made{};
        const FlgResult result = flgModelCreate(handle_, &desc, &out_model, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Model(handle_, out_model));
    }

    /// Starts a job that makes one closed surface from all parts of a model, manifold however they meet, and binds it
    /// to the joints: weights are smooth, 0 to 1, at most 4 per vertex. Limbs that cross other parts pass in front or
    /// behind (FlgModelPart::depth). Parts that meet no other stay separate pieces. FLG_ERROR_LIMIT if the thinnest
    /// part needs more than max_vertices, or if a part lies further from the origin than 1e7 sides of a triangle. Cost:
    /// 20 us a vertex.
    /// Calls flgSkinCreate.
    Result<Skin> skin(const SkinDesc& desc, Job* out_job = nullptr) const {
        FlgSkin out_skin{};
        FlgJob job_made{};
        const FlgResult result = flgSkinCreate(handle_, &desc, &out_skin, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Skin(handle_, out_skin));
    }

    /// Starts a job that gives a mesh joints and weights. The skin has the mesh's own vertices and triangles in their
    /// order, so all that belongs to them (texture coordinates, colours, morph targets) still fits; its normals are the
    /// mesh's, or found if it has none. The mesh should be closed: past holes what is inside is guessed, and what is
    /// thinner than a cell counts as inside. Pieces that do not touch hang on the nearest one. The hierarchy begins in
    /// the middle of the trunk. Limbs that stand out get bones; sheets and bulges don't. A mesh that is its own mirror
    /// image within 3 % gets joints that are mirror images too. Joints have names as drawn ones: body_0, head_0,
    /// arm_1.L; flgRigFind takes them with `joint_radii` and `mirror`. The lattice turns with the mesh. Fails for
    /// meshes without triangles. FLG_ERROR_LIMIT above 65535 joints. Cost: 0.25 s, and 15 us a vertex.
    /// Calls flgSkinCreateFromMesh.
    Result<Skin> skin_from_mesh(const SkinFromMeshDesc& desc, Job* out_job = nullptr) const {
        FlgSkin out_skin{};
        FlgJob job_made{};
        const FlgResult result = flgSkinCreateFromMesh(handle_, &desc, &out_skin, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Skin(handle_, out_skin));
    }

    /// Begins a stroke. FLG_NOT_READY while the style is not prepared, or not warm at this temperature (flgStyleWarm);
    /// flgErrorGetMessage() says which. Returns the error of the style's job if that failed. Cost: the allocation of
    /// its memory, which it does not touch. (An allocator that returns pages touched before spares pushes the system's
    /// cost of first touches.)
    /// Calls flgLiveStrokeBegin.
    Result<LiveStroke> begin(const LiveStrokeDesc& desc) const {
        FlgLiveStroke out_stroke{};
        const FlgResult result = flgLiveStrokeBegin(handle_, &desc, &out_stroke);
        return detail::made(result, LiveStroke(handle_, out_stroke));
    }

    /// The batch form: starts a job that draws every curve of a set of recorded samples as a live stroke, and ends it.
    /// Curve c equals a live stroke through these samples with the same descriptor and seed `seed + c`, bit for bit.
    /// Missing columns mean: no orientation, pressure 1, all times 0 s; without TIME, `smoothing` must be 0. Values
    /// that flgLiveStrokePush would refuse fail the job with the same result. So does a curve of more than max_points
    /// points: FLG_ERROR_LIMIT, before memory is taken (for the points needed, not for max_points). max_samples does
    /// not apply. Closed curves are drawn open. The style need not be ready or warm. `job` may be null. Cost: about 0.3
    /// us a point.
    /// Calls flgLiveStrokeReplay.
    Result<CurveSet> replay(const LiveStrokeDesc& desc, FlgCurveSet samples, const FlgJobOptions* job = nullptr,
        Job* out_job = nullptr) const {
        FlgCurveSet out_set{};
        FlgJob job_made{};
        const FlgResult result = flgLiveStrokeReplay(handle_, &desc, samples, job, &out_set,
            out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, CurveSet(handle_, out_set));
    }

    /// Makes a manifold at once. Cost: 0.1 ms at most.
    /// Calls flgManifoldCreateShape.
    Result<Manifold> manifold_shape(const ManifoldShapeDesc& desc) const {
        FlgManifold out_manifold{};
        const FlgResult result = flgManifoldCreateShape(handle_, &desc, &out_manifold);
        return detail::made(result, Manifold(handle_, out_manifold));
    }

    /// Starts a job that makes the smooth surface of a mesh: moving least squares over its vertices, with their normals
    /// and curvatures. Its error on smooth parts is quadratic in edge length; creases are rounded off. The manifold's
    /// view gives the deviation of its vertices. Opposite sides of thin solids stay apart; two sheets that face the
    /// same way blend where they are closer than an edge length. Tangents jump across edges sharper than about 114
    /// degrees, where nodes of curves are held (see FlgSplineView). Curves may go a quarter of an edge beyond open
    /// borders, and run along there where they would go farther. FLG_OBSTACLE_KIND_BORDER keeps them within the
    /// borders. Cost: about 1 us a triangle.
    /// Calls flgManifoldCreateFromSurface.
    Result<Manifold> manifold_from_surface(const ManifoldFromSurfaceDesc& desc, Job* out_job = nullptr) const {
        FlgManifold out_manifold{};
        FlgJob job_made{};
        const FlgResult result = flgManifoldCreateFromSurface(handle_, &desc, &out_manifold,
            out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Manifold(handle_, out_manifold));
    }

    /// Starts a job that makes the smooth surface of a point cloud by moving least squares (sec. 3.2). Cost: some us a
    /// point.
    /// Calls flgManifoldCreateFromPoints.
    Result<Manifold> manifold_from_points(const ManifoldFromPointsDesc& desc, Job* out_job = nullptr) const {
        FlgManifold out_manifold{};
        FlgJob job_made{};
        const FlgResult result = flgManifoldCreateFromPoints(handle_, &desc, &out_manifold,
            out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Manifold(handle_, out_manifold));
    }

    /// Starts a job that makes the zero set of a sampled function, such as signed distances. Cost: about 20 ns a
    /// sample.
    /// Calls flgManifoldCreateFromGrid.
    Result<Manifold> manifold_from_grid(const ManifoldFromGridDesc& desc, Job* out_job = nullptr) const {
        FlgManifold out_manifold{};
        FlgJob job_made{};
        const FlgResult result = flgManifoldCreateFromGrid(handle_, &desc, &out_manifold,
            out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Manifold(handle_, out_manifold));
    }

    /// The image manifold of a surface's normals (sec. 6, Fig. 17): (x, weight * normal) in R^6. Curves on it avoid
    /// crossing creases; the larger the weight (metres, above 0), the more. `base`: a surface in R^3, ready. Points are
    /// given and shown in R^3; the normals are added and dropped internally. Cost: 0.1 ms at most.
    /// Calls flgManifoldCreateImage.
    Result<Manifold> manifold_image(FlgManifold base, double weight) const {
        FlgManifold out_manifold{};
        const FlgResult result = flgManifoldCreateImage(handle_, base, weight, &out_manifold);
        return detail::made(result, Manifold(handle_, out_manifold));
    }

    /// Makes a manifold from a copy of the functions; user_data must live until the manifold and all splines on it are
    /// released. Tests the functions at one point, and refuses results that are not orthonormal or not finite. Cost:
    /// some calls of the functions.
    /// Calls flgManifoldCreateHost.
    Result<Manifold> manifold_host(const ManifoldFunctions& functions, const double* point_near) const {
        FlgManifold out_manifold{};
        const FlgResult result = flgManifoldCreateHost(handle_, &functions, point_near, &out_manifold);
        return detail::made(result, Manifold(handle_, out_manifold));
    }

    /// Makes a manifold from a copy of the functions at once, evaluating 1089 points. Refuses results that are not
    /// finite, and parallel derivatives. Exclude fixed points such as poles from the domain. Cost: 1089 calls of the
    /// function.
    /// Calls flgManifoldCreatePatch.
    Result<Manifold> manifold_patch(const PatchFunctions& functions) const {
        FlgManifold out_manifold{};
        const FlgResult result = flgManifoldCreatePatch(handle_, &functions, &out_manifold);
        return detail::made(result, Manifold(handle_, out_manifold));
    }

    /// Starts a job that makes obstacles (sec. 5); splines may be requested before it is done. Refuses sizes that are
    /// not positive, polygons that cross themselves, and axes that are not orthonormal; the message names the obstacle.
    /// The job fails for meshes that contain nothing, layers thinner than 4 cells, and surfaces without borders. Cost:
    /// of meshes 100 to 500 ns a cell of their grid, and of closed ones 200 ns a triangle.
    /// Calls flgObstaclesCreate.
    Result<Obstacles> obstacles(const ObstaclesDesc& desc, Job* out_job = nullptr) const {
        FlgObstacles out_obstacles{};
        FlgJob job_made{};
        const FlgResult result = flgObstaclesCreate(handle_, &desc, &out_obstacles, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Obstacles(handle_, out_obstacles));
    }

    /// Starts a job that makes the curve of least energy through points of a manifold, among those that the initial
    /// curve can be moved to: a chain of nodes on the manifold whose fourth derivative (E1: second) has no tangential
    /// part between the given points. Fails with FLG_ERROR_INVALID_ARGUMENT if a point cannot be projected, two
    /// consecutive points coincide, or no path leads from one to the next (add points between them). Antipodal points
    /// of a sphere give a half circle, always the same one. Two points give a geodesic, also with E2. If rounds run out
    /// or rounding stops progress, the curve is still available, and the view says so. On a mesh there is a curve
    /// through any points of one connected part: where the smooth surface can't be reached the result is a curve of
    /// Bezier segments over the triangles (FLG_SPLINE_ENDING_TRIANGLES), with a tangent everywhere but not of least
    /// energy. With partial_results that is also what is seen first, unless there is a warm_start. Cost: 1 us a node
    /// and round on a mesh, and 3 to 8 rounds; the curve over triangles, 10 us a node.
    /// Calls flgSplineCreate.
    Result<Spline> spline(const SplineDesc& desc, Job* out_job = nullptr) const {
        FlgSpline out_spline{};
        FlgJob job_made{};
        const FlgResult result = flgSplineCreate(handle_, &desc, &out_spline, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Spline(handle_, out_spline));
    }

    /// Starts a job that hangs cables between points: a curve set with the descriptor's origin, POSITION and TIME
    /// (metres along the cable), a curve per cable. They do not stretch, and bend without resistance. A span that meets
    /// nothing as it falls from the straight way between its points is a catenary, in closed form: its points are
    /// evenly along that. Others come to rest on the obstacles, where their potential energy is least, on the side they
    /// fall from: the straight way or, where that is blocked, the shortest way over the obstacles. Their segments are
    /// straight, as TIME says to 1e-8, and keep the obstacles' clearance to 1e-6 of the scene's size: of balls, boxes,
    /// capsules, half-spaces and, without a clearance, meshes everywhere; of others at places a 32nd of a segment
    /// apart. What is longer than has room lies on the ground in folds. Points may touch obstacles. Fails with
    /// FLG_ERROR_INVALID_ARGUMENT where a point is inside an obstacle, where a span is too short for the ways around
    /// the obstacles, and where it does not come to rest; with FLG_ERROR_LIMIT above 2^22 segments. Cost: about 0.1 us
    /// a segment of a free span; 5 to 50 ms for a span of 64 that rests on something, up to a second on a mesh or where
    /// the straight way is blocked.
    /// Calls flgCableHang.
    Result<CurveSet> cable_hang(const CableHangDesc& desc, Job* out_job = nullptr) const {
        FlgCurveSet out_set{};
        FlgJob job_made{};
        const FlgResult result = flgCableHang(handle_, &desc, &out_set, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, CurveSet(handle_, out_set));
    }

    /// Starts a job that makes the motion of least energy through keys, or near them: the sum over the body's points of
    /// the energies of their paths. The barycentre's path is then the classical spline. At every moment the fourth
    /// derivatives (E1: the second ones) of the points' paths, taken as forces, are in balance: they neither push nor
    /// turn the body. Between keys a body turns the shorter way round; to force the longer way, add a key in between.
    /// Two consecutive keys with the same pose are a pause: the body comes to rest, stands still and leaves from rest
    /// (not with smoothing, which passes near both). The job fails with FLG_ERROR_INVALID_ARGUMENT for fewer than two
    /// keys, times that do not rise by 1e-9 of the whole motion, numbers that are not finite, poses that reflect or
    /// that stretch by more than 0.001 (less is removed), found times between keys with the same pose, eases that are
    /// not from 0 to 1, and keys whose barycentre is in an obstacle; the message names the key. Cost: some 15 us a
    /// position, closed 20, with E1 40; re-timing and looking 1 to 5 more; around obstacles what the spline there
    /// costs.
    /// Calls flgMotionCreate.
    Result<Motion> motion(const MotionDesc& desc, Job* out_job = nullptr) const {
        FlgMotion out_motion{};
        FlgJob job_made{};
        const FlgResult result = flgMotionCreate(handle_, &desc, &out_motion, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Motion(handle_, out_motion));
    }

    /// Starts a job that projects curves in space onto a surface, ready to be cut along: each point snaps to the
    /// nearest point of the surface. Between two points the curve follows the plane through both and the surface's
    /// normal there or, if that leads nowhere, a shortest path. curve_values are lengths. Curves that collapse to a
    /// single point are omitted. Fails if consecutive points fall on disconnected parts of the surface. Cost: 0.1 us a
    /// triangle of the surface, some us a point near it (more the farther off) and 0.1 us a triangle passed.
    /// Calls flgCurveSetProject.
    Result<SurfaceCurves> project(const CurveSetProjectDesc& desc, Job* out_job = nullptr) const {
        FlgSurfaceCurves out_curves{};
        FlgJob job_made{};
        const FlgResult result = flgCurveSetProject(handle_, &desc, &out_curves, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, SurfaceCurves(handle_, out_curves));
    }

    /// Starts a job that makes and factors the mesh's matrix. Any triangles will do. Fails for meshes without
    /// triangles. Cost: 3 us and 0.5 KB a vertex.
    /// Calls flgPullCreate.
    Result<Pull> pull(const PullDesc& desc, Job* out_job = nullptr) const {
        FlgPull out_pull{};
        FlgJob job_made{};
        const FlgResult result = flgPullCreate(handle_, &desc, &out_pull, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Pull(handle_, out_pull));
    }

    /// Starts a job that pulls a mesh. Handles are met after the first round; the rest follows, round by round, until
    /// each piece of the surface is turned against the pose but hardly stretched. Without handles the mesh is as the
    /// pose has it; handles that move as one body move all so. Pieces without handles stay. Of two handles at one place
    /// the first counts. Cost: 0.3 us a vertex and round, and 0.2 us a vertex for each handle that the previous one did
    /// not have: 3 ms for 10,000 vertices.
    /// Calls flgPulledCreate.
    Result<Pulled> pulled(const PulledDesc& desc, Job* out_job = nullptr) const {
        FlgPulled out_pulled{};
        FlgJob job_made{};
        const FlgResult result = flgPulledCreate(handle_, &desc, &out_pulled, out_job ? &job_made : nullptr);
        if (out_job) *out_job = Job(handle_, job_made);
        return detail::made(result, Pulled(handle_, out_pulled));
    }

    /// Curves. LINES and POINTS; FRAMES, where the set has a NORMAL column; SEAMS, where it has STYLE_INDEX. Tangents
    /// are those of the TANGENT column, or between neighbours. Default LINES, FRAMES and SEAMS. Elements: curves. With
    /// partial_results the leading curves are drawn. Cost: a pass over the points.
    /// Calls flgDebugDrawCurveSet.
    Result<bool> debug_draw_curve_set(FlgCurveSet set, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawCurveSet(handle_, set, &desc, &drawing);
        return detail::done(result);
    }

    /// [any thread, one per stroke] A live stroke's points so far, as of a curve set; its tip is not drawn. Default
    /// LINES, FRAMES and SEAMS. Elements: curves, of which there is one. As a call of flgLiveStrokeGetPoints, it ends
    /// the life of the view before. Cost: a pass over the points.
    /// Calls flgDebugDrawLiveStroke.
    Result<bool> debug_draw_live_stroke(FlgLiveStroke stroke, const DebugDrawDesc& desc,
        FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawLiveStroke(handle_, stroke, &desc, &drawing);
        return detail::done(result);
    }

    /// A style: LINES, the example as matched to the guide; GUIDE, green; DISPLACEMENT, grey, from guide to example;
    /// FRAMES of the guide. Default LINES, GUIDE and DISPLACEMENT. Elements: curves. Cost: a pass over the points.
    /// Calls flgDebugDrawStyle.
    Result<bool> debug_draw_style(FlgStyle style, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawStyle(handle_, style, &desc, &drawing);
        return detail::done(result);
    }

    /// A surface: EDGES, coloured by label; BORDERS, red where there is only one triangle, and coloured by the greater
    /// label between labels; POINTS, the vertices. Default BORDERS. Elements: triangles, of POINTS vertices. Cost: a
    /// pass over the triangles.
    /// Calls flgDebugDrawSurface.
    Result<bool> debug_draw_surface(FlgSurface surface, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawSurface(handle_, surface, &desc, &drawing);
        return detail::done(result);
    }

    /// A field: POINTS, the vertices of its surface, from blue (its least value) to red (its greatest); grey where it
    /// is infinite. Default POINTS. Elements: vertices. Refuses a field of an earlier revision of its surface. Cost: a
    /// pass over the vertices, and 1 ns a vertex of the surface for the least and greatest value.
    /// Calls flgDebugDrawField.
    Result<bool> debug_draw_field(FlgField field, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawField(handle_, field, &desc, &drawing);
        return detail::done(result);
    }

    /// Curves on a surface, lifted into space: LINES and POINTS. Default LINES. Elements: curves. Refuses curves of an
    /// earlier revision of their surface. Cost: a pass over the points.
    /// Calls flgDebugDrawSurfaceCurves.
    Result<bool> debug_draw_surface_curves(FlgSurfaceCurves curves, const DebugDrawDesc& desc,
        FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawSurfaceCurves(handle_, curves, &desc, &drawing);
        return detail::done(result);
    }

    /// A tangle: BORDERS between regions, coloured by the greater look, grey where none is seen (looks are the same),
    /// red where the surface ends; EDGES, coloured by region; SEEDS, the points, samples, lines and first border
    /// vertices that the operators started from, coloured by operator. Default BORDERS and SEEDS. Elements: triangles,
    /// of SEEDS operators. Places of seeds are those when the operator was applied. Cost: a pass over the triangles,
    /// and the operators' seeds.
    /// Calls flgDebugDrawTangle.
    Result<bool> debug_draw_tangle(FlgTangle tangle, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawTangle(handle_, tangle, &desc, &drawing);
        return detail::done(result);
    }

    /// A straight skeleton, in the drawing's unit: BORDERS, the contour; LINES, the arcs, and POINTS, their inner
    /// nodes, from blue (time 0) to red (the latest). Default all of these. Elements: points of the contour, arcs,
    /// nodes. Cost: a pass over points, arcs and nodes, and 1 ns a node for the latest time.
    /// Calls flgDebugDrawStraightSkeleton.
    Result<bool> debug_draw_straight_skeleton(FlgStraightSkeleton skeleton, const DebugDrawDesc& desc,
        FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawStraightSkeleton(handle_, skeleton, &desc, &drawing);
        return detail::done(result);
    }

    /// An outline in its place: BORDERS, the contour. Default BORDERS. Elements: rings. Cost: a pass over the points.
    /// Calls flgDebugDrawOutline.
    Result<bool> debug_draw_outline(FlgOutline outline, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawOutline(handle_, outline, &desc, &drawing);
        return detail::done(result);
    }

    /// A part, in the drawing's unit: BORDERS, the outline; LINES, the axis, green; POINTS, its nodes; FRAMES, the
    /// slices across its branches, grey. Default BORDERS and LINES. Elements: rings, arcs, nodes, samples. Cost: a pass
    /// over the points.
    /// Calls flgDebugDrawPart.
    Result<bool> debug_draw_part(FlgPart part, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawPart(handle_, part, &desc, &drawing);
        return detail::done(result);
    }

    /// A part's surface, in the drawing's unit: EDGES. Default EDGES. Elements: triangles. Cost: a pass over the
    /// triangles.
    /// Calls flgDebugDrawPartMesh.
    Result<bool> debug_draw_part_mesh(FlgPartMesh mesh, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawPartMesh(handle_, mesh, &desc, &drawing);
        return detail::done(result);
    }

    /// A model: LINES, a bone from each joint's parent to it, as an octahedron; POINTS, the joints. Both coloured by
    /// part. Default both. Elements: joints. Cost: a pass over the joints.
    /// Calls flgDebugDrawModel.
    Result<bool> debug_draw_model(FlgModel model, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawModel(handle_, model, &desc, &drawing);
        return detail::done(result);
    }

    /// A skin at rest: LINES and POINTS of its joints, as of a model, in one colour; EDGES, coloured by part. Default
    /// LINES and POINTS. Elements: joints, of EDGES triangles. Cost: a pass over the joints or triangles.
    /// Calls flgDebugDrawSkin.
    Result<bool> debug_draw_skin(FlgSkin skin, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawSkin(handle_, skin, &desc, &drawing);
        return detail::done(result);
    }

    /// Obstacles: LINES, their wireframes; CLEARANCE, grey, the same moved outwards by the clearance, without rounding
    /// corners. Functions are drawn as their boxes; meshes, layers and borders as the edges of their surface as it is
    /// now, and as its box while it changes. The clearance of a mesh is that of its box; layers and borders show none.
    /// Default both. Elements: obstacles. Cost: a pass over the obstacles, and over the triangles of meshes.
    /// Calls flgDebugDrawObstacles.
    Result<bool> debug_draw_obstacles(FlgObstacles obstacles, const DebugDrawDesc& desc,
        FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawObstacles(handle_, obstacles, &desc, &drawing);
        return detail::done(result);
    }

    /// A manifold: POINTS on it, and LINES, their outward normals, green. Default both. Meshes and clouds are drawn at
    /// their samples; shapes, formulas and grids next to the middles of 16 x 16 x 16 cells, of the grid's box or of a
    /// cube of the shape's size around its origin; images of surfaces as those. There is nothing to draw of space
    /// itself and of the host's own functions. Elements: samples or cells. Cost: a pass over the samples; 1 to 3 us a
    /// cell.
    /// Calls flgDebugDrawManifold.
    Result<bool> debug_draw_manifold(FlgManifold manifold, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawManifold(handle_, manifold, &desc, &drawing);
        return detail::done(result);
    }

    /// A spline: LINES, orange if rounds ran out or it stalled (FlgSplineEnding); POINTS, the nodes of the given
    /// points, yellow; FRAMES, where the spline has normals. Default LINES and POINTS. Elements: nodes, of POINTS given
    /// points. Of more than three coordinates the first three are drawn; of two, z is 0. With partial_results the last
    /// round is drawn. Cost: a pass over the nodes.
    /// Calls flgDebugDrawSpline.
    Result<bool> debug_draw_spline(FlgSpline spline, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawSpline(handle_, spline, &desc, &drawing);
        return detail::done(result);
    }

    /// A motion: LINES, the barycentre's path; FRAMES, the body's axes x, y, z at it in red, green, blue; POINTS, the
    /// keys, yellow. Default all of these. Elements: positions, of POINTS keys. With partial_results the last round is
    /// drawn. Cost: a pass over the positions.
    /// Calls flgDebugDrawMotion.
    Result<bool> debug_draw_motion(FlgMotion motion, const DebugDrawDesc& desc, FlgDebugDrawing& drawing) const {
        const FlgResult result = flgDebugDrawMotion(handle_, motion, &desc, &drawing);
        return detail::done(result);
    }
};

/// [any thread] The version of the loaded library. flgContextCreate compares it with the header's: the major
/// versions must match, and while the major version is 0 the minor versions too.
/// Calls flgVersionGet.
inline uint32_t version() {
    return flgVersionGet();
}

/// [any thread] Why the last failing call on this thread failed: one sentence, never null, valid until the next
/// failing call on this thread. Successful calls leave it unchanged.
/// Calls flgErrorGetMessage.
inline const char* error_message() {
    return flgErrorGetMessage();
}

/// [any thread] The name of a result, such as "FLG_ERROR_LIMIT"; "FLG_RESULT_UNKNOWN" for other values.
/// Calls flgResultGetName.
inline const char* result_name(FlgResult result) {
    return flgResultGetName(result);
}

/// [any thread] The sizes of what flgBrushMeshWrite would write for the same arguments. `state` may be null and is
/// not changed. FLG_ERROR_LIMIT above 2^32 - 1 vertices. Cost: one pass over the points, about 20 ns each.
/// Calls flgBrushMeshGetSizes.
inline Result<BrushMeshSizes> brush_mesh_sizes(const BrushMeshDesc& desc, const FlgBrushMeshState* state = nullptr) {
    FlgBrushMeshSizes out_sizes;
    flgBrushMeshSizesInit(&out_sizes, detail::size_of<FlgBrushMeshSizes>);
    const FlgResult result = flgBrushMeshGetSizes(&desc, state, &out_sizes);
    return detail::made(result, out_sizes);
}

/// [any thread] Writes vertices and triangles. With a `state` the range must be one open curve, which continues the
/// points of the calls before; the descriptor must otherwise be the same for all of them. `out_sizes` may be null.
/// On failure nothing is written, and the state stays as it was. Errors: FLG_ERROR_INVALID_ARGUMENT (also for
/// values that are not finite, buffers that are too small, unaligned or overlap), FLG_ERROR_LIMIT for indices that
/// the format cannot hold. Cost: about 0.25 us a point of a tube of 8 sides with positions, normals and indices;
/// one core.
/// Calls flgBrushMeshWrite.
inline Result<BrushMeshSizes> brush_mesh_write(const BrushMeshDesc& desc, FlgBrushMeshState* state,
    const BrushMeshOutput& output) {
    FlgBrushMeshSizes out_sizes;
    flgBrushMeshSizesInit(&out_sizes, detail::size_of<FlgBrushMeshSizes>);
    const FlgResult result = flgBrushMeshWrite(&desc, state, &output, &out_sizes);
    return detail::made(result, out_sizes);
}

/// The pose of an animation at a time, ready for flgSkinPose. Between keys rotations turn evenly the shorter way,
/// and translations are linear. Before the first key and after the last, the pose is constant.
///   joint_count      the skin's
///   time             seconds, finite
///   out_rotations    4 per joint
///   out_translation  3, or null; 0 if the animation moves no roots
/// Cost: about 80 ns a joint, 1 ns a key: all times are checked, and of the rest the two keys that are used.
/// Calls flgSkinAnimationSample.
inline Result<bool> skin_animation_sample(const SkinAnimation& animation, uint32_t joint_count, float time,
    float* out_rotations, float* out_translation) {
    const FlgResult result = flgSkinAnimationSample(&animation, joint_count, time, out_rotations, out_translation);
    return detail::done(result);
}

/// [any thread] Writes columns of any view. Values may be infinite, as distances are, or no numbers: see
/// FlgNumberFormat. Errors: FLG_ERROR_INVALID_ARGUMENT, also for buffers that are too small, unaligned or overlap.
/// Cost: as memcpy for packed floats; else 1 to 3 ns a number.
/// Calls flgColumnsWrite.
inline Result<bool> columns_write(const ColumnsWriteDesc& desc) {
    const FlgResult result = flgColumnsWrite(&desc);
    return detail::done(result);
}

/// [any thread] Writes indices of triangles: `index_count`, 3 each. Errors: FLG_ERROR_INVALID_ARGUMENT as above;
/// FLG_ERROR_LIMIT for indices that the format cannot hold: 65534 is the largest of UINT16, 2^32 - 2 of UINT32.
/// Cost: one pass to check and one to write, below 1 ns an index.
/// Calls flgIndicesWrite.
inline Result<bool> indices_write(Span<const uint32_t> indices, const BufferOutput& output) {
    const FlgResult result = flgIndicesWrite(indices.data(), detail::count(indices.size()), &output);
    return detail::done(result);
}

/// Finds limbs, capsules and limits of a skeleton. Of several trees it looks at the largest; the others are
/// FLG_LIMB_OTHER.
///   out_joints  one per joint
///   out_rig     refers to out_joints and the descriptor's arrays
/// Legs reach down to the ground and lie beside the middle; seen from the side, they hang. Arms are the longest
/// pair of mirrored limbs that is left, near the trunk; the head is the thickest and highest limb in the middle,
/// the tail the longest of the others. Cost: 0.2 us a joint and 20 ns for two tips: 5 ms at most, for 1024 joints
/// of which half are tips. Takes no memory for up to 64 joints, else up to 500 bytes a joint of the C++ runtime's.
/// Calls flgRigFind.
inline Result<Rig> rig_find(const RigFindDesc& desc, FlgRigJoint* out_joints) {
    FlgRig out_rig;
    flgRigInit(&out_rig, detail::size_of<FlgRig>);
    const FlgResult result = flgRigFind(&desc, out_joints, &out_rig);
    return detail::made(result, Rig(out_rig));
}

/// [any thread] As flgErrorGetMessage, for the functions of this header. Sentences start with FILE:PLACE, where
/// PLACE is a line number, a byte offset (`@1234`), a part of the file's structure or an argument; with FILE alone
/// if the whole file is meant, such as when it cannot be opened.
/// Calls flgIoErrorGetMessage.
inline const char* io_error_message() {
    return flgIoErrorGetMessage();
}

/// Writes a motion to .glb, completely or not at all, as flgCurveFileWrite: one node, with the mesh and the camera
/// if given, and an animation with one translation and rotation per position; both interpolate linearly in between
/// (LINEAR). Without an animation the node stands at the first pose. Rotations of poses may be off by 0.001;
/// quaternions have length 1, to float precision, and consecutive ones are in the same hemisphere. Cost: about 1 us
/// a position, and what the mesh takes. Errors: FLG_ERROR_INVALID_ARGUMENT (also for poses that are no rotations),
/// FLG_ERROR_FORMAT for another extension, FLG_ERROR_FILE, FLG_ERROR_LIMIT (2 GiB).
/// Calls flgMotionFileWrite.
inline Result<bool> motion_file_write(const char* path, const MotionFileWriteDesc& desc) {
    const FlgResult result = flgMotionFileWrite(path, &desc);
    return detail::done<flgIoErrorGetMessage>(result);
}

/// [any thread] The name of a tangle operator in documents and scripts, such as "contour", by FlgTangleOperator
/// value. Null beyond the last one. A static string. Cost: nanoseconds.
/// Calls flgTangleOperatorGetName.
inline const char* tangle_operator_name(uint32_t number) {
    return flgTangleOperatorGetName(number);
}

/// [any thread] Likewise for a macro, such as "sunburst", by FlgTangleMacro value. Cost: nanoseconds.
/// Calls flgTangleMacroGetName.
inline const char* tangle_macro_name(uint32_t number) {
    return flgTangleMacroGetName(number);
}

/// The names of formulas, from index 0 on; null beyond the last one. Static strings.
/// Calls flgFormulaGetName.
inline const char* formula_name(uint32_t number) {
    return flgFormulaGetName(number);
}

/// [any thread] As flgErrorGetMessage, for the functions of this header.
/// Calls flgPickErrorGetMessage.
inline const char* pick_error_message() {
    return flgPickErrorGetMessage();
}

/// [any thread] Where handles are at a time, for FlgPullHandle::position: at their keys exactly, smooth in between
/// (velocities are continuous), at rest where two keys are at one place; before the first key and after the last
/// where these are. `out_positions`: 3 per handle, metres. The same for the same keys, so a record can be played
/// again, at any rate: the mesh too is the same if its frames are at the same times. Cost: 0.1 us a handle, and
/// checking all keys.
/// Calls flgPullKeysSample.
inline Result<bool> pull_keys_sample(const PullKeys& keys, double time, float* out_positions) {
    const FlgResult result = flgPullKeysSample(&keys, time, out_positions);
    return detail::done(result);
}

#ifdef FILIGREE_NO_EXCEPTIONS
}  // namespace no_exceptions
#endif
}  // namespace filigree

#endif
