// SPDX-License-Identifier: MIT
#include <dirent.h>
#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "process.h"

namespace {

int entries(const char* path) {
    DIR* const folder = opendir(path);
    int count = 0;
    if (!folder) FAIL("%s can't be read", path);
    while (readdir(folder)) ++count;
    closedir(folder);
    return count;
}

}  // namespace

void* load(const std::string& path) {
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) FAIL("%s", dlerror());
    return library;
}

void unload(void* library) {
    if (dlclose(library) != 0) FAIL("%s", dlerror());
}

void* symbol(void* library, const char* name) {
    void* const found = dlsym(library, name);
    if (!found) FAIL("%s", dlerror());
    return found;
}

bool is_loaded(const std::string& file_name) {
    std::FILE* const maps = std::fopen("/proc/self/maps", "r");
    if (!maps) FAIL("/proc/self/maps can't be read");
    char line[4096];
    bool found = false;
    while (std::fgets(line, sizeof line, maps)) found = found || std::strstr(line, file_name.c_str()) != nullptr;
    std::fclose(maps);
    return found;
}

int thread_count() {
    return entries("/proc/self/task");
}

int open_file_count() {
    return entries("/proc/self/fd");
}

long resident_bytes() {
    std::FILE* const file = std::fopen("/proc/self/statm", "r");
    long whole = 0, resident = 0;
    if (!file || std::fscanf(file, "%ld %ld", &whole, &resident) != 2) FAIL("/proc/self/statm can't be read");
    std::fclose(file);
    return resident * sysconf(_SC_PAGESIZE);
}
