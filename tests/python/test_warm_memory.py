# SPDX-License-Identifier: LGPL-2.1-or-later
"""Memory that is allocated before a large copy: the copy then needs no new pages."""
import os
import subprocess
import sys

import pytest

PROGRAM = """
import ctypes, resource, threading
import _swept
SIZE = 100 << 20
libc = ctypes.CDLL(None)
libc.malloc.restype, libc.malloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t]
libc.free.argtypes = [ctypes.c_void_p]

def fresh_pages():
    before = resource.getrusage(resource.RUSAGE_THREAD).ru_minflt
    block = libc.malloc(SIZE)
    ctypes.memset(block, 1, SIZE)
    after = resource.getrusage(resource.RUSAGE_THREAD).ru_minflt
    libc.free(block)
    return after - before

cold = fresh_pages()
warm = _swept.WarmMemory(SIZE + (1 << 20))
assert warm.bytes == SIZE + (1 << 20)
thread = threading.Thread(target=warm.touch)
thread.start()
thread.join()
warm.release()
warm.release()  # once more is no harm
print(cold, fresh_pages())
del warm
small = _swept.WarmMemory(1000)
small.touch()
assert small.bytes == 0
"""


@pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="the memory of other systems is not known"
)
def test_a_copy_into_warm_memory_takes_no_fresh_pages():
    import _swept

    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        env=dict(os.environ, PYTHONPATH=os.path.dirname(_swept.__file__)),
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    cold, warm = map(int, done.stdout.split())
    assert cold > 20000, "the machine has other pages: nothing is measured"
    assert warm < 100, warm
