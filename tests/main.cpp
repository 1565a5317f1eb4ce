// SPDX-License-Identifier: Apache-2.0
// The main of every test program: GoogleTest's, and after each test the processor time that it took, with the processes
// that it waited for. tests/costs adds these lines up.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>

namespace {

double seconds_of(int who) {
  rusage used{};
  if (getrusage(who, &used) != 0) return 0;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// User and system.
double processor_seconds() { return seconds_of(RUSAGE_SELF) + seconds_of(RUSAGE_CHILDREN); }

class Costs : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override { start_ = processor_seconds(); }
  void OnTestEnd(const testing::TestInfo& test) override {
    std::printf("cost of %s.%s: %.2f s of a processor\n", test.test_suite_name(), test.name(),
                processor_seconds() - start_);
  }

  double start_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new Costs);  // which owns it
  return RUN_ALL_TESTS();
}
