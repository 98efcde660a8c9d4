# SPDX-License-Identifier: LGPL-2.1-or-later
"""A package index on this machine. It serves the built core as the package swept-volume, and other wheels
such as numpy, which pip fetches for it. Needs neither FreeCAD nor the core, and also runs inside FreeCAD's
process.
"""
import base64
import hashlib
import http.server
import os
import signal
import sys
import threading
import zipfile

TAG = "cp{0}{1}-cp{0}{1}-linux_x86_64".format(*sys.version_info[:2])


def make_wheel(build, version, folder):
    """Packs the core from a folder of the build into a wheel. Returns its path."""
    path = os.path.join(folder, "swept_volume-{}-{}.whl".format(version, TAG))
    info = "swept_volume-{}.dist-info/".format(version)
    files = {}
    for base, _, names in os.walk(build):
        for name in names:
            whole = os.path.join(base, name)
            if "__pycache__" not in whole and name != "copied":
                with open(whole, "rb") as file:
                    files[os.path.relpath(whole, build)] = file.read()
    text = "Metadata-Version: 2.1\nName: swept-volume\nVersion: {}\n".format(version)
    files[info + "METADATA"] = text.encode()
    text = "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: false\nTag: {}\n".format(TAG)
    files[info + "WHEEL"] = text.encode()
    record = ""
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
        record += "{},sha256={},{}\n".format(name, digest, len(data))
    files[info + "RECORD"] = (record + info + "RECORD,,\n").encode()
    with zipfile.ZipFile(path, "w") as wheel:
        for name, data in files.items():
            wheel.writestr(name, data)
    return path


class Index(http.server.ThreadingHTTPServer):
    """Serves the files of a folder. Downloads of packages wait until `may_download` is set."""

    def __init__(self, folder):
        super().__init__(("127.0.0.1", 0), _Handler)
        # Since 1.0, a broken pipe ends FreeCAD. This happens here when pip is stopped during a
        # download.
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)
        self.folder, self.requests, self.may_download = folder, [], threading.Event()
        self.may_download.set()
        self.daemon_threads = True
        self.address = "http://127.0.0.1:{}".format(self.server_address[1])
        threading.Thread(target=self.serve_forever, daemon=True).start()

    def environment(self):
        """Returns the environment variables with which pip uses this index only."""
        gone = ("PIP_FIND_LINKS", "PIP_NO_INDEX", "PIP_EXTRA_INDEX_URL", "PYTHONPATH", "SWEPT_CORE")
        kept = {name: value for name, value in os.environ.items() if name not in gone}
        for name in ("no_proxy", "NO_PROXY"):
            kept[name] = "127.0.0.1"
        return dict(kept, PIP_INDEX_URL=self.address + "/simple", PIP_CONFIG_FILE=os.devnull)


class _Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):  # noqa: N802
        self.server.requests.append(self.path)
        name = os.path.basename(self.path.rstrip("/"))
        whole = os.path.join(self.server.folder, name)
        if self.path.startswith("/simple/"):
            wheels = [n for n in sorted(os.listdir(self.server.folder)) if n.endswith(".whl")]
            names = [n for n in wheels if n.split("-")[0].replace("_", "-") == name]
            links = ['<a href="/{0}">{0}</a>'.format(n) for n in names]
            self._send("<html>{}</html>".format("\n".join(links)).encode(), "text/html")
        elif os.path.isfile(whole):
            self.server.may_download.wait(300)
            with open(whole, "rb") as file:
                self._send(file.read(), "application/zip")
        else:
            self.send_error(404)

    def _send(self, data, kind):
        try:
            self.send_response(200)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)
        except (BrokenPipeError, ConnectionResetError):
            pass  # pip was stopped

    def log_message(self, *words):
        pass
