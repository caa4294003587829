# SPDX-License-Identifier: MIT
# With CMAKE_UNITY_BUILD, sources are compiled in the groups that tools/unity/groups makes, in a fifth of the time. Off,
# each is compiled alone: for development, where few change at a time. Objects have the same results either way.

# flg_targets_below(<variable> <folder>): the project's targets.
function(flg_targets_below result folder)
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    foreach(below ${folders})
        flg_targets_below(further ${below})
        list(APPEND targets ${further})
    endforeach()
    set(${result} ${targets} PARENT_SCOPE)
endfunction()

# flg_compile_in_groups(): to be called when all targets are there.
function(flg_compile_in_groups)
    # An included source is a header to GCC, where what is unnamed should not be part of what has a name. Clang finds
    # that a variable in a header hides a constant of a source before it.
    target_compile_options(filigree_flags INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>
        $<$<COMPILE_LANG_AND_ID:CXX,Clang>:-Wno-shadow>)
    flg_targets_below(targets ${PROJECT_SOURCE_DIR})
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
    set(lines "")
    foreach(target ${targets})
        set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
        get_target_property(sources ${target} SOURCES)
        get_target_property(folder ${target} SOURCE_DIR)
        foreach(source ${sources})
            if(source MATCHES "\\.cpp$" AND NOT source MATCHES "^\\$<")
                get_filename_component(path ${source} ABSOLUTE BASE_DIR ${folder})
                string(APPEND lines "${target}\t${path}\n")
            endif()
        endforeach()
    endforeach()
    set(list ${PROJECT_BINARY_DIR}/unity_sources.txt)
    file(WRITE ${list} "${lines}")
    execute_process(COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/unity/groups ${list}
        OUTPUT_VARIABLE groups COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "[^\n]+" groups "${groups}")
    foreach(line ${groups})
        string(REPLACE "\t" ";" line "${line}")
        list(GET line 0 target)
        list(GET line 1 number)
        list(GET line 2 path)
        set_source_files_properties(${path} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${number})
    endforeach()
endfunction()
