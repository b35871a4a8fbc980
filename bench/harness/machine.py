# SPDX-License-Identifier: Apache-2.0
"""Where and with what the measurements were made."""

import hashlib
import json
import os
import platform
import re
import subprocess
import time
from pathlib import Path

from harness.problems import BIN, ROOT


def file_digest(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def build_of(program, problem):
    """Names what a run depends on: the program and the compiled scene."""
    return hashlib.sha256((file_digest(program) + problem.digest).encode()).hexdigest()[:12]


def processor():
    text = Path("/proc/cpuinfo").read_text()
    match = re.search(r"^model name\s*: (.*)$", text, re.MULTILINE)
    return match.group(1) if match else platform.machine()


def commit():
    asked = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT, capture_output=True, text=True)
    return asked.stdout.strip() or "unknown"


def describe(cores):
    built = subprocess.run([BIN / "krait-bench-search", "build"], check=True, capture_output=True, text=True)
    return {
        "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "processor": processor(),
        "cores": os.cpu_count(),
        "pinned_to_cores": cores,
        "load_before": round(os.getloadavg()[0], 2),
        "system": f"{platform.system()} {platform.release()}",
        "commit": commit(),
        **json.loads(built.stdout),
    }


def cores_described(sessions):
    """How many the last session's machine has, and those that timed programs of any session were pinned to."""
    text = f"{sessions[-1]['cores']} cores"
    pinned = sorted({core for session in sessions for core in session.get("pinned_to_cores", [])})
    if len(pinned) == 1:
        text += f", core {pinned[0]} for the timed program"
    elif pinned:
        text += f", cores {', '.join(map(str, pinned[:-1]))} and {pinned[-1]} for timed programs, one each"
    return text
