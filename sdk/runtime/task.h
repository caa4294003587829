// SPDX-License-Identifier: MIT
// Task<T>: a coroutine that reads top to bottom as the algorithm in its paper, and that its caller awaits.
//
// Invariants
// - A task starts when it is awaited and hands control straight back to whoever awaited it when it is done (symmetric
//   transfer: chains of tasks use no stack).
// - Its frame comes from the memory of its Pace, which is the first parameter of every task.
// - What it throws is thrown again in whoever awaits it.
// - Destroying a suspended task destroys the tasks it awaits with it: that is how cancellation frees everything.
#pragma once

#include <coroutine>
#include <cstddef>
#include <exception>
#include <optional>
#include <utility>

#include "core/memory.h"

namespace flg {

class Pace;

// The memory that the frames of a pace's tasks come from (here and not in pace.h, which needs this file).
Memory* frame_memory(Pace& pace);

namespace detail {

class PromiseBase {
public:
    template <class... Arguments>
    static void* operator new(size_t size, Pace& pace, Arguments&&...) {
        Memory* memory = frame_memory(pace);
        auto* block = static_cast<std::byte*>(memory->allocate(size + header_size, header_size));
        *reinterpret_cast<Memory**>(block) = memory;
        return block + header_size;
    }
    static void operator delete(void* frame, size_t size) {
        auto* block = static_cast<std::byte*>(frame) - header_size;
        (*reinterpret_cast<Memory**>(block))->deallocate(block, size + header_size, header_size);
    }

    std::suspend_always initial_suspend() const noexcept { return {}; }

    struct HandBack {
        bool await_ready() const noexcept { return false; }
        template <class Promise>
        std::coroutine_handle<> await_suspend(std::coroutine_handle<Promise> finished) const noexcept {
            return finished.promise().continuation;
        }
        void await_resume() const noexcept {}
    };
    HandBack final_suspend() const noexcept { return {}; }

    void unhandled_exception() noexcept { exception = std::current_exception(); }

    std::coroutine_handle<> continuation = std::noop_coroutine();
    std::exception_ptr exception;

private:
    static constexpr size_t header_size = alignof(std::max_align_t);  // holds the Memory*, keeps the frame aligned
};

template <class T>
class Promise : public PromiseBase {
public:
    void return_value(T result) { value.emplace(std::move(result)); }
    T take() { return std::move(*value); }
    std::optional<T> value;
};

template <>
class Promise<void> : public PromiseBase {
public:
    void return_void() const noexcept {}
    void take() const noexcept {}
};

}  // namespace detail

template <class T = void>
class [[nodiscard]] Task {
public:
    struct promise_type : detail::Promise<T> {
        Task get_return_object() { return Task(std::coroutine_handle<promise_type>::from_promise(*this)); }
    };

    Task() = default;
    Task(Task&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Task& operator=(Task&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Task() { reset(); }

    void reset() {
        if (handle_) std::exchange(handle_, nullptr).destroy();
    }
    bool done() const { return handle_.done(); }
    std::coroutine_handle<> handle() const { return handle_; }
    // What it threw, once it is done.
    std::exception_ptr exception() const { return handle_.promise().exception; }
    // What it returned, once it is done; throws what it threw.
    T result() {
        if (exception()) std::rethrow_exception(exception());
        return handle_.promise().take();
    }

    auto operator co_await() && noexcept {
        struct Awaiter {
            std::coroutine_handle<promise_type> task;
            bool await_ready() const noexcept { return false; }
            std::coroutine_handle<> await_suspend(std::coroutine_handle<> awaiting) const noexcept {
                task.promise().continuation = awaiting;
                return task;
            }
            T await_resume() const {
                if (task.promise().exception) std::rethrow_exception(task.promise().exception);
                return task.promise().take();
            }
        };
        return Awaiter{handle_};
    }

private:
    explicit Task(std::coroutine_handle<promise_type> handle) : handle_(handle) {}
    std::coroutine_handle<promise_type> handle_;
};

}  // namespace flg
