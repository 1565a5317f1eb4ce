// SPDX-License-Identifier: Apache-2.0
// The bounds of spec/formal/rounding: what they quote is the engine as it is, what is refuted of them was measured, and
// the policy names them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/corner.h"
#include "fast/heidenhain/program/tool_vector.h"
#include "fast/kinematics/direction.h"
#include "judge/oracle/policy.h"
#include "tests/effort.h"

namespace {

namespace fs = std::filesystem;
namespace fast = toolcomp::fast;
namespace klartext = toolcomp::fast::klartext;
namespace policy = toolcomp::judge::policy;

const fs::path kSource = TOOLCOMP_SOURCE_DIR;
const fs::path kScripts = kSource / "spec/formal/rounding";

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Any white space as one blank, so that a statement may be broken elsewhere.
std::string joined(const std::string& text) {
  std::istringstream in(text);
  std::string all;
  for (std::string word; in >> word;) all += (all.empty() ? "" : " ") + word;
  return all;
}

// What a script says about itself.
struct Script {
  std::map<std::string, std::vector<std::string>> quoted;  // by file
  std::map<std::string, std::string> field;
};

Script script_of(const std::string& text) {
  static const std::regex kFile("# code: (.*)");
  static const std::regex kQuote("#   (.*)");
  static const std::regex kField("# ([a-z]+): (.*)");
  Script script;
  std::string file;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (std::regex_match(line, match, kFile))
      file = match[1];
    else if (!file.empty() && std::regex_match(line, match, kQuote))
      script.quoted[file].push_back(match[1]);
    else
      file.clear();
    if (file.empty() && std::regex_match(line, match, kField)) script.field[match[1]] = match[2];
  }
  return script;
}

// Statements that do not stand in the source of the engine.
std::vector<std::string> drifted(const Script& script, const std::function<std::string(const std::string&)>& source) {
  std::vector<std::string> faults;
  for (const auto& [file, lines] : script.quoted) {
    const std::string text = joined(source(file));
    for (const std::string& line : lines)
      if (text.find(joined(line)) == std::string::npos) faults.push_back(file + ": " + line);
  }
  return faults;
}

std::map<std::string, Script> scripts() {
  std::map<std::string, Script> found;
  for (const auto& entry : fs::directory_iterator(kScripts)) {
    const std::string extension = entry.path().extension();
    if (extension != ".gappa" && extension != ".v") continue;
    Script script = script_of(read(entry.path()));
    // Coq proves one formula by itself; its other files are about real numbers.
    if (extension == ".gappa" || !script.quoted.empty()) found[entry.path().stem().string()] = std::move(script);
  }
  return found;
}

// 210b-57 in units of 2^-53.
double in_roundings(const std::string& bound) {
  static const std::regex kBound("([0-9]+)b-57");
  std::smatch match;
  EXPECT_TRUE(std::regex_match(bound, match, kBound)) << bound;
  return match.empty() ? 0 : std::stod(match[1]) / 16;
}

TEST(Architecture, BoundsOfRoundingQuoteTheEngine) {
  const std::map<std::string, Script> all = scripts();
  EXPECT_GE(all.size(), 14U);
  for (const auto& [name, script] : all) {
    EXPECT_FALSE(script.quoted.empty()) << name;
    for (const auto& [file, lines] : script.quoted) EXPECT_TRUE(file.starts_with("fast/")) << name << ": " << file;
    for (const std::string& fault : drifted(script, [](const std::string& file) { return read(kSource / file); }))
      ADD_FAILURE() << name << " quotes what does not stand in " << fault;
    for (const char* field : {"ranges", "proves", "bound", "refuted", "facts"})
      EXPECT_TRUE(script.field.contains(field)) << name << ": " << field;
  }
}

TEST(Architecture, ThePolicyNamesBoundsOfRounding) {
  const std::map<std::string, Script> all = scripts();
  std::set<std::string> named;
  for (const policy::Budget& row : policy::kBudgets) {
    std::istringstream in{std::string(row.proved)};
    for (std::string name; in >> name;) {
      EXPECT_TRUE(all.contains(name)) << row.section << ": " << name;
      named.insert(name);
    }
  }
  for (const auto& [name, script] : all)
    for (const auto& [other, facts] : all)
      if (facts.field.at("facts").find(name + ".gappa") != std::string::npos) named.insert(name);
  for (const auto& [name, script] : all) EXPECT_TRUE(named.contains(name)) << name << " is of no use";
}

// The constants of sines and cosines, as Polynomials.v says them.
TEST(Architecture, PolynomialsHaveTheConstantsOfTheEngine) {
  const std::string source = read(kSource / "fast/arithmetic/trigonometry.cpp");
  const std::string coq = read(kScripts / "Polynomials.v");
  static const std::regex kFraction(R"(Definition ([a-z][a-z0-9]) := (-?[0-9]+) / 2 \^ ([0-9]+)\.)");
  const std::map<std::string, std::string> names{{"kh", "kRadiansHigh"}, {"kl", "kRadiansLow"}};
  int seen = 0;
  for (auto it = std::sregex_iterator(coq.begin(), coq.end(), kFraction); it != std::sregex_iterator(); ++it, ++seen) {
    const std::string name = names.contains((*it)[1]) ? names.at((*it)[1]) : (*it)[1].str();
    std::smatch constant;
    ASSERT_TRUE(std::regex_search(source, constant, std::regex("constexpr double " + name + " = ([^;]*);"))) << name;
    EXPECT_EQ(std::strtod(constant[1].str().c_str(), nullptr),
              std::ldexp(static_cast<double>(std::stoll((*it)[2])), -std::stoi((*it)[3])))
        << name;
  }
  EXPECT_EQ(seen, 14);
}

TEST(BoundsOfRounding, DriftIsSeen) {
  const Script script = script_of(
      "# A vector.\n#\n# code: fast/a.h\n#   return a +  b;\n#   c = 2;\n#\n# bound: 210b-57\n# facts: one, two\n");
  EXPECT_EQ(script.field.at("bound"), "210b-57");
  EXPECT_EQ(script.field.at("facts"), "one, two");
  EXPECT_FALSE(script.field.contains("refuted"));
  const auto faults = [&](const std::string& text) {
    return drifted(script, [&](const auto&) { return text; }).size();
  };
  EXPECT_EQ(faults("int f() {\n  return a\n      + b;\n}\nc = 2;"), 0U);
  EXPECT_EQ(faults("return b + a; c = 2;"), 1U);
  EXPECT_EQ(faults(""), 2U);
}

// The worst of many random numbers, in units of 2^-53, against long double: it lies between what a script refutes and
// what it proves, so neither is vacuous.
class Measured : public testing::Test {
 protected:
  using Wide = long double;
  static inline const int kCases = static_cast<int>(toolcomp::test::random_cases(100'000));

  void note(const std::string& name, Wide off) {
    double& worst = worst_[name];
    worst = std::max(worst, static_cast<double>(std::fabs(off)) * 0x1p53);
  }
  void TearDown() override {
    const std::map<std::string, Script> all = scripts();
    for (const auto& [name, worst] : worst_) {
      RecordProperty(name, std::to_string(worst));
      const Script& script = all.at(name);
      EXPECT_LE(worst, in_roundings(script.field.at("bound"))) << name;
      EXPECT_GT(worst, in_roundings(script.field.at("refuted"))) << name;
    }
  }
  // Of any number of digits.
  std::int64_t whole(std::int64_t limit) {
    const auto size = static_cast<std::int64_t>(
        std::pow(static_cast<double>(limit), std::uniform_real_distribution<double>(0, 1)(random_)));
    return std::uniform_int_distribution<std::int64_t>(-size, size)(random_);
  }
  // Of length 1, nearly, by words of 8 decimals.
  klartext::WholeVector normalized() {
    klartext::WholeVector v;
    const double a = angle(), b = angle();
    const double size = 1e8 * std::uniform_real_distribution<double>(0.99995, 1.00005)(random_);
    v.small = {std::llround(size * std::cos(a) * std::cos(b)), std::llround(size * std::sin(a) * std::cos(b)),
               std::llround(size * std::sin(b))};
    return v;
  }
  double angle() { return std::uniform_real_distribution<double>(-180, 180)(random_); }

  std::mt19937_64 random_{1};
  std::map<std::string, double> worst_;
};

static_assert(std::numeric_limits<long double>::digits >= 64);

TEST_F(Measured, Corners) {
  constexpr std::int64_t kLimit = (std::int64_t{1} << 31) - 1;
  for (int i = 0; i < kCases; ++i) {
    const std::int64_t x1 = whole(kLimit), y1 = whole(kLimit), x2 = whole(kLimit), y2 = whole(kLimit);
    const std::int64_t c = x1 * y2 - y1 * x2;
    const std::int64_t k = x1 * x2 + y1 * y2;
    if (c == 0) continue;
    const fast::Heading first = fast::whole_heading({x1, y1});
    const fast::Heading second = fast::whole_heading({x2, y2});
    const double r = std::uniform_real_distribution<double>(1, 2)(random_);
    const fast::Vector2<double> v = fast::where_tangents_meet(first, fast::turn(first, second), r);
    const auto length = [](std::int64_t x, std::int64_t y) { return std::sqrt(Wide(x) * Wide(x) + Wide(y) * Wide(y)); };
    const Wide n1 = length(x1, y1);
    const Wide norms = n1 * length(x2, y2);
    const Wide t = k >= 0 ? Wide(c) / (norms + Wide(k)) : (norms - Wide(k)) / Wide(c);
    const Wide size = Wide(r) * std::sqrt(1 + t * t);
    const std::string name = k >= 0 ? "corner_ahead" : "corner_back";
    note(name, (v.x - (-Wide(y1) - Wide(x1) * t) / n1 * Wide(r)) / size);
    note(name, (v.y - (Wide(x1) - Wide(y1) * t) / n1 * Wide(r)) / size);
  }
}

TEST_F(Measured, Directions) {
  for (int i = 0; i < kCases; ++i) {
    const std::int64_t x = whole(1LL << 30), y = whole(1LL << 30), z = whole(1LL << 30);
    if ((x != 0) + (y != 0) + (z != 0) < 2) continue;
    fast::Direction direction;
    fast::set_small_direction(direction, x, y, z);
    const Wide n = std::sqrt(Wide(x) * Wide(x) + Wide(y) * Wide(y) + Wide(z) * Wide(z));
    note("direction_by_words", direction.unit[0] - Wide(x) / n);
    note("direction_by_words", direction.unit[2] - Wide(z) / n);
  }
}

// As vector_along() writes it, which is not public.
TEST_F(Measured, Perpendiculars) {
  for (int i = 0; i < kCases; ++i) {
    const double x = static_cast<double>(whole(1LL << 60)), y = static_cast<double>(whole(1LL << 60));
    if (x == 0 || y == 0) continue;
    const double r = std::uniform_real_distribution<double>(1, 2)(random_);
    const double factor = r / std::sqrt(x * x + y * y);
    const Wide exact = Wide(x) * Wide(r) / std::sqrt(Wide(x) * Wide(x) + Wide(y) * Wide(y));
    note("perpendicular", (x * factor - exact) / exact);
  }
}

// As CompensationVector and LeadingEdgeOffset write it, which need a machine.
TEST_F(Measured, LeadingEdges) {
  for (int i = 0; i < kCases; ++i) {
    const Eigen::Vector3d m(static_cast<double>(whole(1LL << 30)), static_cast<double>(whole(1LL << 30)),
                            static_cast<double>(whole(1LL << 30)));
    fast::Direction direction;
    const std::int64_t x = whole(1LL << 30), y = whole(1LL << 30), z = whole(1LL << 30);
    if ((x != 0) + (y != 0) + (z != 0) < 2 || m.isZero()) continue;
    fast::set_small_direction(direction, x, y, z);
    const Eigen::Vector3d c = m.cross(direction.unit);
    if (4 * c.squaredNorm() < m.squaredNorm()) continue;
    const double r = std::uniform_real_distribution<double>(1, 2)(random_);
    const Eigen::Vector3d backward = c.cross(direction.unit);
    const Eigen::Vector3d vector = backward * (r / backward.norm());

    using Exact = Eigen::Matrix<Wide, 3, 1>;
    const Exact way = m.cast<Wide>();
    const Exact tool = Exact(Wide(x), Wide(y), Wide(z)).normalized();
    const Exact across = way.cross(tool);
    const Exact off = vector.cast<Wide>() - across.cross(tool).normalized() * Wide(r);
    note("LeadingEdge", off.norm() / Wide(r) * (across.norm() / way.norm()));
  }
}

// As ToolPlane and SideGeometry write it, which need a machine.
TEST_F(Measured, SideNormals) {
  for (int i = 0; i < kCases; ++i) {
    const std::array<std::int64_t, 3> way{whole(1LL << 30), whole(1LL << 30), whole(1LL << 30)};
    const std::array<std::int64_t, 3> tool{whole(1LL << 30), whole(1LL << 30), whole(1LL << 30)};
    if ((tool[0] != 0) + (tool[1] != 0) + (tool[2] != 0) < 2) continue;
    fast::Direction direction;
    fast::set_small_direction(direction, tool[0], tool[1], tool[2]);
    const fast::Vector3<double> travel{static_cast<double>(way[0]), static_cast<double>(way[1]),
                                       static_cast<double>(way[2])};
    const fast::Vector3<double> v{direction.unit[0], direction.unit[1], direction.unit[2]};
    const fast::Vector3<double> left = fast::cross(v, travel);
    const double square = fast::dot(left, left);
    if (square == 0 || 4 * square < fast::dot(travel, travel)) continue;
    const double r = std::uniform_real_distribution<double>(1, 2)(random_);
    const fast::Vector3<double> vector = left * (1 / std::sqrt(square)) * r;

    using Exact = Eigen::Matrix<Wide, 3, 1>;
    const Exact exact_way{Wide(way[0]), Wide(way[1]), Wide(way[2])};
    const Exact across = Exact{Wide(tool[0]), Wide(tool[1]), Wide(tool[2])}.normalized().cross(exact_way);
    const Exact off = Exact{Wide(vector.x), Wide(vector.y), Wide(vector.z)} - across.normalized() * Wide(r);
    note("SideNormal", off.norm() / Wide(r) * (across.norm() / exact_way.norm()));
  }
}

TEST_F(Measured, UnitVectors) {
  for (int i = 0; i < kCases; ++i) {
    const klartext::WholeVector v = normalized();
    const klartext::UnitVector u = klartext::unit_of(v);
    Wide square = 0;
    for (const std::int64_t component : v.small) square += Wide(component) * Wide(component);
    for (std::size_t j = 0; j < 3; ++j) note("unit_by_series", u.unit[j] - Wide(v.small[j]) / std::sqrt(square));
  }
}

// A component of each vector: as FaceMilling and EventWriter write them, which are not public.
TEST_F(Measured, Faces) {
  for (int i = 0; i < kCases; ++i) {
    const klartext::WholeVector n = normalized();
    klartext::WholeVector t = normalized();
    if (i % 2 == 0)
      for (std::size_t j = 0; j < 3; ++j) t.small[j] = n.small[j] + whole(1000);
    const std::array<std::int64_t, 3> exact_c{n.small[1] * t.small[2] - n.small[2] * t.small[1],
                                              n.small[2] * t.small[0] - n.small[0] * t.small[2],
                                              n.small[0] * t.small[1] - n.small[1] * t.small[0]};
    if ((exact_c[0] | exact_c[1] | exact_c[2]) == 0) continue;
    const klartext::UnitVector unit_n = klartext::unit_of(n), unit_t = klartext::unit_of(t);
    if (!unit_n.normalized || !unit_t.normalized) continue;
    const klartext::Vector c{static_cast<double>(exact_c[0]), static_cast<double>(exact_c[1]),
                             static_cast<double>(exact_c[2])};
    const double square = dot(c, c);
    const klartext::Vector u = cross(unit_t.unit, c) * (std::sqrt(square) * (1 / square));

    const auto size = [](const std::array<std::int64_t, 3>& v) {
      return std::sqrt(Wide(v[0]) * Wide(v[0]) + Wide(v[1]) * Wide(v[1]) + Wide(v[2]) * Wide(v[2]));
    };
    const Wide exact_n = Wide(n.small[0]) / size(n.small), exact_t = Wide(t.small[0]) / size(t.small);
    const Wide exact_u =
        (Wide(t.small[1]) * Wide(exact_c[2]) - Wide(t.small[2]) * Wide(exact_c[1])) / size(t.small) / size(exact_c);
    note("face_ring", u.x() - exact_u);

    const auto length = [&](double least, double most) {
      return std::uniform_real_distribution<double>(least, most)(random_);
    };
    const double corner = length(0, 1), ring = length(0, 1 - corner), below = i % 4 < 2 ? 0 : corner;
    const double p = length(-1, 1);
    const double q = unit_t.unit.x() * -below - ((unit_n.unit.x() - unit_t.unit.x()) * corner + u.x() * ring);
    const Wide exact = Wide(p) - exact_t * Wide(below) - ((exact_n - exact_t) * Wide(corner) + exact_u * Wide(ring));
    note("face_points", ((p + q) - exact) / std::max(Wide(1), std::fabs(exact)));
  }
}

struct Exact {
  long double sine, cosine;
};
Exact exact(std::int64_t small) {
  const long double radians = static_cast<long double>(small) * (std::numbers::pi_v<long double> / 180'000'000);
  return {std::sin(radians), std::cos(radians)};
}

TEST_F(Measured, SinesAndWhatIsMadeOfThem) {
  constexpr std::int64_t kEighth = 45'000'000;
  for (int i = 0; i < kCases; ++i) {
    const std::int64_t a = std::uniform_int_distribution<std::int64_t>(-kEighth, kEighth)(random_);
    const std::int64_t b = std::uniform_int_distribution<std::int64_t>(-kEighth, kEighth)(random_);
    const std::int64_t c = std::uniform_int_distribution<std::int64_t>(-kEighth, kEighth)(random_);
    const fast::SineCosine<double> ta = fast::sine_cosine(a), tb = fast::sine_cosine(b);
    const Exact ea = exact(a), eb = exact(b), ec = exact(c);
    if (a != 0) note("sine", (ta.sine - ea.sine) / ea.sine);
    note("cosine", (ta.cosine - ea.cosine) / ea.cosine);
    note("direction_one_term", ta.cosine * tb.cosine - ea.cosine * eb.cosine);
    // As Kinematics adds the terms of such a machine.
    const double inclined = std::numbers::sqrt2 / 2;
    const double nutating = (0.5 * tb.cosine * ta.sine - 0.5 * ta.sine) + inclined * tb.sine * ta.cosine;
    note("direction_nutating", nutating - ((0.5L * eb.cosine * ea.sine - 0.5L * ea.sine) +
                                           std::numbers::sqrt2_v<long double> / 2 * eb.sine * ea.cosine));
    klartext::ToolVector tool;
    const auto degrees = [](std::int64_t small) {
      fast::Count count;
      count.set_small(small);
      return count;
    };
    tool.turn(2, {degrees(a), degrees(b), degrees(c)});
    note("direction_spatial", tool.unit().x() - (ec.cosine * (eb.sine * ea.cosine) + ec.sine * ea.sine));
    note("direction_spatial", tool.unit().y() - (ec.sine * (eb.sine * ea.cosine) - ec.cosine * ea.sine));
  }
}

}  // namespace
