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
from harness.worker import timing_core


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


def describe():
    built = subprocess.run([BIN / "krait-bench-search", "build"], check=True, capture_output=True, text=True)
    return {
        "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "processor": processor(),
        "cores": os.cpu_count(),
        "pinned_to_core": timing_core(),
        "load_before": round(os.getloadavg()[0], 2),
        "system": f"{platform.system()} {platform.release()}",
        "commit": commit(),
        **json.loads(built.stdout),
    }
