# SPDX-License-Identifier: Apache-2.0
"""Builds the C library by cmake, of the repository that this folder is in, and puts it inside the package; and writes
the declarations."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent


def version():
    text = (REPOSITORY / "capi" / "include" / "vesica.h").read_text()
    return ".".join(re.search(rf"#define VESICA_VERSION_{part} (\d+)", text)[1] for part in ("MAJOR", "MINOR", "PATCH"))


def build_folder(command):
    """The folder of cmake's that has the library, or gets it."""
    return pathlib.Path(os.environ.get("VESICA_BUILD") or command.get_finalized_command("build").build_temp).resolve()


class BuildWithLibrary(build_py):
    def run(self):
        subprocess.check_call([sys.executable, "-B", REPOSITORY / "bindings" / "declare", "python"])
        super().run()
        build = build_folder(self)
        if "VESICA_BUILD" not in os.environ:
            subprocess.check_call(["cmake", "-S", REPOSITORY, "-B", build, "-DCMAKE_BUILD_TYPE=Release"])
            jobs = str(os.cpu_count() or 1)
            subprocess.check_call(["cmake", "--build", build, "--target", "vesica", "--parallel", jobs])
        library = pathlib.Path(self.build_lib, "vesica", "libvesica.so.0")
        shutil.copy(build / "capi" / library.name, library)
        subprocess.check_call([os.environ.get("STRIP", "strip"), "--strip-unneeded", library])


class WithLibrary(Distribution):
    """Belongs among what is compiled, though nothing is compiled for Python."""

    def has_ext_modules(self):
        return True


class PlatformWheel(bdist_wheel):
    """For one platform, as the library is, and for any Python, as ctypes is."""

    def get_tag(self):
        return "py3", "none", os.environ.get("VESICA_PLATFORM") or super().get_tag()[2]

    def write_wheelfile(self, wheelfile_base, *more, **named):
        super().write_wheelfile(wheelfile_base, *more, **named)
        parts = pathlib.Path(wheelfile_base, "sboms")
        parts.mkdir()
        shutil.copy(build_folder(self) / "vesica.spdx.json", parts)


setup(
    version=version(),
    distclass=WithLibrary,
    cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel},
)
