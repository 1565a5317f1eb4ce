// SPDX-License-Identifier: Apache-2.0
// Laws of peripheral milling by RL and RR over exact numbers.
#include "tests/property/heidenhain/space_paths.h"

namespace toolcomp::laws {
namespace {

constexpr const char* kPeripheral = "heidenhain/peripheral-milling";

struct Corner {
  Point place;
  Point tool;
};

std::vector<Corner> any_path() {
  std::vector<Corner> path(*rc::gen::inRange<std::size_t>(2, 6));
  const bool turning = *rc::gen::arbitrary<bool>();
  const Point tool = any_direction();
  for (Corner& corner : path) {
    corner.place = any_place();
    corner.tool = turning && *rc::gen::arbitrary<bool>() ? any_direction() : tool;
  }
  return path;
}

std::string program(const std::vector<Corner>& path, const char* side) {
  std::string text = "L X+0 Y+0 Z+0 R0\n";
  for (std::size_t i = 0; i < path.size(); ++i)
    text += "LN" + words("", path[i].place) + words("T", path[i].tool) + (i == 0 ? std::string(" ") + side : "") + "\n";
  return text + "L Z+100 R0\n";
}

// No corner that cannot be: every event is a move or a warning.
bool runs(const spec::Case& c) {
  const auto events = judge::run_model(c).events;
  return !events.empty() && events.back().kind == EventKind::move;
}

// P11: the other side is the opposite vector.
RC_GTEST_PROP(LawsOfPeripheralMilling, TheOtherSideIsOpposite, ()) {
  const Cutter tool = any_cutter();
  const Mode mode{.center = *rc::gen::arbitrary<bool>(), .contour = *rc::gen::arbitrary<bool>()};
  const std::vector<Corner> path = any_path();
  const spec::Case left = make(kPeripheral, tool, mode, program(path, "RL"));
  RC_PRE(runs(left));
  const std::vector<Moved> a = moved(left);
  const std::vector<Moved> b = moved(make(kPeripheral, tool, mode, program(path, "RR")));
  const std::vector<Moved> none = moved(make(kPeripheral, tool, mode, program(path, "R0")));
  RC_ASSERT(a.size() == b.size());
  RC_ASSERT(a.size() == none.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    RC_ASSERT(same(a[i].shift + b[i].shift, none[i].shift + none[i].shift));
    // Uncompensated blocks keep the reference point, under IS CONTOUR compensated ones do not.
    if (!(mode.center && mode.contour)) RC_ASSERT(same(a[i].tip + b[i].tip, none[i].tip + none[i].tip));
  }
}

// The vector at a corner stands on the tool and is as far from both programmed lines as the delta.
RC_GTEST_PROP(LawsOfPeripheralMilling, CornersLieOnBothOffsetLines, ()) {
  const Cutter tool = any_cutter();
  const std::vector<Corner> path = any_path();
  const spec::Case c = make(kPeripheral, tool, {}, program(path, "RL"));
  RC_PRE(runs(c));
  const std::vector<Moved> moves = moved(c);
  RC_ASSERT(moves.size() == path.size() + 2);
  // moves[0] approaches, moves[1] is the first compensated block: it has the direction of the next one alone.
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec vector = moves[i + 1].tip - moves[i + 1].programmed;
    RC_ASSERT(equal(dot(vector, moves[i + 1].tool), Real(0)));
    const bool inner = i > 0 && i + 1 < path.size();
    const auto at_distance = [&](const Point& from, const Point& to) {
      const Point across = cross(path[i].tool, sum(to, Rational(-1) * from));
      if (dot(across, across) == 0) return;
      RC_ASSERT(equal(dot(vector, unit(across)), Real(tool.dr)));
    };
    if (i > 0) at_distance(path[i - 1].place, path[i].place);
    if (inner || (i == 0 && path.size() > 1)) at_distance(path[i].place, path[i + 1].place);
  }
}

// P8
RC_GTEST_PROP(LawsOfPeripheralMilling, RotationsOfSpace, ()) {
  const Cutter tool = any_cutter();
  const Mode mode{.center = *rc::gen::arbitrary<bool>(), .contour = *rc::gen::arbitrary<bool>()};
  const std::vector<Corner> path = any_path();
  const Rotation turn = any_rotation();
  std::vector<Corner> turned = path;
  for (Corner& corner : turned) corner = {turn(corner.place), Rational(1, 10) * turn(corner.tool)};
  const spec::Case c = make(kPeripheral, tool, mode, program(path, "RR"));
  RC_PRE(runs(c));
  const std::vector<Moved> a = moved(c);
  const std::vector<Moved> b = moved(make(kPeripheral, tool, mode, program(turned, "RR")));
  RC_ASSERT(a.size() == b.size());
  // The blocks before and behind the path are not turned, nor is the direction in which it is left.
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    RC_ASSERT(same(turn(a[i].tip), b[i].tip));
    RC_ASSERT(same(turn(a[i].shift), b[i].shift));
    RC_ASSERT(same(turn(a[i].axes), b[i].axes));
  }
}

}  // namespace
}  // namespace toolcomp::laws
