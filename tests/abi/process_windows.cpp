// SPDX-License-Identifier: MIT
#include <windows.h>

// They need it before them.
#include <psapi.h>
#include <tlhelp32.h>

#include <cstdio>
#include <cstdlib>

#include "process.h"

#define FAIL_WITH_LAST_ERROR(what) FAIL("%s: error %lu", what, GetLastError())

void* load(const std::string& path) {
    const HMODULE library = LoadLibraryA(path.c_str());
    if (!library) FAIL_WITH_LAST_ERROR(path.c_str());
    return library;
}

void unload(void* library) {
    if (!FreeLibrary(static_cast<HMODULE>(library))) FAIL_WITH_LAST_ERROR("FreeLibrary");
}

void* symbol(void* library, const char* name) {
    const FARPROC found = GetProcAddress(static_cast<HMODULE>(library), name);
    if (!found) FAIL_WITH_LAST_ERROR(name);
    return reinterpret_cast<void*>(found);
}

bool is_loaded(const std::string& file_name) {
    return GetModuleHandleA(file_name.c_str()) != nullptr;
}

int thread_count() {
    const HANDLE threads = CreateToolhelp32Snapshot(TH32CS_SNAPTHREAD, 0);
    if (threads == INVALID_HANDLE_VALUE) FAIL_WITH_LAST_ERROR("CreateToolhelp32Snapshot");
    THREADENTRY32 thread{};
    thread.dwSize = sizeof thread;
    int count = 0;
    for (BOOL is_one = Thread32First(threads, &thread); is_one; is_one = Thread32Next(threads, &thread)) {
        if (thread.th32OwnerProcessID == GetCurrentProcessId()) ++count;
    }
    CloseHandle(threads);
    return count;
}

int open_file_count() {
    DWORD count = 0;
    if (!GetProcessHandleCount(GetCurrentProcess(), &count)) FAIL_WITH_LAST_ERROR("GetProcessHandleCount");
    return static_cast<int>(count);
}

long resident_bytes() {
    PROCESS_MEMORY_COUNTERS counters{};
    if (!GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters)) {
        FAIL_WITH_LAST_ERROR("GetProcessMemoryInfo");
    }
    return static_cast<long>(counters.WorkingSetSize);
}
