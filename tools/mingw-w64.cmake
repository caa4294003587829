# SPDX-License-Identifier: MIT
# Windows, by mingw-w64 with POSIX threads (std::thread needs them); tests run under wine where that is installed.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
# Tests bring the compiler's runtime along, as the library does.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
find_program(FLG_WINE NAMES wine64 wine PATHS /usr/lib/wine NO_CMAKE_FIND_ROOT_PATH)
if(FLG_WINE)
    # In a drive C: of the build's own, quiet, without a screen, .NET or a browser.
    set(FLG_WINE_DRIVE ${CMAKE_BINARY_DIR}/wine CACHE PATH "Wine's drive C: and settings")
    set(CMAKE_CROSSCOMPILING_EMULATOR ${CMAKE_COMMAND} -E env WINEPREFIX=${FLG_WINE_DRIVE} WINEDEBUG=-all
        WINEDLLOVERRIDES=mscoree,mshtml,winemenubuilder.exe= DISPLAY= ${FLG_WINE})
endif()
