// SPDX-License-Identifier: Apache-2.0
// The examples that have their figures beside them (corpus/examples), each in the form of its section.
#include <fmt/format.h>

#include "tests/golden/fanuc/pose_rows.h"
#include "tests/golden/heidenhain/space_rows.h"
#include "tests/golden/rows.h"

namespace toolcomp::corpus {
namespace {

worked::Rows rows_of(std::string_view figures) {
  worked::Rows rows;
  while (!figures.empty()) {
    rows.emplace_back(figures.substr(0, figures.find('\n')));
    figures.remove_prefix(rows.back().size() + 1);
  }
  return rows;
}

void hold_to_figures(const spec::Case& c, const worked::Rows& rows) {
  const bool poses = c.section == "fanuc/tool-center-point-control" || c.section == "fanuc/tool-posture-control";
  worked::hold(c, [&](const auto& events) {
    if (c.setup.control == spec::Control::heidenhain)
      space::expect_events(events, rows, c.setup.axes);
    else if (poses)
      poses::expect_events(events, rows, c.setup.axes);
    else
      EXPECT_EQ(rows::shown(events, rows, c.setup.axes), rows);
  });
}

TEST(Figures, OfEveryExampleThatHasThemBesideIt) {
  for (const ExampleFile& file : example_files())
    for (const Example& example : file.examples) {
      if (example.figures.empty()) continue;
      SCOPED_TRACE(example.comment);
      ASSERT_TRUE(example.figures.ends_with('\n'));
      hold_to_figures(
          worked::vector_of(std::string(file.section), std::string(file.name), std::string(example.comment)),
          rows_of(example.figures));
    }
}

// Files whose figures, or those of some of their examples, stand in a table of the tests.
constexpr std::string_view kTables[] = {
    "fanuc/tool-length-measurement/examples",
    "fanuc/tool-offset/examples",
    "fanuc/cutter-compensation-c/examples",
    "fanuc/cutter-compensation-c/examples-corners",
    "fanuc/cutter-compensation-c/examples-checks",
    "fanuc/cutter-compensation-c/rules",
    "fanuc/tool-side-compensation/examples",
    "fanuc/tool-side-compensation/rules",
    "fanuc/leading-edge-offset/examples",
    "fanuc/leading-edge-offset/rules",
    "fanuc/tool-center-point-control/examples",
    "fanuc/tool-center-point-control/rules",
    "fanuc/tool-posture-control/examples",
    "fanuc/tool-posture-control/rules",
    "heidenhain/face-milling/examples",
    "heidenhain/face-milling/rules",
    "heidenhain/face-milling/klartext",
    "heidenhain/peripheral-milling/examples",
    "heidenhain/peripheral-milling/rules",
    "heidenhain/programmed-contour/examples",
    "heidenhain/programmed-contour/rules",
};

// The table holds its file to the number of its rows and of figures (worked_examples.h); where there is none, every
// example has figures of its own.
TEST(Figures, AreMissingOnlyWhereATableHasThem) {
  for (const ExampleFile& file : example_files()) {
    const std::string section(file.section);
    const std::string name(file.name);
    const std::size_t beside = worked::with_figures(section, name);
    const bool table = std::ranges::find(kTables, fmt::format("{}/{}", section, name)) != std::end(kTables);
    EXPECT_EQ(beside == file.examples.size(), !table) << section << '/' << name;
    if (table) continue;
    EXPECT_EQ(worked::file(section, name).size(), beside) << section << '/' << name;
  }
}

}  // namespace
}  // namespace toolcomp::corpus
