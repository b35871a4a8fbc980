# SPDX-License-Identifier: Apache-2.0
"""Where and with what the measurements were made, and what else the machine did meanwhile."""

import hashlib
import json
import os
import platform
import re
import subprocess
import time
from pathlib import Path

from harness.problems import BIN, ROOT

PROGRAMS = ("krait-bench-search", "krait-bench-peers", "krait-bench-core", "krait")


def digest_of_programs():
    """Names what the runs of a journal depend on."""
    digest = hashlib.sha256()
    for program in PROGRAMS:
        if (BIN / program).exists():
            digest.update((BIN / program).read_bytes())
    return digest.hexdigest()[:12]


def processor():
    text = Path("/proc/cpuinfo").read_text()
    match = re.search(r"^model name\s*: (.*)$", text, re.MULTILINE)
    return match.group(1) if match else platform.machine()


def identity():
    """The same for two sessions on one machine, and no machine's name."""
    path = Path("/etc/machine-id")
    name = path.read_text() if path.exists() else platform.node()
    return hashlib.sha256((name + processor()).encode()).hexdigest()[:8]


def commit():
    result = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT, capture_output=True, text=True)
    return result.stdout.strip() or "unknown"


def describe(core):
    built = subprocess.run([BIN / "krait-bench-peers", "build"], check=True, capture_output=True, text=True)
    return {
        "machine": identity(),
        "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "processor": processor(),
        "cores": os.cpu_count(),
        "pinned_to_core": core,
        "load_before": round(os.getloadavg()[0], 2),
        "system": f"{platform.system()} {platform.release()}",
        "commit": commit(),
        "programs": digest_of_programs(),
        **json.loads(built.stdout),
    }


class Activity:
    """What else happened on a core since this was made."""

    def __init__(self, core):
        self._line = f"cpu{core} "
        self._stolen = self._read()

    def _read(self):
        for line in Path("/proc/stat").read_text().splitlines():
            if line.startswith(self._line):
                return int(line.split()[8])
        return 0

    def seen(self):
        """The load of the machine over the last minute, and, where a hypervisor took time from the core, how much."""
        stolen = (self._read() - self._stolen) / os.sysconf("SC_CLK_TCK")
        return {"load": round(os.getloadavg()[0], 2)} | ({"stolen_s": round(stolen, 2)} if stolen else {})
