// SPDX-License-Identifier: Apache-2.0
// The one mistake behind many findings: lies told on purpose, each in several programs, and what they are called.
#include "certify/causes/shared_cause.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "certify/convert.h"
#include "fuzz/gen/generator.h"

namespace toolcomp::certify {
namespace {

using Events = std::vector<spec::Event<double>>;

spec::Case program(const std::string& text) {
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.setup.h[1] = {spec::decimal(20), *spec::parse_decimal("0.5")};
  c.setup.h[2] = {spec::decimal(7), {}};
  c.setup.d[1] = {spec::decimal(3), {}};
  c.program = text;
  return c;
}

const std::vector<std::string> kPrograms{
    "G43 Z100. H1\nG41 G01 X10. Y5.25 D1 F300\nX40.\nY30. Z-2.125\nX-7.5\nG40 X0. Y0.\n",
    "G00 X3.7 Y-1.\nG43 Z5. H2\nG42 G01 X20. D1 F80\nX33. Y12.\nX5.1 Y50.\nG40 Y80.\nG49 Z200.\n",
    "G44 Z-12.5 H2\nG01 X2. F1000\nG91 X1.5 Y2.5\nZ-4.25\n"};

Events events_of(const spec::Case& c) {
  Events events;
  for (const model::Event& event : judge::run_model(c).events) events.push_back(in_double(event));
  return events;
}

Finding finding(const spec::Case& c, Events actual) {
  Finding f;
  f.smallest = c;
  f.key = {c.section, "", "coordinate"};
  f.difference.field = "axes.X";
  f.actual_events = std::move(actual);
  return f;
}

// What the lie is called, told in all programs; and in how many it explains everything.
std::string named(const std::function<void(Events&)>& lie) {
  std::vector<Finding> findings;
  for (const std::string& text : kPrograms) {
    const spec::Case c = program(text);
    Events actual = events_of(c);
    lie(actual);
    findings.push_back(finding(c, std::move(actual)));
  }
  const std::vector<SharedCause> causes = shared_causes(findings);
  if (causes.empty()) return "nothing";
  EXPECT_EQ(causes.front().findings.size(), findings.size()) << causes.front().words;
  EXPECT_EQ(causes.size(), 1U);
  return causes.front().words;
}

std::function<void(Events&)> positions(const std::function<void(spec::AxisValues<double>&)>& lie) {
  return [lie](Events& events) {
    for (spec::Event<double>& event : events)
      if (event.kind == spec::EventKind::move) lie(event.axes);
  };
}

TEST(SharedCause, ConstantsAndFactors) {
  EXPECT_EQ(named(positions([](auto& at) { at.value[0] += 0.000001; })), "axes.X is off by 1e-06");
  EXPECT_EQ(named(positions([](auto& at) { at.value[2] -= 1.5; })), "axes.Z is off by -1.5");
  EXPECT_EQ(named(positions([](auto& at) { at.value[1] *= -1; })), "axes.Y has the opposite sign");
  EXPECT_EQ(named(positions([](auto& at) { at.value[2] *= 1.001; })), "axes.Z is scaled by 1.001");
  EXPECT_EQ(named(positions([](auto& at) {
              for (double& x : at.value) x /= 25.4;
            })),
            "axes is in inches instead of millimetres (÷ 25.4)");
  EXPECT_EQ(named([](Events& events) {
              for (auto& event : events)
                if (event.feed) event.feed = *event.feed * 2;
            }),
            "feed is scaled by 2");
}

TEST(SharedCause, AxesBlocksAndEvents) {
  EXPECT_EQ(named([](Events& events) {
              for (auto& event : events)
                for (auto* at : {&event.programmed, &event.point, &event.axes}) std::swap(at->value[0], at->value[1]);
            }),
            "X and Y are exchanged");
  EXPECT_EQ(named([](Events& events) {
              for (std::size_t i = events.size(); i-- > 1;) {
                events[i].programmed = events[i - 1].programmed;
                events[i].point = events[i - 1].point;
                events[i].axes = events[i - 1].axes;
              }
            }),
            "positions come one block late");
  EXPECT_EQ(named([](Events& events) { events.pop_back(); }), "the last event is missing");
}

// Without an announced resolution.
TEST(SharedCause, Roundings) {
  const auto all = [](double (*round)(double)) {
    return [=](Events& events) {
      for (auto& event : events)
        for (auto* at : {&event.programmed, &event.point, &event.axes})
          for (double& x : at->value) x = round(x * 10) / 10;
    };
  };
  EXPECT_EQ(named(all([](double x) { return std::round(x); })), "numbers look rounded to 1 decimals, to nearest");
  EXPECT_EQ(named(all([](double x) { return std::floor(x); })), "numbers look rounded to 1 decimals, down");
  EXPECT_EQ(named(all([](double x) { return std::trunc(x); })), "numbers look rounded to 1 decimals, toward zero");
}

// Offsets and sides that are others: the model, given them, says what came.
TEST(SharedCause, OffsetsAndSides) {
  const auto named_with = [](const std::function<void(spec::Case&)>& change) {
    std::vector<Finding> findings;
    for (const std::string& text : {kPrograms[0], kPrograms[1]}) {
      spec::Case other = program(text);
      change(other);
      findings.push_back(finding(program(text), events_of(other)));
    }
    const auto causes = shared_causes(findings);
    if (causes.empty()) return std::string("nothing");
    EXPECT_EQ(causes.front().findings.size(), 2U);
    return causes.front().words;
  };
  EXPECT_EQ(named_with([](spec::Case& c) {
              for (auto* table : {&c.setup.h, &c.setup.d})
                for (auto& [n, entry] : *table) {
                  entry.geometry.negative = !entry.geometry.negative;
                  entry.wear.negative = !entry.wear.negative;
                }
            }),
            "offsets have the opposite sign");
  EXPECT_EQ(named_with([](spec::Case& c) {
              for (auto* table : {&c.setup.h, &c.setup.d})
                for (auto& [n, entry] : *table) entry = {};
            }),
            "offsets count as 0");
}

TEST(SharedCause, FaultsOfOneKind) {
  std::vector<Finding> findings;
  for (const std::string& text : kPrograms) {
    Finding f = finding(program(text), {});
    f.key.kind = "crash";
    f.difference.actual = "ended before it answered: killed by signal 11 (Segmentation fault)";
    findings.push_back(f);
  }
  findings.push_back(findings[0]);
  findings.back().key.kind = "malformed reply";
  findings.back().difference.actual = "reply: without id: \"{...}\"";
  const auto causes = shared_causes(findings);
  ASSERT_EQ(causes.size(), 2U);
  EXPECT_EQ(causes[0].words, "crash: ended before it answered: killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(causes[0].findings.size(), 3U);
  EXPECT_EQ(causes[1].words, "malformed reply: reply: without id");
}

// Two mistakes are two causes; what nothing explains stands with none.
TEST(SharedCause, TwoMistakesAndOneWithoutName) {
  std::vector<Finding> findings;
  for (const std::string& text : kPrograms) {
    const spec::Case c = program(text);
    Events off = events_of(c);
    for (auto& event : off) event.axes.value[0] += 0.25;
    Events wild = events_of(c);
    for (std::size_t i = 0; i < wild.size(); ++i) wild[i].axes.value[1] += std::sin(static_cast<double>(i + 1));
    findings.push_back(finding(c, std::move(off)));
    findings.push_back(finding(c, std::move(wild)));
  }
  const auto causes = shared_causes(findings);
  ASSERT_EQ(causes.size(), 2U);
  EXPECT_EQ(causes[0].words, "axes.X is off by 0.25");
  EXPECT_EQ(causes[0].findings, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(causes[1].words, "not explained: coordinate of axes");
  EXPECT_EQ(causes[1].findings, (std::vector<std::size_t>{1, 3, 5}));
}

}  // namespace
}  // namespace toolcomp::certify
