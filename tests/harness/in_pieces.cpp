// SPDX-License-Identifier: Apache-2.0
// program: pieces
// Work in pieces gives what one thread gives: any size of the pieces, any number of threads, right and wrong guesses.
#include "fuzz/parallel/in_pieces.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "certify/event_fields.h"
#include "corpus/contour.h"
#include "corpus/flank.h"
#include "corpus/freeform.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "fuzz/parallel/judge_in_pieces.h"
#include "spec/language/event_map.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

// A sum of numbers, modulo a small one: its state. A piece gives its number and the sum behind it.
struct Number final : Piece {
  std::uint64_t index = 0;
  std::uint64_t guess = 0;
};
struct Sum final : PieceResult {
  std::uint64_t index = 0;
  std::uint64_t sum = 0;
};
constexpr std::uint64_t kModulus = 7;

class Adding final : public PieceWork {
 public:
  explicit Adding(std::uint64_t sum) : sum_(sum) {}
  [[nodiscard]] std::string state() const override { return std::to_string(sum_); }
  std::unique_ptr<PieceResult> run(const Piece& piece, const std::atomic<bool>& /*stop*/) override {
    const auto index = static_cast<const Number&>(piece).index;
    std::this_thread::sleep_for(std::chrono::microseconds((index * 37) % 300));
    if (index == throws_at) throw std::runtime_error("thrown");
    sum_ = (sum_ + index * index) % kModulus;
    auto result = std::make_unique<Sum>();
    result->index = index;
    result->sum = sum_;
    return result;
  }
  static inline std::uint64_t throws_at = ~std::uint64_t{0};

 private:
  std::uint64_t sum_;
};

struct Course {
  std::vector<std::uint64_t> indices;
  std::vector<std::uint64_t> sums;
  std::size_t wrong = 0;
  std::string thrown;
  friend bool operator==(const Course& a, const Course& b) {
    return a.indices == b.indices && a.sums == b.sums && a.thrown == b.thrown;
  }
};

// Of `right_of` guesses one is right for sure, and some cannot be made.
Course add_up(unsigned jobs, std::uint64_t pieces, std::uint64_t right_of, std::uint64_t last, InPieces work = {}) {
  std::uint64_t next = 0;
  std::uint64_t sum = 0;
  SeededSource source(pieces + jobs);
  work.jobs = jobs;
  work.next = [&]() -> std::unique_ptr<Piece> {
    if (next == pieces) return nullptr;
    auto piece = std::make_unique<Number>();
    piece->index = next;
    piece->guess = source.below(right_of) == 0 ? sum : source.below(kModulus);
    sum = (sum + next * next) % kModulus;
    ++next;
    return piece;
  };
  work.begin = [](const Piece& piece, bool first) -> std::unique_ptr<PieceWork> {
    const auto& number = static_cast<const Number&>(piece);
    if (!first && number.index % 11 == 5) return nullptr;
    return std::make_unique<Adding>(first ? 0 : number.guess);
  };
  Course course;
  work.take = [&](PieceResult& result) {
    const auto& piece = static_cast<const Sum&>(result);
    course.indices.push_back(piece.index);
    course.sums.push_back(piece.sum);
    return piece.index != last;
  };
  try {
    course.wrong = in_pieces(work);
  } catch (const std::exception& error) {
    course.thrown = error.what();
  }
  return course;
}

TEST(InPieces, GiveTheResultsInOrderWhateverIsGuessed) {
  for (const std::uint64_t pieces : {1U, 2U, 3U, 40U}) {
    Course expected;
    std::uint64_t sum = 0;
    for (std::uint64_t i = 0; i < pieces; ++i) {
      sum = (sum + i * i) % kModulus;
      expected.indices.push_back(i);
      expected.sums.push_back(sum);
    }
    for (const unsigned jobs : {1U, 2U, 3U, 4U})
      for (const std::uint64_t right_of : {1U, 2U, 1000U})
        EXPECT_EQ(add_up(jobs, pieces, right_of, pieces), expected) << pieces << ' ' << jobs << ' ' << right_of;
  }
}

TEST(InPieces, EndWhereNothingMoreCounts) {
  for (const unsigned jobs : {1U, 2U, 4U}) {
    const Course course = add_up(jobs, 1000, 2, 12);
    EXPECT_EQ(course.indices.size(), 13U);
  }
}

// What is thrown behind the pieces that count is not seen; what is thrown in one that counts, behind those before it.
TEST(InPieces, ThrowInOrder) {
  Adding::throws_at = 20;
  for (const unsigned jobs : {1U, 2U, 4U}) {
    const Course course = add_up(jobs, 40, 2, 40);
    EXPECT_EQ(course.thrown, "thrown");
    EXPECT_EQ(course.indices.size(), 20U);
    EXPECT_EQ(add_up(jobs, 40, 2, 10).thrown, "");
  }
  Adding::throws_at = ~std::uint64_t{0};
}

// A mistake in the parallel path: a wrong guess is taken for right.
TEST(InPieces, TheTestsFindAStateThatIsNotCompared) {
  InPieces mistaken;
  mistaken.same = [](const std::string&, const std::string&) { return true; };
  EXPECT_FALSE(add_up(2, 40, 1000, 40, mistaken) == add_up(2, 40, 1000, 40));
}

std::string differences(const Verdict& a, const Verdict& b) {
  std::string text;
  const auto compare = [&text](const char* name, const auto& x, const auto& y) {
    if (x != y) text += std::string(" ") + name;
  };
  compare("outcome", a.outcome, b.outcome);
  compare("values", a.values, b.values);
  compare("numbers", a.numbers, b.numbers);
  compare("wide", a.wide, b.wide);
  compare("events", a.events, b.events);
  compare("out of scope", a.out_of_scope, b.out_of_scope);
  compare("decisions", a.decisions, b.decisions);
  compare("near ties", a.near_ties, b.near_ties);
  compare("ties", a.ties, b.ties);
  compare("worst ulp", a.worst_ulp, b.worst_ulp);
  compare("worst µm", a.worst_um, b.worst_um);
  compare("widths", a.widths.count(), b.widths.count());
  compare("largest width", a.widths.largest(), b.widths.largest());
  compare("undecided", a.undecided, b.undecided);
  compare("difference", a.difference ? explain(*a.difference) : "", b.difference ? explain(*b.difference) : "");
  if (a.difference && b.difference) compare("event", a.difference->event, b.difference->event);
  return text;
}

// What one way of judging says, an exception included.
struct Said {
  Verdict verdict;
  std::string thrown;
};
template <class Judge>
Said said(const Judge& judge) {
  Said result;
  try {
    result.verdict = judge();
  } catch (const std::exception& error) {
    result.thrown = error.what();
  }
  return result;
}

StreamedProgram streamed(const spec::Case& c) {
  return {[&c] { return spec::text_source(c.program); }};
}

// Pieces of some blocks, so that many guesses are wrong.
TEST(InPieces, GiveTheVerdictOfOneThread) {
  const std::uint64_t seeds = test::random_cases(60);
  for (std::uint64_t seed = 0; seed < seeds; ++seed)
    for (const std::string_view section : sections()) {
      SeededSource source(seed);
      const Mode mode = seed % 4 == 0 ? Mode::unrestricted : Mode::directed;
      const spec::Case c = generate(section, mode, source, 60);
      const Said one = said([&] { return judge_stream(streamed(c), c.setup, c.samples); });
      JudgeInPieces options;
      options.jobs = 2 + static_cast<unsigned>(seed % 3);
      options.epoch = 1 + source.below(8);
      options.epochs_in_piece = 1 + source.below(3);
      options.lead = source.below(8);
      const Said pieces = said([&] { return judge_in_pieces(streamed(c), c.setup, c.samples, options); });
      EXPECT_EQ(pieces.thrown, one.thrown) << encode(c);
      EXPECT_EQ(differences(pieces.verdict, one.verdict), "") << section << " seed " << seed << '\n' << encode(c);
    }
}

// An offset to which forty blocks add, of which a guess knows a few, and which a block far behind uses.
spec::Case added_offset() {
  spec::Case c;
  c.setup.axes = spec::Axes("XYZ");
  c.setup.h[1].geometry = spec::decimal(1);
  c.program = "G91 G01 F100\n";
  for (int i = 0; i < 40; ++i) c.program += "G10 L11 P1 R1.\n";
  for (int i = 0; i < 600; ++i) c.program += i % 2 == 0 ? "G90 X10. Y3. Z0\n" : "G90 X10. Y-2. Z1.\n";
  c.program += "G43 Z5. H1\n";
  return c;
}

TEST(InPieces, TheTestsFindAPartOfTheStateThatIsNotCompared) {
  const spec::Case c = added_offset();
  JudgeInPieces options;
  options.jobs = 2;
  options.epoch = 32;
  options.epochs_in_piece = 2;
  const Verdict one = judge_stream(streamed(c), c.setup);
  ASSERT_EQ(one.outcome, Outcome::agrees);
  EXPECT_EQ(differences(judge_in_pieces(streamed(c), c.setup, 0, options), one), "");
  options.same = [](const std::string& a, const std::string& b) { return a.size() == b.size() || !a.empty(); };
  EXPECT_NE(differences(judge_in_pieces(streamed(c), c.setup, 0, options), one), "");
}

// The fast engine's events as a controller sends them.
std::vector<spec::TextEvent> as_texts(const spec::Case& c) {
  std::vector<spec::TextEvent> texts;
  for (const fast::Event& event : run_fast(c))
    texts.push_back(spec::map_numbers<spec::NumberText>(
        event, [](double number) { return spec::NumberText{fmt::format("{}", number), {}, {}}; }));
  return texts;
}

void fields_of(spec::FieldSet& fields, const model::Event& event) { fields.add(certify::fields_of(event)); }

// Of the whole case, with all events at hand; nothing where agreement_in_pieces() gives nothing.
std::optional<Agreed> agreement_at_once(const spec::Case& c, const std::vector<spec::TextEvent>* texts) {
  const ModelRun run = run_model(c);
  Agreed whole{texts != nullptr ? judge(c, run, *texts) : judge(c, run, run_fast(c)), {run.recorder.counts(), {}}};
  for (const model::Event& event : run.events)
    if (texts != nullptr) fields_of(whole.counted.fields, event);
  const bool plain = (whole.verdict.outcome == Outcome::agrees || whole.verdict.outcome == Outcome::nothing_judged) &&
                     whole.verdict.ties == 0;
  const auto undecided = [](const model::Event& event) { return event.kind == spec::EventKind::undecided; };
  if (!plain || (texts != nullptr && (run.beyond || std::ranges::any_of(run.events, undecided)))) return std::nullopt;
  return whole;
}

std::string counts(const std::vector<model::ClauseCount>& clauses) {
  std::string text;
  for (const model::ClauseCount& c : clauses)
    text += fmt::format("{},{},{},{} ", c.reached, c.positive, c.negative, c.tie);
  return text;
}

// What certify says of a long program is what is said of it as a whole, of the engine and of a controller.
TEST(InPieces, AgreeAsWithAllEventsAtHand) {
  const std::uint64_t seeds = test::random_cases(40);
  std::size_t agreed = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const std::string_view section : sections()) {
      SeededSource source(seed);
      const spec::Case c = generate(section, Mode::directed, source, 60);
      JudgeInPieces options;
      options.jobs = 1 + static_cast<unsigned>(seed % 3);
      options.epoch = 1 + source.below(8);
      options.epochs_in_piece = 1 + source.below(3);
      options.lead = source.below(8);
      std::vector<spec::TextEvent> texts;
      try {
        texts = as_texts(c);
      } catch (const spec::InputError&) {
        continue;
      }
      for (const bool controller : {false, true}) {
        const auto whole = agreement_at_once(c, controller ? &texts : nullptr);
        const auto pieces =
            controller ? agreement_in_pieces(c, texts, {}, fields_of, options) : agreement_in_pieces(c, options);
        EXPECT_TRUE(whole || !pieces) << encode(c);
        if (!pieces || !whole) continue;
        ++agreed;
        EXPECT_EQ(differences(pieces->verdict, whole->verdict), "") << section << " seed " << seed << '\n' << encode(c);
        EXPECT_EQ(counts(pieces->counted.clauses), counts(whole->counted.clauses)) << encode(c);
        EXPECT_EQ(pieces->counted.fields, whole->counted.fields) << encode(c);
      }
    }
  EXPECT_GT(agreed, seeds * sections().size());
}

// An event moved, left out or doubled is no agreement.
TEST(InPieces, DoNotAgreeWithAnotherList) {
  const corpus::Contour contour = corpus::make_contour({.blocks = 400});
  spec::Case c;
  c.setup = spec::read_setup_toml(contour.setup, "setup");
  c.program = contour.program;
  JudgeInPieces options;
  options.jobs = 2;
  options.epoch = 32;
  options.epochs_in_piece = 2;
  const std::vector<spec::TextEvent> texts = as_texts(c);
  const auto agrees = [&](const std::vector<spec::TextEvent>& events) {
    return agreement_in_pieces(c, events, {}, fields_of, options).has_value();
  };
  EXPECT_TRUE(agrees(texts));
  for (const std::size_t at : {std::size_t{0}, std::size_t{3}, texts.size() / 2, texts.size() - 1}) {
    std::vector<spec::TextEvent> fewer = texts;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(at));
    EXPECT_FALSE(agrees(fewer)) << at;
    std::vector<spec::TextEvent> more = texts;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(at), texts[at]);
    EXPECT_FALSE(agrees(more)) << at;
    std::vector<spec::TextEvent> bad = texts;
    bad[at].axes.set(0, {"1.2.3", {}, {}});
    EXPECT_FALSE(agrees(bad)) << at;
    std::vector<spec::TextEvent> off = texts;
    if (!off[at].axes.has(0)) continue;
    off[at].axes.set(0, {fmt::format("{}", std::stod(off[at].axes[0].v) + 0.001), {}, {}});
    EXPECT_FALSE(agrees(off)) << at;
  }
}

// Programs of real length are divided: no guess about them is wrong, with compensation on from their beginning to their
// end, in passes with start-up and cancel, and in space.
TEST(InPieces, GuessRightInUsualPrograms) {
  const std::size_t blocks = test::effort(500, 3000);
  const corpus::Contour contour = corpus::make_contour({.blocks = blocks});
  const corpus::Flank flank = corpus::make_flank({.blocks = blocks});
  const corpus::Freeform freeform = corpus::make_freeform({.blocks = blocks});
  for (const auto& [program, toml] : {std::pair{contour.program, contour.setup}, std::pair{flank.program, flank.setup},
                                      std::pair{freeform.program, freeform.setup}}) {
    spec::Case c;
    c.setup = spec::read_setup_toml(toml, "setup");
    c.program = program;
    std::size_t wrong = 1;
    JudgeInPieces options;
    options.jobs = 2;
    options.epoch = 64;
    options.epochs_in_piece = 2;
    options.wrong = &wrong;
    const Verdict one = judge_stream(streamed(c), c.setup);
    EXPECT_EQ(one.outcome, Outcome::agrees);
    EXPECT_EQ(differences(judge_in_pieces(streamed(c), c.setup, 0, options), one), "");
    EXPECT_EQ(wrong, 0U) << c.program.substr(0, 200);
    const auto agreed = [&] { return agreement_in_pieces(c, as_texts(c), {}, fields_of, options); };
    ASSERT_TRUE(agreed());
    EXPECT_EQ(wrong, 0U) << c.program.substr(0, 200);
  }
}

}  // namespace
}  // namespace toolcomp::fuzz
