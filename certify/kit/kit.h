// SPDX-License-Identifier: Apache-2.0
// A kit: the files that an engineer takes to a machine, as they are written to a folder and read back.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "certify/kit/machine.h"
#include "certify/kit/parameters.h"
#include "certify/kit/program.h"

namespace toolcomp::certify::kit {

struct KitCase {
  std::string id;  // of the vector
  std::string section;
  bool same_machine = false;       // whether the machine of the vector is this machine
  CaseLines lines;                 // in the program
  std::vector<std::string> shows;  // clause outcomes, "fanuc.cutter-c.ccn=true"
};

struct KitProgram {
  unsigned number = 0;  // 8001: O8001
  std::size_t group = 0;
  std::string file;      // "O8001.nc", relative to the folder
  std::string setup;     // "setup-0.toml"
  std::string expected;  // "expected/O8001.jsonl"; empty of a program that ends in an alarm
  std::vector<KitCase> cases;
  MarkLines marks;            // of programs to record
  std::string alarm;          // expected alarm; empty if none
  std::uint64_t alarm_n = 0;  // sequence number of the block at fault
};

// Programs that run under the same parameters.
struct KitGroup {
  Overlay parameters;
  std::string program;  // program that sets them; empty: the parameters of the machine
};

struct NotCovered {
  std::string outcome;
  std::string text;
  std::string why;
};

struct Kit {
  std::string tool;    // "toolcomp 0.1.0"
  std::string corpus;  // version
  std::string corpus_hash;
  std::vector<std::string> sections;  // asked for; empty: all
  Machine machine;
  spec::Decimal tolerance;  // largest tolerance with which recordings may be judged
  std::vector<KitGroup> groups;
  std::vector<KitProgram> programs;
  std::size_t outcomes = 0;         // of these sections
  std::size_t recorded = 0;         // shown by recordings
  std::size_t noted = 0;            // shown only by alarms
  std::vector<NotCovered> missing;  // all others
  std::string offsets_program;      // "O8000.nc"
  // Every file of the folder except kit.json: its name and its text, or, in a kit that was read, its SHA-256.
  std::map<std::string, std::string> files;
  std::string digest;  // of kit.json itself, if the kit was read
};

inline constexpr const char* kKitFile = "kit.json";
inline constexpr const char* kAlarmForm = "alarms.csv";

}  // namespace toolcomp::certify::kit
