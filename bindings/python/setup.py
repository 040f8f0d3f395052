# SPDX-License-Identifier: Apache-2.0
"""Builds the C library by cmake, of the repository that this folder is in, and puts it inside the package; and writes
the declarations."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent


def version():
    text = (REPOSITORY / "capi" / "include" / "vesica.h").read_text()
    return ".".join(re.search(rf"#define VESICA_VERSION_{part} (\d+)", text)[1] for part in ("MAJOR", "MINOR", "PATCH"))


class BuildWithLibrary(build_py):
    def run(self):
        subprocess.check_call([sys.executable, "-B", REPOSITORY / "bindings" / "declare", "python"])
        super().run()
        build = pathlib.Path(os.environ.get("VESICA_BUILD") or self.get_finalized_command("build").build_temp).resolve()
        if "VESICA_BUILD" not in os.environ:  # a build folder of cmake's that has the library
            subprocess.check_call(["cmake", "-S", REPOSITORY, "-B", build, "-DCMAKE_BUILD_TYPE=Release"])
            subprocess.check_call(["cmake", "--build", build, "--target", "vesica", "--parallel"])
        library = pathlib.Path(self.build_lib, "vesica", "libvesica.so.0")
        shutil.copy(build / "capi" / library.name, library)
        subprocess.check_call(["strip", "--strip-unneeded", library])


class PlatformWheel(bdist_wheel):
    """For one platform, as the library is, and for any Python, as ctypes is."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(version=version(), cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel})
