// SPDX-License-Identifier: Apache-2.0
// Certificates of several controllers in one table: what each does in each section of the manuals.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify::results {

// A longer file is no certificate: one of all sections has some 100 KB.
inline constexpr std::size_t kLongestFile = std::size_t{16} << 20;
// Controllers that one table may have.
inline constexpr std::size_t kMostControllers = 100;
// Findings of one controller that are told one by one; the rest is counted.
inline constexpr std::size_t kMostFindings = 100;

// How a controller stands in a section, by its certificate. Of several reasons the first of these counts.
enum class Standing : std::uint8_t {
  finding,         // at least one
  not_decided,     // a case, or the harness failed its own check, or no value was judged
  partly_judged,   // too much was not judged, was not run, or was left out by --known
  by_design,       // all that was judged conforms, and in some cases the controller does otherwise by design
  conforms,        // all that was judged
  not_applicable,  // the controller does not have it
  not_asked,       // the certificate does not say anything of it
};
inline constexpr std::size_t kStandings = 7;
// "finding", "not decided", "partly judged", "differs by design", "conforms", "not applicable", "not asked".
std::string_view name(Standing standing);

// One controller in one section.
struct Cell {
  Standing standing = Standing::not_asked;
  std::uint64_t cases = 0;           // judged or to be judged: what does not apply is not among them
  std::uint64_t agree = 0;           // of them
  std::uint64_t not_applicable = 0;  // besides
  std::uint64_t findings = 0;
  std::uint64_t values = 0;  // compared; 0 of recordings, which have samples
  std::string why;           // why no more than this was judged; empty: there is no reason
  std::map<std::string, std::uint64_t> known_differences;  // cases, by the name of the difference
  std::vector<std::string> clauses;                        // ids of those that were judged by
};

// A finding, or a recorded program that differs. Text from the certificate, made fit to be shown.
struct ToldFinding {
  std::string section;  // empty: a program of the user's own
  std::string clause;   // id; empty: none
  std::string source;   // how the clause is known, as the certificate says it
  std::string what;     // kind, place, expected and actual
  std::uint64_t cases = 1;
};

// Findings that look like one mistake.
struct ToldCause {
  std::string words;
  std::uint64_t findings = 0;
  std::uint64_t cases = 0;
};

// What one certificate says. All text is fit to be shown (spec/language/printable.h).
struct Controller {
  std::string folder;  // of the certificate, as it was named
  std::string name;
  std::string version;  // empty: not stated
  std::string date;     // ISO 8601; empty: not stated
  std::string serial;   // the same
  std::string verdict;
  int exit_status = 0;
  std::string tool;       // name and version
  std::string corpus;     // version; empty: none
  std::string judged_by;  // "manual, sister", where not by all clauses; empty: by all
  std::vector<std::string> fields_not_judged;
  std::map<std::string, Cell> cells;               // by section; "": programs of the user's own
  std::vector<ToldFinding> findings;               // the first kMostFindings
  std::vector<ToldCause> causes;                   // of findings, the first kMostFindings
  std::map<std::string, std::string> differences;  // why the controller does otherwise by design, by name

  // What it is called: "LinuxCNC rs274 2.9".
  [[nodiscard]] std::string title() const;
  // Of a section, or of own programs.
  [[nodiscard]] const Cell& cell(std::string_view section) const;
};

// Reads `folder`/certificate.json as certify writes it, of a controller that answers or is recorded by an adapter.
// Throws spec::InputError, with the place where there is one, for what is no such certificate, is longer than
// kLongestFile, or contradicts itself (it conforms, and has findings).
Controller read_certificate(const std::filesystem::path& folder);

// The same of a text that stands, or would stand, in `file`.
Controller read_certificate(std::string_view text, const std::string& file);

// The sections in the order of the manuals' chapters, then "" where any controller has programs of its own.
std::vector<std::string> rows(std::span<const Controller> controllers);

// What stands in a cell: "conforms", "3 findings", "differs by design".
std::string words(const Cell& cell);

// One self-contained HTML page: which controllers, the table, and of each controller what its cells rest on.
std::string page(std::span<const Controller> controllers);
// Everything the page says, for machines.
std::string json(std::span<const Controller> controllers);

}  // namespace toolcomp::certify::results
