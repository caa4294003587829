#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The Conan recipe without Conan: runs its methods with stand-ins for Conan's modules.

    conan_recipe.py RECIPE VERSION FOLDER CC CXX

The sources that it exports, alone in a folder, must configure with the variables that it sets; what it requires must be
what the project finds.
"""
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import types

PACKAGES = {"Eigen3": "eigen", "ZLIB": "zlib", "embree": "embree3"}


class Options(dict):
    __getattr__ = dict.__getitem__


class ConanFile:
    def __init__(self, recipe_folder, folder):
        self.recipe_folder = str(recipe_folder)
        self.export_sources_folder = self.source_folder = str(folder / "sources")
        self.package_folder = str(folder / "package")
        self.options = Options(self.default_options)
        self.required = []

    def requires(self, reference):
        self.required.append(reference)


class CMakeToolchain:
    def __init__(self, recipe):
        self.cache_variables = recipe.cache_variables = {}

    def generate(self):
        pass


class CMakeDeps:
    def __init__(self, recipe):
        pass

    def generate(self):
        pass


class CMake:
    def __init__(self, recipe):
        pass

    def install(self):
        pass


def copy(_recipe, pattern, src, dst):
    """As Conan's: the pattern is fnmatch's over whole relative paths, so that * goes through folders."""
    found = list(pathlib.Path(src).rglob("*")) if pattern == "*.txt" else list(pathlib.Path(src).glob(
        pattern.replace("/*", "/**/*")))
    for path in found:
        if path.is_file():
            to = pathlib.Path(dst) / path.relative_to(src)
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, to)
    if not found:
        raise SystemExit(f"the recipe copies {pattern} from {src}, where there is no such file")


def load_recipe(path):
    stand_ins = {
        "conan": {"ConanFile": ConanFile},
        "conan.errors": {"ConanInvalidConfiguration": type("ConanInvalidConfiguration", (Exception,), {})},
        "conan.tools": {},
        "conan.tools.build": {"check_min_cppstd": lambda recipe, standard: None},
        "conan.tools.cmake": {"CMake": CMake, "CMakeDeps": CMakeDeps, "CMakeToolchain": CMakeToolchain,
                              "cmake_layout": lambda recipe: None},
        "conan.tools.files": {"copy": copy, "load": lambda _, file: pathlib.Path(file).read_text(encoding="utf-8")},
    }
    for name, content in stand_ins.items():
        module = types.ModuleType(name)
        module.__dict__.update(content)
        sys.modules[name] = module
    spec = importlib.util.spec_from_file_location("conanfile", path)
    module = importlib.util.module_from_spec(spec)
    sys.dont_write_bytecode = True
    spec.loader.exec_module(module)
    return module


def found_packages(*files):
    names = [name for file in files
             for name in re.findall(r"^find_package\((\w+)", file.read_text(encoding="utf-8"), re.MULTILINE)]
    return sorted(PACKAGES[name] for name in names if name != "Threads")


def check(what, found, wanted):
    if found != wanted:
        raise SystemExit(f"{what}: {found}, not {wanted}")


def main():
    path, version, folder, c_compiler, cxx_compiler = sys.argv[1:]
    path, folder = pathlib.Path(path), pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    module = load_recipe(path)
    root = path.parents[3]
    lists = [root / "CMakeLists.txt", root / "sdk/io/CMakeLists.txt", root / "sdk/pick/CMakeLists.txt"]
    for options, files in (({"io": False, "pick": False}, lists[:1]), ({"io": True, "pick": False}, lists[:2]),
                           ({"io": True, "pick": True}, lists)):
        recipe = module.FiligreeConan(path.parent, folder)
        recipe.options.update(options)
        recipe.set_version()
        check("version", recipe.version, version)
        recipe.requirements()
        check(f"requirements with {options}", sorted(name.split("/")[0] for name in recipe.required),
              found_packages(*files))

    compilers = {"gcc": None, "clang": None, "msvc": module.ConanInvalidConfiguration}
    for compiler, refusal in compilers.items():
        recipe.settings = types.SimpleNamespace(compiler=compiler)
        try:
            recipe.validate()
            check(f"validate() with {compiler}", None, refusal)
        except module.ConanInvalidConfiguration:
            check(f"validate() with {compiler}", module.ConanInvalidConfiguration, refusal)

    recipe.export_sources()
    recipe.layout()
    recipe.generate()
    variables = [f"-D{name}={'ON' if value else 'OFF'}" for name, value in recipe.cache_variables.items()]
    run = subprocess.run(["cmake", "-S", recipe.source_folder, "-B", folder / "build", "-G", "Ninja",
                          "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_C_COMPILER={c_compiler}",
                          f"-DCMAKE_CXX_COMPILER={cxx_compiler}", *variables],
                         check=False, capture_output=True, text=True)
    check("configuring the exported sources", (run.returncode, run.stderr), (0, ""))
    rules = (folder / "build/build.ninja").read_text(encoding="utf-8")
    for library in ("libfiligree.so", "libfiligree_io.so", "libfiligree_pick.so"):
        check(f"{library} is built", library in rules, True)

    recipe.package()
    texts = sorted(text.name for text in pathlib.Path(recipe.package_folder, "licenses").iterdir())
    check("licences", texts, ["LICENSE", "eigen.txt", "embree.txt", "zlib.txt"])
    recipe.cpp_info = types.SimpleNamespace(set_property=lambda *_: None, builddirs=[])
    recipe.package_info()
    check("builddirs", recipe.cpp_info.builddirs, ["lib/cmake/filigree"])


main()
