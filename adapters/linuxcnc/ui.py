#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What LinuxCNC starts as its display: runs the programs of the folder it stands in, one after the other.

jobs.json is a list of {"number", "program", "pins": {name: value}, "patience"}; done.txt gets a line a program:
NUMBER and "ran", or NUMBER, "alarm" and LinuxCNC's words. LinuxCNC ends when this ends.
"""
import json
import os
import shutil
import sys
import time

import hal
import linuxcnc

POLL = 0.002  # s
SETTLE = 0.003  # s, many servo periods: what is sampled last stands at the end


class Alarm(Exception):
    """LinuxCNC refused, in its own words."""


def adapter_lives():
    return os.path.exists("/proc/" + os.environ["TOOLCOMP_LINUXCNC"])


def at_rest(status):
    return (status.interp_state == linuxcnc.INTERP_IDLE and status.queue == 0 and status.inpos
            and status.state != linuxcnc.RCS_EXEC)


class Runner:
    def __init__(self):
        self.command = linuxcnc.command()
        self.status = linuxcnc.stat()
        self.errors = linuxcnc.error_channel()
        self.component = hal.component("recorder")
        self.component.newpin("program", hal.HAL_S32, hal.HAL_OUT)
        self.component.newpin("on", hal.HAL_BIT, hal.HAL_OUT)
        self.component.ready()
        hal.new_sig("recorded-program", hal.HAL_S32)
        hal.new_sig("recording", hal.HAL_BIT)
        hal.connect("recorder.program", "recorded-program")
        hal.connect("sampler.0.pin." + os.environ["PROGRAM_PIN"], "recorded-program")
        hal.connect("recorder.on", "recording")
        hal.connect("sampler.0.enable", "recording")

    def error(self):
        """All that LinuxCNC says is wrong; None if nothing is."""
        texts = []
        while True:
            message = self.errors.poll()
            if not message:
                return " / ".join(texts) or None
            if message[0] in (linuxcnc.OPERATOR_ERROR, linuxcnc.NML_ERROR):
                texts.append(" ".join(message[1].split()))

    def wait(self, ready, patience, what):
        end = time.monotonic() + patience
        while True:
            if not adapter_lives():
                sys.exit("the adapter has gone")
            self.status.poll()
            error = self.error()
            if error:
                raise Alarm(error)
            if ready(self.status):
                return
            if time.monotonic() > end:
                raise Alarm("took too long: " + what)
            time.sleep(POLL)

    def start(self):
        self.command.state(linuxcnc.STATE_ESTOP_RESET)
        self.command.wait_complete()
        self.command.state(linuxcnc.STATE_ON)
        self.command.wait_complete()
        self.wait(lambda s: s.task_state == linuxcnc.STATE_ON, 10, "machine on")
        self.command.mode(linuxcnc.MODE_MANUAL)
        self.command.wait_complete()
        self.command.home(-1)
        self.wait(lambda s: all(s.homed[: s.joints]), 20, "homing")
        self.command.mode(linuxcnc.MODE_AUTO)
        self.command.wait_complete()

    def run(self, job):
        self.error()
        for pin, value in job["pins"].items():
            hal.set_p(pin, repr(value))
        self.component["program"] = job["number"]
        shutil.copyfile(job["tools"], "sim.tbl")
        self.command.load_tool_table()
        self.command.wait_complete()
        self.command.mode(linuxcnc.MODE_AUTO)
        self.command.wait_complete()
        self.command.program_open(job["program"])
        self.command.wait_complete()
        self.component["on"] = True
        try:
            self.command.auto(linuxcnc.AUTO_RUN, 0)
            self.command.wait_complete()
            self.wait(at_rest, job["patience"], "the program")
            time.sleep(SETTLE)
            error = self.error()
            if error:
                raise Alarm(error)
        finally:
            self.component["on"] = False

    def recover(self):
        self.command.abort()
        self.command.wait_complete()
        self.command.mode(linuxcnc.MODE_MANUAL)
        self.command.wait_complete()
        self.status.poll()
        if self.status.task_state != linuxcnc.STATE_ON:
            self.start()


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(folder, "jobs.json"), encoding="utf-8") as file:
        jobs = json.load(file)
    with open(os.path.join(folder, "done.txt"), "w", encoding="utf-8") as done:
        runner = Runner()
        runner.start()
        for job in jobs:
            try:
                runner.run(job)
                print(job["number"], "ran", file=done, flush=True)
            except Alarm as alarm:
                print(job["number"], "alarm", alarm, file=done, flush=True)
                runner.recover()
        print("end", file=done, flush=True)


sys.exit(main())
