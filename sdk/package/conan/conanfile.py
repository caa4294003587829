# SPDX-License-Identifier: MIT
"""Filigree for Conan 2, from the checkout that this recipe lies in: `conan create sdk/package/conan`."""
import os
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class FiligreeConan(ConanFile):
    name = "filigree"
    description = "Real-time expressive curves for engines"
    license = "MIT"
    topics = ("curves", "strokes", "graphics", "geometry")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    # A build makes both forms of each library: there is no option `shared`.
    options = {"io": [True, False], "pick": [True, False]}
    default_options = {"io": True, "pick": False}

    def _checkout(self):
        return os.path.normpath(os.path.join(self.recipe_folder, "..", "..", ".."))

    def set_version(self):
        text = load(self, os.path.join(self._checkout(), "CMakeLists.txt"))
        self.version = re.search(r"project\(filigree VERSION ([0-9.]+)", text).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "sdk/*", "tools/unity/*"):
            copy(self, pattern, src=self._checkout(), dst=self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/3.4.0")
        if self.options.io:
            self.requires("zlib/[>=1.2.11 <2]")
        if self.options.pick:
            self.requires("embree3/3.13.5")

    def validate(self):
        check_min_cppstd(self, 20)
        if self.settings.compiler not in ("gcc", "clang"):
            raise ConanInvalidConfiguration("filigree needs GCC or Clang")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in ("RENDERER", "TOOLS", "SAMPLES", "TESTS"):
            toolchain.cache_variables[f"FLG_BUILD_{part}"] = False
        toolchain.cache_variables["FLG_BUILD_IO"] = bool(self.options.io)
        toolchain.cache_variables["FLG_BUILD_PICK"] = bool(self.options.pick)
        toolchain.cache_variables["FLG_WARNINGS_AS_ERRORS"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        copy(self, "*.txt", src=os.path.join(self.source_folder, "sdk", "package", "licences"),
             dst=os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        # The package's own filigree-config.cmake, with a component a target.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs.append(os.path.join("lib", "cmake", "filigree"))
