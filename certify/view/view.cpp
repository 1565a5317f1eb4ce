// SPDX-License-Identifier: Apache-2.0
#include "certify/view/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "certify/convert.h"
#include "certify/markup.h"
#include "certify/view/tool_shapes.h"
#include "fuzz/gen/program_text.h"
#include "judge/oracle/verdict.h"
#include "spec/language/event_names.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

using Json = nlohmann::ordered_json;
using Events = std::span<const spec::Event<double>>;

constexpr std::string_view kFigure = "<figure class=\"view\"";
constexpr std::size_t kMostSteps = 2000;

// Ten decimals: more than the eye and less than a page can bear.
Json json_of(const Point3& p) {
  constexpr double kDecimals = 1e10;
  Json json = Json::array();
  for (const double x : p) json.push_back(std::round(x * kDecimals) / kDecimals);
  return json;
}

Json json_of(const std::vector<Point3>& points) {
  Json json = Json::array();
  for (const Point3& p : points) json.push_back(json_of(p));
  return json;
}

// Moves of two runs belong together by their line, and their place among the moves of that line.
using MoveKey = std::pair<std::uint64_t, std::size_t>;

std::map<MoveKey, std::size_t> moves_of(Events events) {
  std::map<MoveKey, std::size_t> moves;
  std::map<std::uint64_t, std::size_t> count;
  for (std::size_t i = 0; i < events.size(); ++i)
    if (events[i].kind == spec::EventKind::move || events[i].hole) moves[{events[i].line, count[events[i].line]++}] = i;
  return moves;
}

// The courses of a run: lists of points by event.
using Course = std::map<std::size_t, const std::vector<Point3>*>;

Course by_event(const Path& path) {
  Course course;
  for (const PathMove& move : path.moves) course[move.event] = &move.points;
  return course;
}

// What happens in an event, in words.
std::string words(const spec::Event<double>& event) {
  switch (event.kind) {
    case spec::EventKind::move: {
      const std::string type = event.type == spec::MoveType::arc ? "arc" : std::string(name(event.type)) + " move";
      return event.cause == spec::Cause::programmed ? type : type + ", " + std::string(name(event.cause));
    }
    case spec::EventKind::hole:
      return event.hole
                 ? fmt::format("hole to {}, return to {}", plain(event.hole->bottom, 9), plain(event.hole->level, 9))
                 : "hole";
    case spec::EventKind::setting:
      return fmt::format("{} becomes {}", event.setting.view(), plain(event.value, 9));
    default:
      return fmt::format("{} {}: {}", name(event.kind), event.number.view(), event.message);
  }
}

class ViewData {
 public:
  ViewData(const spec::Case& c, const ViewRun& run, const ViewOptions& options)
      : c_(c),
        run_(run),
        options_(options),
        step_of_(run.events.size(), SIZE_MAX),
        text_(fuzz::lines(c.program)),
        shapes_(shapes_of(c)),
        programmed_(follow(c.setup.axes, options.path.start, run.events, PathOf::programmed)),
        point_(follow(c.setup.axes, options.path.start, run.events, PathOf::point)),
        axes_(follow(c.setup.axes, options.path.start, run.events, PathOf::axes)) {
    other_ = follow(c.setup.axes, options.path.start, options.path.other, PathOf::axes);
    of_axes_ = !other_.moves.empty();
    if (!of_axes_) other_ = follow(c.setup.axes, options.path.start, options.path.other, PathOf::point);
  }

  Json json() {
    Json json;
    json["unit"] = options_.path.unit;
    json["start"] = json_of(options_.path.start);
    json["controller"] = options_.path.other_name;
    // Of which exact path the controller's is a copy.
    json["compared"] = of_axes_ ? "axes" : "point";
    json["steps"] = steps();
    json["more"] = more_;
    if (marked_) json["marked"] = *marked_;
    if (options_.program != nullptr)
      json["program"] =
          program_data(c_, *options_.program, step_of_, [this](spec::Clause clause) { return number_of(clause); });
    json["clauses"] = std::move(clauses_);
    json["tools"] = std::move(tools_);
    if (!options_.recorded.empty()) {
      Json recorded = Json::array();
      for (const ViewSample& sample : options_.recorded)
        recorded.push_back({json_of(sample.at), json_of(sample.exact), sample.off ? 1 : 0});
      json["recorded"] = std::move(recorded);
    }
    return json;
  }

 private:
  static std::optional<ToolShapes> shapes_of(const spec::Case& c) {
    try {
      return ToolShapes(c);
    } catch (const spec::InputError&) {
      return std::nullopt;
    }
  }

  Json steps() {
    const Course programmed = by_event(programmed_);
    const Course point = by_event(point_);
    const Course axes = by_event(axes_);
    const Course other = by_event(other_);
    const std::map<MoveKey, std::size_t> others = moves_of(options_.path.other);
    std::map<std::uint64_t, std::size_t> count;  // moves by line
    Json steps = Json::array();
    for (std::size_t i = 0; i < run_.events.size(); ++i) {
      const spec::Event<double>& event = run_.events[i];
      if (event.kind == spec::EventKind::sample) continue;
      if (is_left_out(i, steps.size())) {
        ++more_;
        continue;
      }
      step_of_[i] = steps.size();
      // A sample that differs is marked at the move it leads to.
      if (options_.path.marked && !marked_ && *options_.path.marked <= i) marked_ = steps.size();
      Json step = step_of(event);
      const auto add = [&step](const char* name, const Course& course, std::size_t index) {
        if (const auto found = course.find(index); found != course.end()) step[name] = json_of(*found->second);
      };
      add("programmed", programmed, i);
      add("point", point, i);
      add("axes", axes, i);
      if (event.kind == spec::EventKind::move || event.hole)
        if (const auto found = others.find({event.line, count[event.line]++}); found != others.end())
          add("other", other, found->second);
      if (i < run_.clauses.size())
        for (const spec::Clause clause : run_.clauses[i]) step["clauses"].push_back(number_of(clause));
      steps.push_back(std::move(step));
    }
    return steps;
  }

  // A page has so many blocks, a view without blocks so many steps.
  [[nodiscard]] bool is_left_out(std::size_t event, std::size_t steps) const {
    return options_.program != nullptr ? options_.program->run->block_of[event] >= kMostBlocks : steps >= kMostSteps;
  }

  Json step_of(const spec::Event<double>& event) {
    Json step;
    step["line"] = event.line;
    if (event.n) step["n"] = *event.n;
    if (options_.program == nullptr && event.line > 0 && event.line <= text_.size()) {
      std::string_view text = text_[event.line - 1];
      while (text.ends_with('\r')) text.remove_suffix(1);
      step["text"] = text;
    }
    step["what"] = words(event);
    if (event.kind == spec::EventKind::move && event.type == spec::MoveType::rapid) step["rapid"] = true;
    if (spec::ends_run(event.kind)) step["alarm"] = event.number.view();
    if (event.kind == spec::EventKind::warning || event.kind == spec::EventKind::undecided) step["warning"] = true;
    if (event.tool_axis && std::ranges::all_of(*event.tool_axis, [](double x) { return std::isfinite(x); }))
      step["tool_axis"] = json_of(*event.tool_axis);
    if (const auto shape = shapes_ ? shapes_->at(event.line) : std::nullopt) step["tool"] = number_of(*shape);
    return step;
  }

  // The index in the list of clauses, in which each stands once.
  std::size_t number_of(spec::Clause clause) {
    const auto [entry, is_new] = clause_numbers_.emplace(clause, clauses_.size());
    if (is_new) {
      clauses_.push_back({spec::info(clause).id, spec::info(clause).text});
      if (options_.program != nullptr) clauses_.back().push_back(clause_data(clause));
    }
    return entry->second;
  }

  std::size_t number_of(const ToolShape& shape) {
    const auto found = std::ranges::find(known_tools_, shape);
    if (found == known_tools_.end()) {
      known_tools_.push_back(shape);
      tools_.push_back(
          {{"radius", shape.radius}, {"corner", shape.corner}, {"length", shape.length}, {"name", shape.name}});
      return known_tools_.size() - 1;
    }
    return static_cast<std::size_t>(found - known_tools_.begin());
  }

  const spec::Case& c_;
  const ViewRun& run_;
  const ViewOptions& options_;
  std::vector<std::size_t> step_of_;  // by event
  std::vector<std::string> text_;
  std::optional<ToolShapes> shapes_;
  Path programmed_;
  Path point_;
  Path axes_;
  Path other_;
  bool of_axes_ = false;
  std::size_t more_ = 0;  // steps left out
  std::optional<std::size_t> marked_;
  Json clauses_ = Json::array();
  std::map<spec::Clause, std::size_t> clause_numbers_;
  Json tools_ = Json::array();
  std::vector<ToolShape> known_tools_;
};

// As the text of a <script> element: nothing in it ends the element, or is markup to any reader.
std::string in_script(const Json& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
    if (c == '<' || c == '>' || c == '&')
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  return out;
}

}  // namespace

ViewRun view_run(const std::vector<model::Event>& events) {
  ViewRun run;
  run.events = in_doubles(events);
  for (const model::Event& event : events) run.clauses.push_back(event.clauses);
  return run;
}

ViewRun view_run(const spec::Case& c, std::vector<spec::Event<double>> events) {
  // As far as steps are shown: the model would run through all of a long program.
  spec::Case first = c;
  std::size_t end = 0;
  for (std::size_t line = 0; line < kMostSteps && end != std::string::npos; ++line) end = c.program.find('\n', end + 1);
  if (end != std::string::npos) first.program.resize(end + 1);
  const std::vector<model::Event> exact = judge::run_model(first).events;
  ViewRun run;
  run.clauses.resize(events.size());
  auto same = exact.begin();
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].kind == spec::EventKind::sample) continue;
    while (same != exact.end() && same->kind == spec::EventKind::sample) ++same;
    if (same == exact.end() || events[i].line != same->line || events[i].kind != same->kind) break;
    run.clauses[i] = same->clauses;
    ++same;
  }
  run.events = std::move(events);
  return run;
}

std::string view(std::string_view title, const spec::Case& c, const ViewRun& run, const ViewOptions& options,
                 std::string_view picture) {
  std::string drawn = "<div class=\"picture\">" + std::string(picture) + "</div>\n";
  const Json data = ViewData(c, run, options).json();
  if (data["steps"].empty() && options.recorded.empty() && options.program == nullptr) return drawn;
  return std::string(kFigure) + (options.program != nullptr ? " data-program" : "") + " aria-label=\"" + escape(title) +
         "\">\n" + drawn + "<script type=\"application/json\">" + in_script(data) + "</script>\n</figure>\n";
}

bool has_view(std::string_view body) { return body.find(kFigure) != std::string_view::npos; }

}  // namespace toolcomp::certify
