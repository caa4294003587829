# SPDX-License-Identifier: MIT
# The port takes the checkout that it lies in; one in a registry would fetch a release here.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS
    FEATURES
        io FLG_BUILD_IO
        pick FLG_BUILD_PICK
)
vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        ${FEATURE_OPTIONS}
        -DFLG_BUILD_RENDERER=OFF
        -DFLG_BUILD_TOOLS=OFF
        -DFLG_BUILD_SAMPLES=OFF
        -DFLG_BUILD_TESTS=OFF
        -DFLG_WARNINGS_AS_ERRORS=OFF
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/filigree)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
# A build makes both forms of each library, and a host takes filigree::filigree or filigree::static.
set(VCPKG_POLICY_DLLS_IN_STATIC_LIBRARY enabled)

file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
file(GLOB licences "${CURRENT_PACKAGES_DIR}/share/doc/filigree/licences/*.txt")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" ${licences})
