// SPDX-License-Identifier: Apache-2.0
// The example programs of 3D tool compensation under both engines: what the README beside them says, by hand. A contact
// of the strip is q = 20 N; nominal ball 3, effective ball r, t = T: centre q + r N, tip q + r N - r T.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "model/basis/print.h"
#include "spec/language/byte_source.h"
#include "spec/language/setup_format.h"
#include "tests/golden/heidenhain/space_rows.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

// The program and the setup beside it.
spec::Case example(const std::string& program) {
  const fs::path path = fs::path(TOOLCOMP_SOURCE_DIR) / "examples/heidenhain" / program;
  spec::Case c;
  c.section = "heidenhain/face-milling";
  c.dialect = "klartext";
  c.setup = spec::read_setup_toml(spec::read_file(path.parent_path() / "setup.toml"), "setup.toml");
  c.program = spec::read_file(path);
  return c;
}

// The rows hold the events of their lines; others are not looked at. Every event is a move.
void expect(const std::string& program, std::size_t moves, const space::Rows& rows) {
  SCOPED_TRACE(program);
  const spec::Case c = example(program);
  const judge::ModelRun run = judge::run_model(c);
  const std::vector<fast::Event> fast = judge::run_fast(c);
  std::vector<spec::TextEvent> model;
  for (const model::Event& event : run.events) model.push_back(model::text_event(event, 15));
  const auto look = [&](const auto& events) {
    EXPECT_EQ(events.size(), moves);
    for (const std::string& row : rows) {
      SCOPED_TRACE(row);
      const auto found =
          std::ranges::find_if(events, [&](const auto& event) { return row.starts_with(space::head(event) + ' '); });
      ASSERT_NE(found, events.end());
      space::expect_move(*found, rows::tokens(row), c.setup.axes);
    }
  };
  look(model);
  look(fast);
  for (const auto& event : model) EXPECT_EQ(event.kind, spec::EventKind::move) << event.line;
}

const std::string kRest = " feed=800";

TEST(HeidenhainExamples, ReworkedBall) {
  // The second and the fifth point; 0.1 of carrier: tip + 80 T.
  expect("reworked-ball-at-tip/reworked.h", 11,
         {"9 programmed at=-13.8,-0.84,15.52 contact=-12,0,16 center=-13.74,0,18.32 tip=-13.74,-0.812,15.536 "
          "shift=0.06,0.028,0.016 carrier=-13.74,21.588,92.336" +
              kRest,
          "11 programmed contact=0,0,20 center=0,0,22.9 tip=0,-0.812,20.116 carrier=0,21.588,96.916" + kRest});
  expect("reworked-ball-at-center/reworked.h", 11,
         {"10 programmed at=-13.8,0,18.4 contact=-12,0,16 center=-13.74,0,18.32 tip=-13.74,-0.812,15.536 "
          "shift=0.06,0.028,0.016 carrier=-13.74,21.588,92.336" +
              kRest,
          "12 programmed contact=0,0,20 center=0,0,22.9 tip=0,-0.812,20.116 carrier=0,21.588,96.916" + kRest});
}

TEST(HeidenhainExamples, Oversize) {
  const std::string figures =
      " contact=-12,0,16 center=-13.92,0,18.56 tip=-13.92,-0.896,15.488 axes=-13.92,-0.84,15.68 tool=-0.12,0,0.16 "
      "carrier=-13.92,21.56,92.48" +
      kRest;
  expect("oversize-at-tip/oversize.h", 11, {"10 programmed at=-13.8,-0.84,15.52" + figures});
  expect("oversize-at-center/oversize.h", 11, {"11 programmed at=-13.8,0,18.4" + figures});
}

TEST(HeidenhainExamples, OnTheContour) {
  expect("ball-on-contour/contour.h", 9,
         {"10 programmed at=-12,0,16 contact=-12,0,16 center=-13.74,0,18.32 tip=-13.74,-0.812,15.536 "
          "carrier=-13.74,21.588,92.336" +
          kRest});
}

TEST(HeidenhainExamples, Flank) {
  // The carrier is tip + 90 T.
  const std::string shifted = " tip=60,9.904,-0.028 shift=0,-0.096,-0.028 carrier=60,-15.296,86.372 feed=1000";
  expect("reworked-end-mill-flank/flank.h", 14,
         {"10 programmed contact=60,4.24,-1.68" + shifted, "15 programmed" + shifted,
          "14 start-up tip=-20,9.904,-0.028 carrier=-20,-15.296,86.372 feed=1000"});
}

}  // namespace
}  // namespace toolcomp::corpus
