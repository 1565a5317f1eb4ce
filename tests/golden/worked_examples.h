// SPDX-License-Identifier: Apache-2.0
// The worked examples of the manuals and of the rules. Each is said once: its program and setup in corpus/examples, its
// figures, by hand, beside them (golden/figures.cpp) or in a table of the tests beside this file. The vector of the
// corpus, both engines and the laws are held to that one place.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "corpus/examples.h"
#include "corpus/golden.h"
#include "corpus/vector.h"
#include "judge/oracle/trial.h"

namespace toolcomp::corpus::worked {

// One row an event, in the form of the section's table (rows.h, pose_rows.h, space_rows.h).
using Rows = std::vector<std::string>;

struct Example {
  const char* comment;  // how the vector's comment begins
  Rows rows;
};

// The vectors of one file, golden/SECTION/NAME.jsonl.
inline const std::vector<spec::Case>& file(const std::string& section, const std::string& name) {
  static std::map<std::string, std::vector<spec::Case>> files;
  auto [found, fresh] = files.try_emplace(section + '/' + name);
  if (fresh) found->second = read_cases(default_folder() / section / (name + ".jsonl"));
  return found->second;
}

// The one vector of the file whose comment begins so.
inline const spec::Case& vector_of(const std::string& section, const std::string& name, const std::string& comment) {
  const auto begins = [&](const spec::Case& c) { return c.comment.starts_with(comment); };
  const std::vector<spec::Case>& vectors = file(section, name);
  EXPECT_EQ(std::ranges::count_if(vectors, begins), 1) << comment;
  return *std::ranges::find_if(vectors, begins);
}

// What the vector, the model and the fast engine say, each given to `look` with the name of who says it.
template <class Look>
void hold(const spec::Case& c, const Look& look) {
  const auto ask = [&](const char* who, const auto& events) {
    SCOPED_TRACE(who);
    look(events);
  };
  const judge::Trial trial = judge::try_case(c);
  EXPECT_FALSE(trial.found()) << judge::explain(trial.verdict.difference.value_or(judge::Difference{}));  // laws too
  ask("the vector", c.expect);
  ask("the model", expected_events(trial.run));
  ask("the fast engine", judge::run_fast(c));
}

// The examples of the file that have figures beside them.
inline std::size_t with_figures(const std::string& section, const std::string& name) {
  std::size_t count = 0;
  for (const ExampleFile& of : example_files())
    if (of.section == section && of.name == name)
      count += static_cast<std::size_t>(
          std::ranges::count_if(of.examples, [](const auto& example) { return !example.figures.empty(); }));
  return count;
}

// Every example of the table holds one vector of the file, and every vector is held here or by figures of its own.
// `look` is called with events, rows and the vector.
template <class Look>
void expect(const std::string& section, const std::string& name, const std::vector<Example>& table, const Look& look) {
  EXPECT_EQ(file(section, name).size(), table.size() + with_figures(section, name)) << section << '/' << name;
  for (const Example& example : table) {
    SCOPED_TRACE(example.comment);
    const spec::Case& c = vector_of(section, name, example.comment);
    hold(c, [&](const auto& events) { look(events, example.rows, c); });
  }
}

}  // namespace toolcomp::corpus::worked
