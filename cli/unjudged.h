// SPDX-License-Identifier: Apache-2.0
// What of a program is not judged, said on standard error: where it begins, and at the end how much it is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cli/program.h"
#include "cli/verbs.h"
#include "spec/language/event.h"

namespace toolcomp::cli {

class Unjudged {
 public:
  explicit Unjudged(const Program& program) : program_(program) {}

  // An event of the run. `line`, `column`: of its block.
  template <class Number>
  void on(const spec::Event<Number>& event, std::uint64_t line, std::uint64_t column) {
    if (event.kind == spec::EventKind::undecided) open(line, column, event.out_of_scope);
    if (event.kind != spec::EventKind::alarm && spec::ends_run(event.kind)) ends(line, column, event.message);
  }
  // The run leaves open what this block does, and so do `count` blocks in all.
  void open(std::uint64_t line, std::uint64_t column, bool out_of_scope, std::uint64_t count = 1);
  // The run ends here without an alarm (spec::is_beyond): `text` says why.
  void ends(std::uint64_t line, std::uint64_t column, std::string_view text);
  // After the end of the run: how many blocks were not looked at.
  void end();

  [[nodiscard]] bool any() const { return open_ != 0 || ended_; }
  [[nodiscard]] int status() const { return any() ? kUndecided : kAgrees; }

 private:
  void say(std::uint64_t line, std::uint64_t column, std::string_view name, std::string_view text) const;

  const Program& program_;
  std::uint64_t open_ = 0;
  bool ended_ = false;
};

}  // namespace toolcomp::cli
