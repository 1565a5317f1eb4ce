#!/usr/bin/env python3
"""Runs a command with standard error (or everything) on a terminal, types what is asked, and prints what was shown.

usage: terminal.py [--columns N] [--all] [--type TEXT]... -- COMMAND [ARGUMENT...]

Without --all standard output is a pipe that is thrown away. Each TEXT is typed once the terminal has been still for a
moment; Python's escapes, such as \\t, are understood. The exit status is that of the command, or 0 where it had to be
ended after the last text.
"""
import argparse
import fcntl
import os
import pty
import select
import struct
import subprocess
import sys
import termios
import time

STILL = 0.7  # seconds
LONGEST = 60


def read_until_still(terminal, process, still):
    shown = b""
    begun = time.monotonic()
    while time.monotonic() - begun < LONGEST:
        ready, _, _ = select.select([terminal], [], [], still)
        if not ready:
            if still == STILL or process.poll() is not None:
                break
            continue
        try:
            part = os.read(terminal, 65536)
        except OSError:
            break
        if not part:
            break
        shown += part
    return shown


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--columns", type=int, default=80)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--type", action="append", default=[])
    parser.add_argument("command", nargs="+")
    args = parser.parse_args()

    terminal, end = pty.openpty()
    fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack("HHHH", 40, args.columns, 0, 0))

    def take_terminal():
        os.setsid()
        fcntl.ioctl(end, termios.TIOCSCTTY, 0)

    everything = args.all or args.type
    process = subprocess.Popen(args.command, stdin=end if args.type else subprocess.DEVNULL,
                               stdout=end if everything else subprocess.DEVNULL, stderr=end, preexec_fn=take_terminal)
    os.close(end)
    shown = b""
    for text in args.type:
        shown += read_until_still(terminal, process, STILL)
        os.write(terminal, text.encode().decode("unicode_escape").encode())
    shown += read_until_still(terminal, process, STILL if args.type else 0.2)
    if process.poll() is None:
        process.kill()
        process.wait()
        status = 0
    else:
        status = process.returncode
    sys.stdout.buffer.write(shown)
    return status


sys.exit(main())
