// SPDX-License-Identifier: Apache-2.0
// Programs in programs: which block comes next. Order of text alone, so that both engines may rest on it. Internal to
// the reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/heidenhain/klartext_outline.h"
#include "spec/language/reader_options.h"
#include "spec/language/setup.h"

namespace toolcomp::spec::klartext {

// A text from its first LBL or CALL on, with the calls and repeats under way.
class Calls {
 public:
  // What stands before the text.
  struct Main {
    std::string name;  // of BEGIN PGM; empty: there was none
    Units units = Units::mm;
    std::uint64_t line = 1;  // of the first block of the text
  };
  // Setup and options must outlive it.
  Calls(const Setup& setup, const ReaderOptions& options, std::string text, Main main);

  // The text, and kBehindText bytes behind it. It may grow with next(); places stay.
  [[nodiscard]] char* data() { return text_.data(); }
  [[nodiscard]] std::size_t size() const { return text_.size() - kBehindText; }

  // The place of the block behind the one that was read `at` this place and ends `behind` it; nothing at the end of the
  // program. Completes the block: `jumps`, program_return, alarms of calls (README.md of the language).
  std::optional<TextPlace> next(Block& block, TextPlace at, TextPlace behind);

 private:
  // A label by its name; more than one place: it stands there twice.
  using Labels = std::map<std::string, std::vector<TextPlace>, std::less<>>;
  // From behind its BEGIN PGM to its END PGM, without which it cannot be called.
  struct Program {
    std::string key;
    Units units = Units::mm;
    TextPlace begin;
    bool ends = false;
    Labels labels;
  };
  // A call under way; the first is the main program.
  struct Frame {
    TextPlace back;
    std::size_t program = 0;
    std::string label;                             // of a subprogram; empty: a program
    std::map<std::size_t, std::uint32_t> repeats;  // still to come, by the place of CALL LBL
  };

  void make_programs();
  std::optional<TextPlace> label(Block& block, TextPlace behind);
  TextPlace subprogram(Block& block, TextPlace behind);
  TextPlace repeat(Block& block, TextPlace at, TextPlace behind);
  TextPlace program(Block& block, TextPlace behind);
  std::optional<TextPlace> end(Block& block);
  // The one place of the label that the block calls; nothing, with an alarm, where there is none or are two.
  std::optional<TextPlace> place_of_label(Block& block);
  [[nodiscard]] std::optional<std::size_t> find(std::string_view key) const;
  // Adds the files. `behind` moves behind the end of its line, where the text broke off in it.
  void join(TextPlace& behind);
  [[nodiscard]] std::size_t depth(bool subprograms) const;

  const Setup& setup_;
  const ReaderOptions& options_;
  const Main main_;
  std::string text_;
  std::uint64_t most_blocks_ = 0;
  std::uint64_t blocks_ = 0;
  bool joined_ = false;
  std::vector<Program> programs_;
  std::vector<Frame> frames_ = std::vector<Frame>(1);
};

}  // namespace toolcomp::spec::klartext
