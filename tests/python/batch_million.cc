// SPDX-License-Identifier: Apache-2.0
// Lines through fast::Batch from C++: seconds of each run, a line each, for tests/python/bench_batch.py.
// batch_million WORDS FILE HEAD SETUP RUNS CHUNKS: FILE has the columns of the words, "XYZ", doubles as they lie in
// memory; lines are given in so many parts, and the memory of the moves of one is used again for the next.
#include <chrono>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fast/batch/batch.h"
#include "spec/language/byte_source.h"
#include "spec/language/setup_format.h"

int main(int count, char** given) {
  const std::vector<std::string> arguments(given, given + count);
  if (arguments.size() != 7) return 2;
  const std::string& words = arguments[1];
  const std::string bytes = toolcomp::spec::read_file(arguments[2]);
  std::vector<double> values(bytes.size() / sizeof(double));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  const std::size_t lines = values.size() / words.size();
  const toolcomp::spec::Setup setup = toolcomp::spec::read_setup_toml(arguments[4], "setup");
  std::vector<toolcomp::fast::WordColumn> columns;
  for (std::size_t i = 0; i < words.size(); ++i) columns.push_back({std::string_view(words).substr(i, 1), {}, 3});
  const std::size_t size = lines / std::stoul(arguments[6]);
  for (int run = std::stoi(arguments[5]); run > 0; --run) {
    const auto begun = std::chrono::steady_clock::now();
    toolcomp::fast::Batch batch(setup);
    batch.run(arguments[3]);
    std::size_t moves = 0;
    for (std::size_t first = 0; first < lines; first += size) {
      for (std::size_t i = 0; i < words.size(); ++i)
        columns[i].values = std::span(values).subspan(i * lines + first, size);
      batch.moves().clear();
      batch.lines(columns);
      if (first + size == lines) batch.end();
      moves += batch.moves().size();
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begun;
    if (moves + 2 < lines) return 1;
    std::cout << seconds.count() << '\n';
  }
  return 0;
}
