// SPDX-License-Identifier: Apache-2.0
// The Klartext side of a kit: which vectors go to the machine, the tools they share, the words around them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/kit/machine.h"
#include "spec/language/case.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::certify::kit {

using Statements = std::vector<spec::klartext::Block>;

struct ScreenedKlartext {
  Statements statements;  // without BEGIN PGM, BLK FORM, END PGM, block numbers, and M2 or M30 at the end
  std::string why;        // why it stays at home; empty: it may go
};

// Refuses what a bare machine must not do (M functions but M107, M108, M128, M129; feeds of a tooth or a turn), what
// leaves traces or needs more than the tool table (PLANE, cycles but the datum shift, rows of compensation tables,
// tools with a table of deviations), and what a control does not take: other units, too many digits, what cannot be
// read.
ScreenedKlartext screen_klartext(const Machine& machine, const spec::Case& vector);

// The one tool table that all cases of a kit share.
class ToolTable {
 public:
  // Numbers from `first` on are used.
  explicit ToolTable(std::uint32_t first) : first_(first) {}

  // Gives every tool that the statements call a number of the table with the same row, and calls it by that; another
  // one for each row of the case. A tool that the case does not have stays as it is, beyond the table.
  bool take(const std::vector<spec::ToolRow>& tools, Statements& statements);
  [[nodiscard]] const std::vector<spec::ToolRow>& rows() const { return rows_; }

 private:
  std::uint32_t first_;
  std::vector<spec::ToolRow> rows_;
};

// A statement as a control reads it.
std::string klartext_of(const spec::klartext::Block& statement);

// The table as TOOL.T of a control holds it.
std::string tool_file(const std::vector<spec::ToolRow>& rows);

}  // namespace toolcomp::certify::kit
