# SPDX-License-Identifier: Apache-2.0
"""One start of LinuxCNC without hardware or screen, as a user who may (rtapi_app refuses root), and its end.

Every process started here has the mark of the adapter in its environment, so that what was left by a killed adapter is
found by process id, and nothing of anybody else is touched.
"""
import contextlib
import errno
import os
import pwd
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

FOLDER = "toolcomp-linuxcnc-"  # of work, and the adapter's process id
USER = "nobody"  # runs LinuxCNC where the adapter is root
MARK = "TOOLCOMP_LINUXCNC"  # environment: process id of the adapter
LOCK = Path("/tmp/linuxcnc.lock")  # LinuxCNC's
ONE_AT_A_TIME = "\0toolcomp-linuxcnc"  # ours, an abstract socket
# Keys of LinuxCNC's shared memory: RTAPI, HAL, its count of users, motion, the sampler's fifo; NML's.
KEYS = {0x90280A48, 0x48414C32, 0x48484C34, 0x64, 0x48535430, *range(1001, 1006)}


class Failed(Exception):
    """LinuxCNC could not be run: what it said."""


def run_as():
    """The user id LinuxCNC runs under."""
    return pwd.getpwnam(USER).pw_uid if os.geteuid() == 0 else os.geteuid()


def marked():
    """(process id, adapter's process id) of every process started by an adapter."""
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        with contextlib.suppress(OSError, ValueError):
            for variable in (entry / "environ").read_bytes().split(b"\0"):
                if variable.startswith(MARK.encode() + b"="):
                    yield int(entry.name), int(variable.split(b"=", 1)[1])


def end_processes(wanted, patience=5.0):
    """Ends the marked processes of an adapter for which `wanted(its process id)`: asks first, then kills."""
    for sign in (signal.SIGTERM, signal.SIGKILL):
        deadline = time.monotonic() + patience
        while pids := [pid for pid, adapter in marked() if wanted(adapter) and pid != os.getpid()]:
            for pid in pids:
                with contextlib.suppress(ProcessLookupError, PermissionError):
                    os.kill(pid, sign)
            if time.monotonic() > deadline:
                break
            time.sleep(0.1)


def lives(pid):
    return os.path.exists(f"/proc/{pid}")


def linuxcnc_processes():
    """Process ids of rtapi_app of any user: LinuxCNC is running."""
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            with contextlib.suppress(OSError):
                if (entry / "comm").read_text().startswith("rtapi_app"):
                    yield int(entry.name)


def remove_files():
    """Work folders of adapters that were killed, and what LinuxCNC then left of its output."""
    if os.geteuid() == 0:
        for kind in ("debug", "print"):
            for file in Path("/tmp").glob(f"linuxcnc.{kind}.*"):
                if file.stat().st_uid == run_as():
                    file.unlink()
    for folder in Path(tempfile.gettempdir()).glob(FOLDER + "*-*"):
        number = folder.name.removeprefix(FOLDER).split("-")[0]
        if number.isdigit() and not lives(int(number)):
            shutil.rmtree(folder, ignore_errors=True)


def remove_remains():
    """What this adapter or a killed one left. Throws if another LinuxCNC runs."""
    end_processes(lambda adapter: adapter == os.getpid() or not lives(adapter))
    deadline = time.monotonic() + 5
    while (running := list(linuxcnc_processes())) and time.monotonic() < deadline:
        time.sleep(0.1)
    if running:
        raise Failed(f"LinuxCNC is running already, process {running[0]}: one instance at a time on a machine")
    user = run_as()
    with contextlib.suppress(FileNotFoundError):
        if LOCK.stat().st_uid != user:
            raise Failed(f"{LOCK} belongs to another user")
        LOCK.unlink()
    for line in Path("/proc/sysvipc/shm").read_text().splitlines()[1:]:
        fields = line.split()
        key, segment, attached, owner = int(fields[0]), fields[1], int(fields[6]), int(fields[7])
        if owner == user and attached == 0 and key & 0xFFFFFFFF in KEYS:
            subprocess.run(["ipcrm", "-m", segment], check=False)
    remove_files()


@contextlib.contextmanager
def exclusive(patience):
    """One adapter at a time on a machine: a name that ends with its process."""
    with socket.socket(socket.AF_UNIX) as one:
        deadline = time.monotonic() + patience
        while True:
            try:
                one.bind(ONE_AT_A_TIME)
                break
            except OSError as error:
                if error.errno != errno.EADDRINUSE:
                    raise
                if time.monotonic() > deadline:
                    raise Failed("another adapter has LinuxCNC") from None
                time.sleep(0.2)
        yield


@contextlib.contextmanager
def work_folder():
    """A folder that the user LinuxCNC runs under owns; removed at the end."""
    folder = Path(tempfile.mkdtemp(prefix=f"{FOLDER}{os.getpid()}-"))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def give_away(folder):
    if os.geteuid() == 0:
        user = pwd.getpwnam(USER)
        for path in [folder, *folder.iterdir()]:
            os.chown(path, user.pw_uid, user.pw_gid)


def wait_for(process, patience):
    """Until it ends, or for so long, or until whoever started the adapter has gone."""
    parent, deadline = os.getppid(), time.monotonic() + patience
    while process.poll() is None and time.monotonic() < deadline:
        if os.getppid() != parent:
            raise Failed("who started the adapter has gone")
        time.sleep(0.1)


def run(folder, patience, environment):
    """Runs linuxcnc on sim.ini of the folder until its display ends. Nothing of it is left, however it ends."""
    give_away(folder)
    remove_remains()
    command = ["env", f"HOME={folder}", f"{MARK}={os.getpid()}", *environment, "linuxcnc", "-r", "sim.ini"]
    if os.geteuid() == 0:
        command = ["runuser", "-u", USER, "--", *command]
    said = folder / "said.txt"
    try:
        with open(said, "wb") as output:
            process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=output,
                                       stderr=subprocess.STDOUT, start_new_session=True)
            wait_for(process, patience)
    finally:
        remove_remains()
    return said.read_text(errors="replace")
