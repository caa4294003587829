// SPDX-License-Identifier: MIT
// What the system knows of this process, and libraries loaded into it at run time.
#pragma once

#include <string>

#define FAIL(...) (std::fprintf(stderr, __VA_ARGS__), std::fputc('\n', stderr), std::exit(1))

// All of these end the program with a sentence if the system refuses.
void* load(const std::string& path);
void unload(void* library);
void* symbol(void* library, const char* name);
bool is_loaded(const std::string& file_name);

int thread_count();
int open_file_count();  // with whatever else the system keeps a handle of
long resident_bytes();
