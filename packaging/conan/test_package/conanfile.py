"""Builds the README's examples against the package, and runs them."""
import os

from conan import ConanFile
from conan.tools.build import can_run
from conan.tools.cmake import CMake, cmake_layout
from conan.tools.files import copy


class TestPackage(ConanFile):
    settings = "os", "arch", "compiler", "build_type"
    generators = "CMakeDeps", "CMakeToolchain"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        cmake_layout(self)

    def build(self):
        examples = os.path.join(self.recipe_folder, os.pardir, os.pardir, os.pardir, "examples")
        for name in ("hello.cpp", "hello.c"):
            copy(self, name, examples, self.build_folder)
        cmake = CMake(self)
        cmake.configure(variables={"EXAMPLES": self.build_folder.replace("\\", "/")})
        cmake.build()

    def test(self):
        if can_run(self):
            for name in ("hello_cpp", "hello_c"):
                self.run(os.path.join(self.cpp.build.bindir, name), env="conanrun")
