// SPDX-License-Identifier: MIT
// A DLL by MinGW has a C++ runtime of its own, which keeps 72 KB for exceptions thrown when there is no memory, and
// never gives them back: without this each load and unload would leak them. Part of the shared library only, where
// nobody else uses that runtime, and nothing throws any more when the object that was constructed first is destroyed.

namespace __gnu_cxx {
void __freeres() noexcept;  // libstdc++'s, declared in none of its headers
}

namespace {

struct Unload {
    ~Unload() { __gnu_cxx::__freeres(); }
};
[[gnu::init_priority(101)]] Unload unload;

}  // namespace
