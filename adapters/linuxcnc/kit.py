#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the programs of a kit (docs/kits.md) in LinuxCNC and records them, as an engineer would on a shop floor.

kit.py KIT RECORDINGS [--offset H3=12.7]: offsets are entered from the kit's list, offsets.csv, into LinuxCNC's own tool
table; --offset enters one of them wrongly. Out come O8001.csv and so on, one sample a millisecond.
"""
import argparse
import csv
import json
import sys
import tempfile
import tomllib
from pathlib import Path

import configuration
import motion
import session

THINNED = 5  # servo periods a sample


def typed_in(kit, wrong):
    """The offset tables as the setup format has them: those of the list, but for the entries of `wrong`."""
    tables = {"H": {}, "D": {}}
    with open(kit / "offsets.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            for kind in row["table"].split(" and "):
                tables[kind][row["number"]] = {"geometry": row["geometry"], "wear": row["wear"]}
    for entry in wrong:
        name, value = entry.split("=", 1)
        if name[1:] not in tables.get(name[:1], {}):
            sys.exit(f"--offset {entry}: the kit has no such offset")
        tables[name[0]][name[1:]] = {"geometry": value, "wear": "0"}
    return tables


def plain(setup):
    """TOML's values as JSON takes them."""
    return json.loads(json.dumps(setup, default=str))


def write_batch(kit, programs, tables, batch):
    for i, program in enumerate(programs):
        folder = batch / f"{i + 1:04}"
        folder.mkdir()
        setup = plain(tomllib.loads((kit / program["setup"]).read_text(encoding="utf-8")))
        setup["offsets"] = {**setup.get("offsets", {}), **tables}
        (folder / "setup.json").write_text(json.dumps(setup), encoding="utf-8")
        (folder / "program.nc").write_text((kit / program["file"]).read_text(encoding="utf-8"), encoding="utf-8")


def collect(programs, batch, recordings):
    """The recordings out of the batch; how many programs have none."""
    missing = 0
    for i, program in enumerate(programs):
        folder, name = batch / f"{i + 1:04}", Path(program["file"]).stem
        trace = folder / "trace.csv"
        if not trace.exists():
            missing += 1
            why = next((file.read_text(encoding="utf-8").strip() for file in folder.glob("*.txt")
                        if file.stem in ("alarm", "not_applicable", "failed")), "nothing was recorded")
            print(f"{name}: {why}", file=sys.stderr)
            continue
        header, *samples = trace.read_text(encoding="ascii").splitlines(keepends=True)
        kept = samples[::THINNED] + ([] if len(samples) % THINNED == 1 else samples[-1:])
        (recordings / f"{name}.csv").write_text(header + "".join(kept), encoding="ascii")
    return missing


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("kit", type=Path)
    parser.add_argument("recordings", type=Path)
    parser.add_argument("--offset", action="append", default=[], help="NAME=VALUE, typed in wrongly")
    options = parser.parse_args()
    programs = [p for p in json.loads((options.kit / "kit.json").read_text(encoding="utf-8"))["programs"]
                if "alarm" not in p]
    options.recordings.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="toolcomp-kit-") as batch:
        write_batch(options.kit, programs, typed_in(options.kit, options.offset), Path(batch))
        try:
            motion.run_batch(Path(batch), configuration.SERVO_PERIOD)
        except session.Failed as failure:
            sys.exit(str(failure))
        return 1 if collect(programs, Path(batch), options.recordings) else 0


if __name__ == "__main__":
    sys.exit(main())
