// SPDX-License-Identifier: Apache-2.0
#include "certify/view/program_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "certify/block_words.h"
#include "certify/event_numbers.h"
#include "certify/view/number_words.h"
#include "fast/basis/print.h"
#include "spec/coverage/report.h"

namespace toolcomp::certify {
namespace {

using Json = nlohmann::ordered_json;
using exact::Real;

constexpr std::size_t kNothing = SIZE_MAX;
// Of one block: more decisions than anybody reads. `toolcomp explain` prints all.
constexpr std::size_t kMostDecisions = 60;

// Numbers of one field: name, letters, exact texts; doubles where they have another text, and how far off they are.
class Field {
 public:
  Field(std::string_view name, int digits) : name_(name), digits_(digits) {}
  [[nodiscard]] std::string_view name() const { return name_; }

  void add(char letter, const Real& exact, std::optional<double> fast) {
    if (letter != 0) letters_ += letter;
    std::string text = number_words(exact, digits_);
    Json shown = nullptr;
    Json off = nullptr;
    if (fast) {
      std::string number;
      if (std::isfinite(*fast)) fast::append_number(number, *fast);
      shown = number == text ? Json(0) : Json(number);
      if (const std::optional<std::int64_t> ulps = ulps_off(*fast, exact)) off = *ulps;
    }
    is_off_ = is_off_ || (fast && off != 0);
    exact_.push_back(std::move(text));
    doubles_.push_back(std::move(shown));
    off_.push_back(std::move(off));
  }

  Json json() {
    Json json = {name_, letters_, std::move(exact_)};
    const bool same = std::ranges::all_of(doubles_, [](const Json& number) { return number == 0; });
    if (!same || is_off_) json.push_back(std::move(doubles_));
    if (is_off_) json.push_back(std::move(off_));
    return json;
  }
  // The same numbers under another name: those of `other`.
  Json json_as(const Field& other) { return {name_, letters_, other.name_}; }
  [[nodiscard]] bool is_as(const Field& other) const {
    return letters_ == other.letters_ && exact_ == other.exact_ && doubles_ == other.doubles_ && off_ == other.off_;
  }

 private:
  std::string_view name_;
  int digits_;
  std::string letters_;
  Json exact_ = Json::array();
  Json doubles_ = Json::array();
  Json off_ = Json::array();
  bool is_off_ = false;
};

class Numbers {
 public:
  Numbers(const spec::Axes& axes, int digits) : axes_(axes), digits_(digits) {}

  // `fast`: the same event of the fast engine, where it has one.
  Json of(const model::Event& event, const fast::Event* fast) const {
    std::map<std::pair<std::string_view, char>, double> doubles;
    if (fast != nullptr)
      for_each_number(*fast, axes_, [&](std::string_view field, char letter, double number) {
        doubles.emplace(std::pair(field, letter), number);
      });
    std::vector<Field> fields;
    const auto add = [&](std::string_view name, char letter, const Real& number) {
      const auto found = doubles.find({name, letter});
      if (fields.empty() || fields.back().name() != name) {
        if (name == "axes") add_vector(fields, event);
        fields.emplace_back(name, digits_);
      }
      fields.back().add(letter, number, found == doubles.end() ? std::nullopt : std::optional(found->second));
    };
    for_each_number(event, axes_, add);
    if (event.arc && event.arc->radius) {
      add("radius", 0, event.arc->radius->first);
      fields.emplace_back("end_radius", digits_);
      fields.back().add(0, event.arc->radius->second, std::nullopt);
    }
    Json json = Json::array();
    const auto point = std::ranges::find(fields, "point", &Field::name);
    for (Field& field : fields)
      json.push_back(field.name() == "axes" && point != fields.end() && field.is_as(*point) ? field.json_as(*point)
                                                                                            : Json());
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (json[i].is_null()) json[i] = fields[i].json();
    return json;
  }

 private:
  // From the programmed end to the compensated one, where they differ. No engine gives it, so there is no double.
  void add_vector(std::vector<Field>& fields, const model::Event& event) const {
    Field vector("vector", digits_);
    bool there = false;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (!event.point.has(i) || !event.programmed.has(i)) continue;
      const Real difference = event.point[i] - event.programmed[i];
      vector.add(axes_.letter(i), difference, std::nullopt);
      there = there || !(difference.is_rational() && difference.rational() == 0);
    }
    if (there) fields.push_back(std::move(vector));
  }

  const spec::Axes& axes_;
  int digits_;
};

// Events of the fast engine by those of the model: of the same block the same in number and kind.
class Pairs {
 public:
  explicit Pairs(const ProgramRun& run) : run_(run) {
    for (std::size_t i = 0; i < run.fast.size(); ++i) fast_[run.block_of_fast[i]].push_back(i);
    for (std::size_t i = 0; i < run.events.size(); ++i) exact_[run.block_of[i]].push_back(i);
  }
  // For the events of a block, in order; null where the fast engine has another one.
  [[nodiscard]] std::map<std::size_t, const fast::Event*> of(std::size_t block) const {
    std::map<std::size_t, const fast::Event*> pairs;
    const auto exact = exact_.find(block);
    const auto fast = fast_.find(block);
    if (exact == exact_.end() || fast == fast_.end() || exact->second.size() != fast->second.size()) return pairs;
    for (std::size_t i = 0; i < exact->second.size(); ++i) {
      const fast::Event& other = run_.fast[fast->second[i]];
      if (other.kind == run_.events[exact->second[i]].kind) pairs[exact->second[i]] = &other;
    }
    return pairs;
  }
  [[nodiscard]] const std::vector<std::size_t>& exact(std::size_t block) const {
    static const std::vector<std::size_t> kNone;
    const auto found = exact_.find(block);
    return found == exact_.end() ? kNone : found->second;
  }

 private:
  const ProgramRun& run_;
  std::map<std::size_t, std::vector<std::size_t>> exact_;
  std::map<std::size_t, std::vector<std::size_t>> fast_;
};

class ProgramData {
 public:
  ProgramData(const spec::Case& c, const ProgramView& view, const std::vector<std::size_t>& step_of,
              const std::function<std::size_t(spec::Clause)>& number_of)
      : c_(c),
        view_(view),
        run_(*view.run),
        step_of_(step_of),
        number_of_(number_of),
        pairs_(run_),
        numbers_(c.setup.axes, view.digits) {
    for (std::size_t i = 0; i < run_.decisions.size(); ++i) decisions_[run_.block_of_decision[i]].push_back(i);
  }

  Json json() {
    Json json;
    json["text"] = c_.program;
    json["digits"] = view_.digits;
    json["klartext"] = c_.setup.control == spec::Control::heidenhain;
    if (!view_.files.empty()) json["files"] = view_.files;
    Json blocks = Json::array();
    const std::size_t shown = std::min(run_.blocks.size(), kMostBlocks);
    for (std::size_t i = 0; i < shown; ++i) blocks.push_back(block(i));
    json["blocks"] = std::move(blocks);
    json["more"] = run_.blocks.size() - shown;
    return json;
  }

 private:
  Json block(std::size_t index) {
    const ProgramRun::Block& block = run_.blocks[index];
    Json json;
    json["line"] = block.line;
    if (block.n) json["n"] = *block.n;
    Json events = Json::array();
    std::size_t samples = 0;
    const auto pairs = pairs_.of(index);
    for (const std::size_t i : pairs_.exact(index)) {
      if (run_.events[i].kind == spec::EventKind::sample) ++samples;
      if (step_of_[i] == kNothing) continue;
      const auto pair = pairs.find(i);
      events.push_back(event(i, pair == pairs.end() ? nullptr : pair->second));
    }
    if (!events.empty()) json["events"] = std::move(events);
    if (samples > 0) json["samples"] = samples;
    if (const auto found = decisions_.find(index); found != decisions_.end()) {
      const std::vector<std::size_t>& list = found->second;
      Json decisions = Json::array();
      for (std::size_t i = 0; i < std::min(list.size(), kMostDecisions); ++i)
        decisions.push_back(decision(run_.decisions[list[i]]));
      json["decisions"] = std::move(decisions);
      if (list.size() > kMostDecisions) json["more_decisions"] = list.size() - kMostDecisions;
    }
    return json;
  }

  Json event(std::size_t index, const fast::Event* fast) const {
    const model::Event& event = run_.events[index];
    Json json = {{"step", step_of_[index]}, {"numbers", numbers_.of(event, fast)}};
    if (event.kind == spec::EventKind::undecided) {
      Json permitted = Json::array();
      if (event.permitted.positive) permitted.push_back("positive");
      if (event.permitted.negative) permitted.push_back("negative");
      if (event.permitted.tie) permitted.push_back("zero");
      json["permitted"] = std::move(permitted);
    }
    if (event.kind != spec::EventKind::move) return json;
    if (event.cause == spec::Cause::measure)
      if (std::string words = measuring_words(c_.setup, view_.digits); !words.empty()) json["measured"] = words;
    if (event.space || (event.cause == spec::Cause::corner && !event.arc)) return json;
    try {
      if (std::string words = corner_words(run_.events, index, c_.setup.axes, view_.digits); !words.empty())
        json["corner"] = words;
    } catch (const exact::Undecided&) {
      json["corner"] = "its digits could not be certified";
    }
    return json;
  }

  // Clause, exact value, sign, double nearest to it, and where there is a scale: margin and scale.
  Json decision(const model::Decision& decision) const {
    Json json = {number_of_(decision.clause), number_words(decision.quantity, view_.digits),
                 static_cast<int>(decision.outcome)};
    try {
      const exact::DoubleEnclosure enclosure = decision.quantity.double_enclosure();
      json.push_back(fmt::format("{:.17g}", enclosure.lower / 2 + enclosure.upper / 2));
      if (decision.scale.sign() == exact::Sign::positive) {
        json.push_back(number_words(decision.quantity / decision.scale, view_.digits));
        json.push_back(number_words(decision.scale, view_.digits));
      }
    } catch (const exact::Undecided&) {
      json.push_back("?");
    }
    return json;
  }

  const spec::Case& c_;
  const ProgramView& view_;
  const ProgramRun& run_;
  const std::vector<std::size_t>& step_of_;
  const std::function<std::size_t(spec::Clause)>& number_of_;
  Pairs pairs_;
  Numbers numbers_;
  std::map<std::size_t, std::vector<std::size_t>> decisions_;  // by block
};

}  // namespace

Json program_data(const spec::Case& c, const ProgramView& view, const std::vector<std::size_t>& step_of,
                  const std::function<std::size_t(spec::Clause)>& number_of) {
  return ProgramData(c, view, step_of, number_of).json();
}

Json clause_data(spec::Clause clause) {
  return Json::parse(spec::show_clause(spec::info(clause).id, spec::ReportFormat::json));
}

}  // namespace toolcomp::certify
