// SPDX-License-Identifier: Apache-2.0
// Answers and recordings that are wrong, judged with one intermediate of the judges after another made NaN or an
// infinity: none of them may be certified. Linked by poison.py with judges in which that can be done.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

#include "certify/judge.h"
#include "certify/trace/trace.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"
#include "spec/language/input_error.h"
#include "tests/mutants/poisoned.h"

namespace {

using namespace toolcomp;

// A question to a judge, and whether it certified what it was given.
struct Question {
  std::string name;
  std::function<bool()> certified;
  std::set<int> reached;
};

// What the fast engine says, and the same with every position off by a hundredth.
std::vector<fast::Event> moved(std::vector<fast::Event> events, double by) {
  for (fast::Event& event : events)
    for (auto* values : {&event.point, &event.axes})
      for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
        if (values->has(i)) values->set(i, (*values)[i] + by);
  return events;
}

void add_answers(std::vector<Question>& right, std::vector<Question>& wrong) {
  constexpr std::uint64_t kCases = 25;
  for (const std::string_view section : fuzz::sections())
    for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
      fuzz::SeededSource source(seed);
      auto c = std::make_shared<spec::Case>(fuzz::generate(section, fuzz::Mode::directed, source));
      try {
        auto run = std::make_shared<judge::ModelRun>(judge::run_model(*c));
        const auto events = judge::run_fast(*c);
        const auto judged = [c, run](const std::vector<fast::Event>& answer, const judge::JudgeOptions& how) {
          return certify::judged(judge::judge(*c, *run, answer, how)).result == certify::Result::agrees;
        };
        judge::JudgeOptions rounds;
        rounds.resolution = {0.001, 0.0001, 0.001, 0.001, judge::Rounding::unknown};
        for (const judge::JudgeOptions& how : {judge::JudgeOptions{}, rounds}) {
          const std::string name = fmt::format("{} seed {}", section, seed);
          if (!judged(events, how) || judged(moved(events, 0.01), how)) continue;
          right.push_back({name, [=] { return judged(events, how); }, {}});
          for (const double by : {0.01, 1e6, std::numeric_limits<double>::quiet_NaN()})
            wrong.push_back({name, [=] { return judged(moved(events, by), how); }, {}});
        }
      } catch (const spec::InputError&) {
        continue;
      }
    }
}

void add_recordings(std::vector<Question>& right, std::vector<Question>& wrong) {
  auto c = std::make_shared<spec::Case>();
  c->program = "G17 G01 X10 F100\nG03 X20 Y10 J10\nG01 Y20 B20\nX0 Y0\n";
  c->setup.axes = spec::Axes("XYZB");
  const auto judged = [c](double off, bool whole) {
    std::string csv = "t,X,Y,Z,B\n";
    double time = 0;
    const auto add = [&](double x, double y, double b) {
      csv += fmt::format("{},{},{},0,{}\n", time += 0.01, x + off, y, b);
    };
    for (int i = 0; i <= 10; ++i) add(i, 0, 0);
    for (int i = 1; i <= 90; ++i) add(10 + 10 * std::sin(i * M_PI / 180), 10 - 10 * std::cos(i * M_PI / 180), 0);
    for (int i = 1; i <= 10; ++i) add(20, 10 + i, 2 * i);
    if (whole)
      for (int i = 1; i <= 20; ++i) add(20 - i, 20 - i, 20);
    std::istringstream stream(csv);
    certify::TraceOptions options;
    options.tolerance = 0.05;
    options.rotary_tolerance = 0.1;
    return certify::exit_status(certify::judge_trace(*c, stream, "recording", options)) == 0;
  };
  right.push_back({"recording", [=] { return judged(0, true); }, {}});
  for (const double off : {1.0, 0.1, 1e8})
    wrong.push_back({fmt::format("recording off by {}", off), [=] { return judged(off, true); }, {}});
  wrong.push_back({"recording cut off", [=] { return judged(0, false); }, {}});
}

bool asked(const Question& question) {
  try {
    return question.certified();
  } catch (const std::exception&) {
    return false;  // refused, or nothing could be decided
  }
}

bool certified_at(int place, const std::vector<const Question*>& list) {
  const rlimit seconds{20, 20};
  const rlimit bytes{rlim_t{3} << 30, rlim_t{3} << 30};
  ::setrlimit(RLIMIT_CPU, &seconds);
  ::setrlimit(RLIMIT_AS, &bytes);
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()})
    for (const Question* question : list) {
      poison::chosen = place;
      poison::instead = value;
      const bool certified = asked(*question);
      poison::chosen = -1;
      if (!certified) continue;
      fmt::print("place {} as {}: certified {}\n", place, value, question->name);
      fflush(stdout);
      return true;
    }
  return false;
}

}  // namespace

int main() {
  std::vector<Question> right;
  std::vector<Question> wrong;
  add_answers(right, wrong);
  add_recordings(right, wrong);
  for (const Question& question : right)
    if (!asked(question)) return fmt::print("{}: is right and not certified\n", question.name), 2;
  std::map<int, std::vector<const Question*>> questions;
  constexpr std::size_t kEach = 12;
  for (Question& question : wrong) {
    poison::reached = &question.reached;
    if (asked(question)) return fmt::print("{}: is wrong and certified\n", question.name), 2;
    for (const int place : question.reached)
      if (questions[place].size() < kEach) questions[place].push_back(&question);
  }
  poison::reached = nullptr;
  int bad = 0;
  int ended = 0;
  for (const auto& [place, list] : questions) {
    // Each place in a process of its own: with such a number a judge may think for ever, or fill the memory.
    fflush(stdout);
    const pid_t child = ::fork();
    if (child == 0) ::_exit(certified_at(place, list) ? 1 : 0);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFEXITED(status))
      bad += WEXITSTATUS(status) == 1 ? 1 : 0;
    else
      ++ended, fmt::print("place {} ended by signal {}\n", place, WTERMSIG(status));
  }
  fmt::print(
      "{} places reached, {} wrong answers and recordings; at {} places one was certified, at {} the judge did not "
      "end\n",
      questions.size(), wrong.size(), bad, ended);
  return bad == 0 && questions.size() >= 60 ? 0 : 1;
}
