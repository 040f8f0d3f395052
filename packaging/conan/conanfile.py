# SPDX-License-Identifier: Apache-2.0
import os

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rmdir
from conan.tools.microsoft import is_msvc

required_conan_version = ">=2.0"


class VesicaConan(ConanFile):
    name = "vesica"
    description = "Exact overlap queries between plain 2D shapes"
    license = "Apache-2.0"
    url = "https://vesica.example.org"
    homepage = "https://vesica.example.org"
    topics = ("geometry", "collision-detection", "exact-predicates")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}
    implements = ["auto_shared_fpic"]

    def layout(self):
        cmake_layout(self, src_folder="src")

    def validate(self):
        check_min_cppstd(self, 20)
        if is_msvc(self):
            raise ConanInvalidConfiguration(f"{self.ref} needs g++ or clang++")

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["VESICA_PROGRAMS"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()
        for folder in ("lib/cmake", "lib/pkgconfig", "share"):
            rmdir(self, os.path.join(self.package_folder, folder))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "vesica")
        for component, library in (("vesica", "vesica"), ("methods", "vesica-methods")):
            info = self.cpp_info.components[component]
            info.set_property("cmake_target_name", f"vesica::{component}")
            info.set_property("pkg_config_name", library)
            info.libs = [library]
            if self.settings.os in ("Linux", "FreeBSD"):
                info.system_libs = ["m"]
        self.cpp_info.components["methods"].requires = ["vesica"]
        core = self.cpp_info.components["core"]
        core.set_property("cmake_target_name", "vesica::core")
        core.libdirs = core.bindirs = []
