#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a FANUC program without its calls: what a control runs, block after block.

usage: expand_fanuc.py MAIN.nc FLAT.nc MAP

FLAT.nc is the program with M98 and M99 carried out; M50 stands where M98 and M99 stood, so that their blocks are still
blocks. Line i of MAP is where line i of FLAT.nc comes from: a line of the main file, or one behind it, where the files
called follow in the order of the calls as they stand in the text, each followed by those that it calls itself.

A number with O is a word that stays; a name at the head of a program is none, and goes.

Written from the words of fanuc.program.call and fanuc.program.return, not from the reader it is held against. It expects
a program without faults and raises where it finds one.
"""
import pathlib
import re
import sys

WORD = re.compile(r"\([^)]*\)|<[^>]*>|[A-Z][ \t]*[-+]?[\d.]*|.", re.IGNORECASE)
HEAD = re.compile(r"\s*(?:O\s*(\d+)|<([^>]*)>)", re.IGNORECASE)
MOST_CALLS = 10


def words_of(line):
    """The words of a block outside its comments, as (letter, number) and in upper case; a name is ("<", name)."""
    words = []
    for token in WORD.findall(line):
        if token.startswith("<"):
            words.append(("<", token[1:-1].upper()))
        elif token[0].isalpha():
            words.append((token[0].upper(), token[1:].strip()))
    return words


class Block:
    def __init__(self, line, text):
        self.line = line
        self.text = text
        words = words_of(text)
        self.value = {letter: number for letter, number in words if number}
        m_codes = [int(float(number)) for letter, number in words if letter == "M" and number]
        self.calls = 98 in m_codes
        self.returns = 99 in m_codes
        self.ends = 2 in m_codes or 30 in m_codes

    def called(self):
        """The program called, and how often."""
        if "<" in self.value:
            return self.value["<"], int(self.value.get("L", 1))
        digits = self.value["P"]
        if "L" in self.value:
            return int(digits), int(self.value["L"])
        return int(digits[-4:]), int(digits[:-4] or 1)

    def flat(self):
        if not (self.calls or self.returns):
            return self.text

        def kept(token):
            if re.fullmatch(r"M\s*9[89]", token, re.IGNORECASE):
                return "M50"
            if token.startswith("<") or re.match(r"[PL][ \t]*\d", token, re.IGNORECASE):
                return ""
            return token

        return "".join(kept(token) for token in WORD.findall(self.text))


class Program:
    def __init__(self, name):
        self.name = name  # a number, a name in upper case, or nothing for a main program without head
        self.blocks = []


def programs_of(text, first_line):
    programs = [Program(None)]
    for offset, line in enumerate(text.split("\n")):
        line = line.rstrip("\r")
        head = HEAD.match(line)
        if head:
            name = int(head.group(1)) if head.group(1) else head.group(2).upper()
            if len(programs) == 1 and programs[0].name is None and not programs[0].blocks:
                programs = []
            programs.append(Program(name))
            if not head.group(1):
                line = line[head.end() :]
        if line.strip() and not line.startswith("%"):
            programs[-1].blocks.append(Block(first_line + offset, line))
    return programs


class Expansion:
    def __init__(self, main):
        self.folder = main.parent
        self.next_line = 1
        self.programs = []
        self.flat, self.map = [], []
        self.read(main)

    def read(self, file):
        text = file.read_bytes().decode("utf-8-sig")
        more = programs_of(text, self.next_line)
        self.next_line += text.count("\n") + (not text.endswith("\n"))
        self.programs += more
        for program in more:
            for block in program.blocks:
                if block.calls and self.find(block.called()[0]) is None:
                    self.read(self.file_of(block.called()[0]))

    def find(self, name):
        return next((program for program in self.programs if program.name == name), None)

    def file_of(self, name):
        if isinstance(name, int):
            files = [p for p in self.folder.iterdir() if (m := re.fullmatch(r"O?(\d+)", p.stem, re.I)) and int(m[1]) == name]
        else:
            files = [p for p in self.folder.iterdir() if name in (p.stem.upper(), p.name.upper())]
        assert len(files) == 1, f"{name}: {files}"
        return files[0]

    def run(self, program, depth):
        """Where the caller goes on: "behind", "end" of the run, or a sequence number."""
        assert depth <= MOST_CALLS, "too many calls"
        at = 0
        while at < len(program.blocks):
            block = program.blocks[at]
            self.flat.append(block.flat())
            self.map.append(block.line)
            at += 1
            if block.ends:
                return "end"
            if block.returns:
                if depth == 0:
                    return "end"
                return int(block.value["P"]) if "P" in block.value else "behind"
            if block.calls:
                name, times = block.called()
                for _ in range(times):
                    goes_on = self.run(self.find(name), depth + 1)
                    if goes_on == "end":
                        return "end"
                    if goes_on != "behind":
                        at = next(
                            i
                            for i in range(at, len(program.blocks))
                            if int(program.blocks[i].value.get("N", -1)) == goes_on
                        )
                        break
        return "behind"


def main():
    source, flat, mapped = map(pathlib.Path, sys.argv[1:])
    expansion = Expansion(source)
    expansion.run(expansion.programs[0], 0)
    flat.write_text("\n".join(expansion.flat) + "\n", encoding="utf-8")
    mapped.write_text("".join(f"{line}\n" for line in expansion.map), encoding="utf-8")


if __name__ == "__main__":
    main()
