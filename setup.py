# SPDX-License-Identifier: LGPL-2.1-or-later
"""Builds the wheel of the package `swept_volume` and its compiled core `_swept`, without FreeCAD.

    python3 -m pip wheel --no-build-isolation --no-deps --wheel-dir out .

CMake builds the core. Where the wheel is installed, it needs numpy and the system libraries that README.md
names (TBB, OpenMesh, FCL). `.ci/wheel` makes wheels that need only the C library and numpy.
Environment variables: CMAKE_ARGS is passed to CMake. If SWEPT_MODULE is the path of a compiled module,
nothing is built, and the wheel gets this module unchanged (.ci/foreign-wheel).
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
(ROOT / "build-wheel").mkdir(exist_ok=True)
MODULE = os.environ.get("SWEPT_MODULE")


class CMakeBuild(build_ext):
    def get_ext_filename(self, name):
        return pathlib.Path(MODULE).name if MODULE else super().get_ext_filename(name)

    def build_extension(self, extension):
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        if MODULE:
            target.write_bytes(pathlib.Path(MODULE).read_bytes())
            return
        folder = ROOT / "build-wheel"
        # The libraries of the core are the same for every Python, so only the module is built again.
        fresh = "-U *[Pp]ython* -U *PYTHON*"  # removes what CMake has cached about another Python
        subprocess.check_call(
            f"cmake -S . -B build-wheel -G Ninja {fresh}".split()
            + ["-DCMAKE_BUILD_TYPE=Release", "-DSWEPT_STEP=OFF", "-DSWEPT_TESTS=OFF"]
            + [f"-DPython3_EXECUTABLE={sys.executable}"]
            + [f"-DPython3_INCLUDE_DIR={sysconfig.get_path('include')}"]
            + shlex.split(os.environ.get("CMAKE_ARGS", "")),
            cwd=ROOT,
        )
        subprocess.check_call(["cmake", "--build", str(folder), "--target", "_swept"])
        target.write_bytes((folder / "python" / target.name).read_bytes())


setup(
    name="swept-volume",
    version=re.search("<version>(.*)</version>", (ROOT / "package.xml").read_text("utf-8"))[1],
    description="Envelopes of moving solids: meshes and motions in, closed meshes out",
    license="LGPL-2.1-or-later",
    python_requires=">=3.9",
    install_requires=["numpy", "tomli; python_version < '3.11'"],
    packages=["swept_volume"],
    package_dir={"": "python"},
    package_data={"swept_volume": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("_swept", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={
        "build": {"build_base": "build-wheel/setuptools"},
        "egg_info": {"egg_base": "build-wheel"},
    },
)
