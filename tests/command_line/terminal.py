#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs a command with standard error (or everything) on a terminal, types what is asked, and prints what was shown.

usage: terminal.py [--columns N] [--type TEXT --until WORD]... -- COMMAND [ARGUMENT...]

Without --type standard output is thrown away. Each TEXT is typed, and what is shown is read until WORD is in it; Python's
escapes, such as \\t, are understood in TEXT. Behind the last one the command is ended. The exit status is that of the
command, 0 where it was ended, 1 where a WORD did not come.
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

LONGEST = 60  # seconds


def read_until(terminal, process, word):
    """What is shown until the word is in it, or the command has ended."""
    shown = b""
    begun = time.monotonic()
    while word not in shown if word else True:
        if time.monotonic() - begun > LONGEST:
            break
        ready, _, _ = select.select([terminal], [], [], 0.2)
        if not ready:
            if process.poll() is not None:
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
    parser.add_argument("--type", action="append", default=[])
    parser.add_argument("--until", action="append", default=[])
    parser.add_argument("command", nargs="+")
    args = parser.parse_args()

    terminal, end = pty.openpty()
    fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack("HHHH", 40, args.columns, 0, 0))

    def take_terminal():
        os.setsid()
        fcntl.ioctl(end, termios.TIOCSCTTY, 0)

    process = subprocess.Popen(args.command, stdin=end if args.type else subprocess.DEVNULL,
                               stdout=end if args.type else subprocess.DEVNULL, stderr=end, preexec_fn=take_terminal)
    os.close(end)
    if not args.type:
        sys.stdout.buffer.write(read_until(terminal, process, None))
        return process.wait()
    came = True
    for text, word in zip(args.type, args.until, strict=True):
        os.write(terminal, text.encode().decode("unicode_escape").encode())
        shown = read_until(terminal, process, word.encode())
        came = came and word.encode() in shown
        sys.stdout.buffer.write(shown)
    process.kill()
    process.wait()
    return 0 if came else 1


sys.exit(main())
