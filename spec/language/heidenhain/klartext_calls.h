// SPDX-License-Identifier: Apache-2.0
// Calls and repeats of programs: which block comes next. This is only about the order of the text, so that both engines
// may share it. Internal to the reader.
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

// A text from its first LBL or CALL on, with the active calls and repeats.
class Calls {
 public:
  // What the reader knows from before the text.
  struct Main {
    std::string name;  // name of BEGIN PGM; empty if there was none
    Units units = Units::mm;
    std::uint64_t line = 1;  // line of the first block of the text
  };
  // Setup and options must outlive this object.
  Calls(const Setup& setup, const ReaderOptions& options, std::string text, Main main);

  // The text, followed by kBehindText bytes. It may grow in next(); places stay valid.
  [[nodiscard]] char* data() { return text_.data(); }
  [[nodiscard]] std::size_t size() const { return text_.size() - kBehindText; }

  // The place of the block to run after the one that begins at `at` and ends at `behind`; std::nullopt at the end of
  // the program. Completes the block: `jumps`, program_return, alarms of calls (README.md of the language).
  std::optional<TextPlace> next(Block& block, TextPlace at, TextPlace behind);

 private:
  // The places of each label, by its name. More than one place means that the program has the label more than once.
  using Labels = std::map<std::string, std::vector<TextPlace>, std::less<>>;
  // A program, from the end of its BEGIN PGM to its END PGM. Without END PGM it cannot be called.
  struct Program {
    std::string key;
    Units units = Units::mm;
    TextPlace begin;
    bool ends = false;
    Labels labels;
  };
  // An active call. The first one is the main program.
  struct Frame {
    TextPlace back;
    std::size_t program = 0;
    std::string label;                             // label of a subprogram; empty for a program
    std::map<std::size_t, std::uint32_t> repeats;  // repeats that are left, by the place of CALL LBL
  };

  void make_programs();
  std::optional<TextPlace> label(Block& block, TextPlace behind);
  TextPlace subprogram(Block& block, TextPlace behind);
  TextPlace repeat(Block& block, TextPlace at, TextPlace behind);
  TextPlace program(Block& block, TextPlace behind);
  std::optional<TextPlace> end(Block& block);
  // The place of the label that the block calls; std::nullopt, with an alarm, if there is no such label or more than
  // one.
  std::optional<TextPlace> place_of_label(Block& block);
  [[nodiscard]] std::optional<std::size_t> find(std::string_view key) const;
  // Adds the files. If the text broke off inside a line, `behind` moves after the end of that line.
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
