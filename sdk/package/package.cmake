# SPDX-License-Identifier: MIT
# What `cmake --install` leaves: headers, libraries, the licences of all that is in them, a CMake package with one
# component a target, and pkg-config files. All of it finds itself by relative paths, so that the folder can be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(FLG_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/filigree)

# flg_package(<target> <name>): the target as hosts know it, filigree::<name>, installed as component <name>.
function(flg_package target name)
    add_library(filigree::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/sdk/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "SHARED_LIBRARY")
        set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION}
            SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
        target_link_options(${target} PRIVATE ${FLG_EXPORTS_ONLY})
        if(WIN32)
            set_target_properties(${target} PROPERTIES PREFIX "")  # filigree.dll, as bindings ask for it
        endif()
    else()
        target_compile_definitions(${target} INTERFACE FLG_STATIC)
    endif()
    if(NOT FLG_INSTALL)
        return()
    endif()
    install(TARGETS ${target} EXPORT filigree-${name} RUNTIME COMPONENT runtime LIBRARY COMPONENT runtime
        NAMELINK_COMPONENT development ARCHIVE COMPONENT development)
    install(EXPORT filigree-${name} NAMESPACE filigree:: DESTINATION ${FLG_PACKAGE_DIR} COMPONENT development)
endfunction()

# flg_licences(<name>...): what a library links or has compiled in. licences/<name>.txt is installed beside it.
function(flg_licences)
    if(NOT FLG_INSTALL)
        return()
    endif()
    list(TRANSFORM ARGN REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/sdk/package/licences/\\1.txt" OUTPUT_VARIABLE texts)
    install(FILES ${texts} DESTINATION ${CMAKE_INSTALL_DOCDIR}/licences COMPONENT runtime)
endfunction()

# flg_pkg_config(<name> <description> <requires.private> <libs.private>): <name>.pc for lib<name>.
function(flg_pkg_config name description requires libs)
    if(NOT FLG_INSTALL)
        return()
    endif()
    file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    string(REGEX REPLACE "/$" "" up "${up}")
    configure_file(${PROJECT_SOURCE_DIR}/sdk/package/filigree.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()

function(flg_install_package)
    if(NOT FLG_INSTALL)
        return()
    endif()
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/sdk/include/filigree DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT development)
    # The style library: examples for flgStyleCreate, read by flgCurveFileRead.
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/sdk/data/styles DESTINATION ${CMAKE_INSTALL_DATADIR}/filigree
        COMPONENT runtime)
    # With the licence the list of what else is in the libraries, under which licences.
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/sdk/docs/dependencies.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
    configure_package_config_file(${PROJECT_SOURCE_DIR}/sdk/package/filigree-config.cmake.in
        ${PROJECT_BINARY_DIR}/filigree-config.cmake INSTALL_DESTINATION ${FLG_PACKAGE_DIR}
        NO_SET_AND_CHECK_MACRO)
    # As flgContextCreate has it: while the major version is 0, the minor ones must be equal too.
    write_basic_package_version_file(${PROJECT_BINARY_DIR}/filigree-config-version.cmake COMPATIBILITY SameMinorVersion)
    install(FILES ${PROJECT_BINARY_DIR}/filigree-config.cmake ${PROJECT_BINARY_DIR}/filigree-config-version.cmake
        DESTINATION ${FLG_PACKAGE_DIR} COMPONENT development)
endfunction()
