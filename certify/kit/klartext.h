// SPDX-License-Identifier: Apache-2.0
// The Klartext side of a kit: the vectors that may go to the machine, the tools that they share, the words around them.
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
  std::string why;        // why it is left out; empty if it may be used
};

// Refuses programs that are not safe on an empty machine (M functions other than M107, M108, M128, M129; feeds per
// tooth or per revolution), programs that leave traces or need more than the tool table (PLANE, cycles other than the
// datum shift, rows of compensation tables, tools with a table of deviations), and programs that a control does not
// accept: other units, too many digits, blocks that cannot be read.
ScreenedKlartext screen_klartext(const Machine& machine, const spec::Case& vector);

// The one tool table that all cases of a kit share.
class ToolTable {
 public:
  // Numbers from `first` on are used.
  explicit ToolTable(std::uint32_t first) : first_(first) {}

  // Gives every tool that the statements call a number of the table with the same row, a different number for each row
  // of the case, and rewrites the calls. A tool that the case does not have keeps its number, which is outside the
  // table.
  bool take(const std::vector<spec::ToolRow>& tools, Statements& statements);
  [[nodiscard]] const std::vector<spec::ToolRow>& rows() const { return rows_; }

 private:
  std::uint32_t first_;
  std::vector<spec::ToolRow> rows_;
};

// The statement as text for a control.
std::string klartext_of(const spec::klartext::Block& statement);

// The table in the form of TOOL.T of a control.
std::string tool_file(const std::vector<spec::ToolRow>& rows);

}  // namespace toolcomp::certify::kit
