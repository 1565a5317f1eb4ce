#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a Klartext program without its calls: what a control runs, block after block.

usage: expand_klartext.py MAIN.h FLAT.h MAP

FLAT.h is the program with LBL, CALL LBL and CALL PGM carried out. Line i of MAP is where line i of FLAT.h comes from: a
line of the main file, or one behind it, where the files called follow in the order in which they are first named.

Written from the words of the manuals, not from the reader it is held against:
* CALL LBL n: the program goes on at LBL n, up to LBL 0, and then behind the call.
* CALL LBL n REP m: the section from LBL n to here is run m times more.
* CALL PGM: the other program from its BEGIN PGM to its END PGM, then after the call. It cancels the radius compensation.
It expects a program without faults and raises where it finds one.
"""
import pathlib
import re
import sys


class Block:
    def __init__(self, number, lines):
        self.number = number  # of its first line
        self.lines = lines
        joined = " ".join(re.sub(r"~\s*$", " ", line) for line in lines)
        words = re.sub(r'("[^"]*")|;.*', lambda match: match.group(1) or "", joined)
        self.words = re.findall(r'"[^"]*"|\S+', re.sub(r"^\s*/?\s*\d*\s*/?", "", words))
        self.key = [word.upper() for word in self.words[:2]]

    def is_label(self):
        return self.key[:1] == ["LBL"]

    def label(self, at):
        word = self.words[at]
        return word if word.startswith('"') else str(int(word))


def blocks_of(text, first_line):
    blocks, pending, start = [], [], first_line
    for offset, line in enumerate(text.split("\n")):
        if not pending:
            start = first_line + offset
        pending.append(line.rstrip("\r"))
        if not pending[-1].rstrip().endswith("~"):
            blocks.append(Block(start, pending))
            pending = []
    return blocks


class Program:
    def __init__(self, blocks):
        ends = [i for i, block in enumerate(blocks) if block.key == ["END", "PGM"]]
        self.blocks = blocks[: ends[0] + 1] if ends else blocks
        self.where = {}
        for i, block in enumerate(self.blocks):
            if block.is_label() and block.label(1) != "0":
                assert block.label(1) not in self.where, "a label twice"
                self.where[block.label(1)] = i


class Expansion:
    def __init__(self, main):
        self.folder = main.parent
        self.flat, self.map = [], []
        self.programs = {}
        text = main.read_text(encoding="utf-8")
        self.main = Program(blocks_of(text, 1))
        self.read_called(blocks_of(text, 1), 1 + text.count("\n") + (not text.endswith("\n")))

    def read_called(self, blocks, line):
        queue = list(blocks)
        while queue:
            block = queue.pop(0)
            if block.key != ["CALL", "PGM"]:
                continue
            name = self.name(block)
            if name in self.programs:
                continue
            file = next(p for p in sorted(self.folder.iterdir()) if p.stem.upper() == name and p.suffix.upper() == ".H")
            text = file.read_text(encoding="utf-8")
            more = blocks_of(text, line)
            line += text.count("\n") + (not text.endswith("\n"))
            begin = next(i for i, other in enumerate(more) if other.key == ["BEGIN", "PGM"])
            self.programs[name] = Program(more[begin + 1 :])
            queue += more

    @staticmethod
    def name(block):
        return re.sub(r"\.H$", "", block.words[2].strip('"').upper())

    def emit(self, block):
        for offset, line in enumerate(block.lines):
            self.flat.append(line)
            self.map.append(block.number + offset)

    def run(self, program, start, is_main, until_zero):
        """From block `start` to the end of the program, or to LBL 0."""
        more = {}  # how often a section is still to be run, by its last block
        at = start
        while at < len(program.blocks):
            block = program.blocks[at]
            if block.is_label():
                if until_zero and block.label(1) == "0":
                    return
            elif block.key == ["CALL", "LBL"]:
                name = block.label(2)
                repeat = re.match(r"(\d+)", "".join(block.words[3:]).upper().removeprefix("REP"))
                if not repeat:
                    self.run(program, program.where[name], is_main, True)
                else:
                    more.setdefault(at, int(repeat.group(1)))
                    if more[at] > 0:
                        more[at] -= 1
                        at = program.where[name]
                        continue
                    del more[at]
            elif block.key == ["CALL", "PGM"]:
                self.flat.append("L R0")
                self.map.append(block.number)
                self.run(self.programs[self.name(block)], 0, False, False)
            elif block.key == ["END", "PGM"]:
                if is_main:
                    self.emit(block)
                return
            else:
                self.emit(block)
            at += 1


def main():
    source, flat, mapped = map(pathlib.Path, sys.argv[1:])
    expansion = Expansion(source)
    expansion.run(expansion.main, 0, True, False)
    flat.write_text("\n".join(expansion.flat) + "\n", encoding="utf-8")
    mapped.write_text("".join(f"{line}\n" for line in expansion.map), encoding="utf-8")


if __name__ == "__main__":
    main()
