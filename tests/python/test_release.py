# SPDX-License-Identifier: LGPL-2.1-or-later
"""The source archive of `.ci/release`, its quickest part: the same commit gives the same bytes."""
import hashlib
import os
import re
import shutil
import subprocess
import tarfile

import pytest


@pytest.fixture(scope="module")
def clone(root, tmp_path_factory):
    """Returns a copy of the last commit, so that changes of the working tree do not matter."""
    folder = tmp_path_factory.mktemp("clone") / "tree"
    done = subprocess.run(["git", "clone", "-q", str(root), str(folder)], capture_output=True)
    if done.returncode != 0 or not shutil.which("gzip"):
        pytest.skip("not a git checkout")
    return folder


def release(clone, target, **changed):
    return subprocess.run(
        [str(clone / ".ci/release"), "source"],
        env={**os.environ, "SWEPT_RELEASE": str(target), **changed},
        capture_output=True,
        text=True,
    )


def files_in(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_a_release_is_the_same_bytes_again_and_is_named_after_its_version(clone, tmp_path):
    for place, zone in (("one", "UTC"), ("two", "Asia/Tokyo")):
        done = release(clone, tmp_path / place, TZ=zone)
        assert done.returncode == 0, done.stdout + done.stderr
    made = files_in(tmp_path / "one")
    assert made == files_in(tmp_path / "two")
    version = re.search("<version>(.*)</version>", (clone / "package.xml").read_text())[1]
    name = f"swept-volume-{version}"
    assert set(made) == {f"{name}.tar.gz", "SHA256SUMS"}
    digest = hashlib.sha256(made[f"{name}.tar.gz"]).hexdigest()
    assert made["SHA256SUMS"].decode() == f"{digest}  {name}.tar.gz\n"
    with tarfile.open(tmp_path / f"one/{name}.tar.gz") as archive:
        assert f"<version>{version}</version>".encode() in (
            archive.extractfile(f"{name}/package.xml").read()
        )
        assert all(member.name.split("/")[0] == name for member in archive)


def test_a_version_without_its_entry_in_the_changelog_is_refused(clone, tmp_path):
    shutil.copytree(clone, tmp_path / "tree")
    package = tmp_path / "tree/package.xml"
    text = re.sub("<version>.*</version>", "<version>9.9.9</version>", package.read_text())
    package.write_text(text)
    done = release(tmp_path / "tree", tmp_path / "out")
    assert done.returncode != 0 and "not committed" in done.stderr
    git = ["git", "-C", str(tmp_path / "tree"), "-c", "user.name=t", "-c", "user.email=t@localhost"]
    subprocess.run(git + ["commit", "-qam", "next"], check=True)
    done = release(tmp_path / "tree", tmp_path / "out")
    assert done.returncode != 0 and "no section [9.9.9]" in done.stderr
    assert not (tmp_path / "out").exists()


def test_the_version_stands_in_one_place(root):
    """All other files read the version from package.xml. The changelog and published releases keep
    older versions."""
    version = re.search("<version>(.*)</version>", (root / "package.xml").read_text("utf-8"))[1]
    for name in (
        "CMakeLists.txt",
        "setup.py",
        "pyproject.toml",
        "workbench/sweptvolume/__init__.py",
    ):
        assert version not in (root / name).read_text(encoding="utf-8"), name
