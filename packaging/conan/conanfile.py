"""The recipe of Tamis for Conan 2: `conan create packaging/conan`. scripts/test_conan.sh runs it without a remote."""
import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir

required_conan_version = ">=2.0"


class Tamis(ConanFile):
    name = "tamis"
    description = "Finds every contact between moving, deforming triangle meshes, and proves all other pairs free"
    license = "MIT"
    topics = ("collision-detection", "ccd", "geometry", "simulation")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "with_tbb": [True, False]}
    default_options = {"shared": False, "fPIC": True, "with_tbb": False}
    implements = ["auto_shared_fpic"]

    def _root(self):
        return os.path.join(self.recipe_folder, os.pardir, os.pardir)

    def set_version(self):
        text = load(self, os.path.join(self._root(), "CMakeLists.txt"))
        self.version = re.search(r"project\(tamis VERSION ([\d.]+)", text)[1]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*", "bindings/c/*"):
            copy(self, pattern, self._root(), self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("boost/1.83.0", headers=True, libs=False, visible=False)
        self.requires("xsimd/13.0.0", visible=False)
        if self.options.with_tbb:
            self.requires("onetbb/2021.12.0")

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update({
            "TAMIS_TBB": "ON" if self.options.with_tbb else "OFF",
            "TAMIS_BUILD_C": True, "TAMIS_BUILD_TOOLS": False, "TAMIS_BUILD_LAB": False, "TAMIS_BUILD_MPI": False,
            "TAMIS_BUILD_TESTS": False})
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()
        for folder in (("lib", "cmake"), ("lib", "pkgconfig"), ("share",)):
            rmdir(self, os.path.join(self.package_folder, *folder))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "tamis")
        cpp = self.cpp_info.components["cpp"]
        cpp.set_property("cmake_target_name", "tamis::tamis")
        cpp.set_property("pkg_config_name", "tamis")
        cpp.libs = ["tamis"]
        cpp.requires = ["onetbb::libtbb"] if self.options.with_tbb else []
        c = self.cpp_info.components["c"]
        c.set_property("cmake_target_name", "tamis::tamis_c")
        c.set_property("pkg_config_name", "tamis-c")
        c.libs = ["tamis_c"]
        if self.settings.os in ("Linux", "FreeBSD"):
            cpp.system_libs = ["m", "pthread"]
