//@ head
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

//@ CurveSetView
    /// An attribute of all points, `components` floats each: `rows<3>(FLG_ATTRIBUTE_POSITION)`. Empty without such a
    /// column.
    template <std::size_t components>
    Rows<components> rows(FlgAttribute attribute) const {
        return Rows<components>(column(attribute), curve_offsets.empty() ? 0 : curve_offsets[curve_count]);
    }

//@ MeshView
    /// An attribute of all vertices, `components` floats each: `rows<3>(FLG_ATTRIBUTE_POSITION)`. Empty without such a
    /// column.
    template <std::size_t components>
    Rows<components> rows(FlgAttribute attribute) const {
        return Rows<components>(column(attribute), vertex_count);
    }

//@ Job
    /// Whether it is published, with whatever result.
    Result<bool> finished() const {
        FlgJobStatus status;
        flgJobStatusInit(&status, detail::size_of<FlgJobStatus>);
        const FlgResult result = flgJobGetStatus(context_, handle_, &status);
        return detail::made(result, status.state == FLG_JOB_STATE_FINISHED);
    }

//@ StraightSkeleton
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

//@ tail

#ifdef FILIGREE_NO_EXCEPTIONS
}  // namespace no_exceptions
#endif
}  // namespace filigree

#endif
