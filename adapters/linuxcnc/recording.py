# SPDX-License-Identifier: Apache-2.0
"""The sampler's text as one recording a program."""
from configuration import GAIN
from translate import PREAMBLE


class Lost(Exception):
    """Samples are missing: the recording is worth nothing."""


def split(path, joints):
    """Program number → (samples, ok): samples are (line of LinuxCNC's program, joints in millionths as text)."""
    runs, lost = {}, set()
    last = None
    with open(path, encoding="ascii") as file:
        for text in file:
            if text.startswith("overrun"):
                last = None
                continue
            fields = text.split()
            if len(fields) != joints + 3:
                continue  # cut off where LinuxCNC ended
            count, line, program = int(fields[0]), int(fields[-2]), int(fields[-1])
            if last is not None and count != last + 1 or last is None and runs:
                lost.add(program)
            last = count
            runs.setdefault(program, []).append((line, fields[1:-2]))
    return runs, lost


def program_part(samples):
    """The samples behind the preamble: from the last one that stands where the program starts."""
    # The line of the program before may still stand there when the recording begins.
    first = next((i for i, (line, _) in enumerate(samples) if 0 < line <= PREAMBLE), None)
    if first is None:
        raise Lost("the preamble was not recorded")
    start = next((i for i in range(first, len(samples)) if samples[i][0] > PREAMBLE), len(samples))
    return samples[start - 1:]


def write_trace(path, samples, module, job, period):
    """The CSV of a trace: joints less the workpiece origin, times from 0."""
    columns = [(module.joints.index(axis), GAIN * (1 if axis in "ABC" else job.unit), job.origin.get(axis, 0))
               for axis in job.axes]
    beside = path.with_suffix(".part")
    with open(beside, "w", encoding="ascii") as file:
        file.write("time," + ",".join(job.axes) + "\n")
        for i, (_, joints) in enumerate(samples):
            values = ",".join(f"{float(joints[j]) / unit - zero:.12f}" for j, unit, zero in columns)
            file.write(f"{i * period / 1e9:.4f},{values}\n")
    beside.replace(path)
