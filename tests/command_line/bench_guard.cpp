// SPDX-License-Identifier: Apache-2.0
// tests/bench/guard.py on a stand-in for the benchmarks, whose times the tests choose.
#include <gtest/gtest.h>

#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;

// Rows and their nanoseconds as in the file `times` beside it; answers like Google Benchmark.
const std::string kStandIn = R"(#!/usr/bin/env python3
import json, pathlib, re, sys
rows = dict(line.split() for line in pathlib.Path(sys.argv[0]).with_name("times").read_text().splitlines())
options = dict(argument.split("=", 1) if "=" in argument else (argument, "") for argument in sys.argv[1:])
if "--benchmark_list_tests" in options:
    print("\n".join(rows))
else:
    runs = [{"run_name": row, "run_type": "iteration", "items_per_second": 1e9 / float(time), "cpu_time": 1, "time_unit": "ns"}
            for row, time in rows.items() if re.search(options["--benchmark_filter"], row)]
    pathlib.Path(options["--benchmark_out"]).write_text(json.dumps({"benchmarks": runs}))
)";

class BenchGuard : public testing::Test {
 protected:
  BenchGuard() { command("chmod +x " + folder_.write("bench", kStandIn)); }
  Outcome guard(const std::string& times, const std::string& arguments) {
    static_cast<void>(folder_.write(
        "times", "floor/corner_in_the_plane 5\nfloor/corner_in_space 10\nfloor/sine_and_cosine 10\n" + times));
    return command("python3 " TOOLCOMP_SOURCE_DIR "/tests/bench/guard.py --program " + folder_.path("bench") + " " +
                   arguments);
  }
  [[nodiscard]] std::string kept() const { return folder_.path("kept.json"); }

 private:
  Folder folder_;
};

TEST_F(BenchGuard, ARowThatIsTenPercentWorseFails) {
  EXPECT_EQ(guard("cutter_c_lines 50\ntool_side_lines 40\n", "--save " + kept()).status, 0);
  const Outcome same = guard("cutter_c_lines 54\ntool_side_lines 40\n", "--against " + kept());
  EXPECT_EQ(same.status, 0) << same.out << same.err;
  const Outcome worse = guard("cutter_c_lines 56\ntool_side_lines 40\n", "--against " + kept());
  EXPECT_EQ(worse.status, 1);
  // 50 and 56 over the floor in the plane, 5.
  EXPECT_NE(worse.out.find("cutter_c_lines                                   10.00     11.20   +12.0 %  WORSE"),
            std::string::npos)
      << worse.out;
  EXPECT_EQ(guard("cutter_c_lines 56\ntool_side_lines 40\n", "--worse 15 --against " + kept()).status, 0);
}

TEST_F(BenchGuard, ARowThatIsGoneFails) {
  EXPECT_EQ(guard("cutter_c_lines 50\ntool_side_lines 40\n", "--save " + kept()).status, 0);
  EXPECT_EQ(guard("cutter_c_lines 50\n", "--against " + kept()).status, 1);
  EXPECT_EQ(guard("cutter_c_lines 50\ncutter_b 1\n", "--filter cutter --against " + kept()).status, 0);
}

TEST_F(BenchGuard, AFileThatKeepsNoRowsIsRefused) {
  const Outcome missing = guard("cutter_c_lines 50\n", "--against " + kept());
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("kept.json: no rows kept by --save"), std::string::npos) << missing.err;
  EXPECT_EQ(guard("cutter_c_lines 50\n", "--save " + kept()).status, 0);
  EXPECT_EQ(guard("cutter_c_lines 50\n", "--instructions --against " + kept()).status, 2);
  EXPECT_EQ(guard("cutter_c_lines 50\n", "").status, 2);
}

}  // namespace
