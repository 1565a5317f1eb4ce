// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/diary.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "fuzz/gen/encode.h"
#include "host/file_writer.h"
#include "spec/language/case_format.h"
#include "spec/language/json_text.h"

namespace toolcomp::fuzz {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kInterval = std::chrono::seconds(1);

}  // namespace

std::string seen_text(const spec::Case& input, const judge::Difference& difference, const HowFound& how) {
  std::string out = "{\"finding\": 1";
  const auto name = [&out](std::string_view key) { out += fmt::format(",\n \"{}\": ", key); };
  const auto text = [&](std::string_view key, std::string_view value) {
    name(key);
    spec::append_json_string(out, value);
  };
  text("kind", difference.kind == "law" ? "law " + difference.field : difference.kind);
  if (difference.clause && difference.kind != "law") text("clause", spec::info(*difference.clause).id);
  name("line");
  spec::append_integer(out, difference.line);
  text("field", difference.field);
  text("expected", difference.expected);
  text("actual", difference.actual);
  text("seed", std::to_string(how.seed));
  text("target", how.target);
  name("executions");
  spec::append_integer(out, how.executions);
  name("seconds");
  out += fmt::format("{:.1f}", how.seconds);
  name("case");
  spec::Case named = input;
  named.id = "found." + digest(encode(input));
  return out + spec::write_case_line(named) + "}\n";
}

Diary::Diary(std::filesystem::path folder, std::string target, std::uint64_t seed)
    : folder_(std::move(folder)), target_(std::move(target)), seed_(seed), box_(folder_ / kBlackBox) {}

void Diary::begin(std::string_view input) { box_.begin(input); }

void Diary::hit(const std::string& group, std::uint64_t executions,
                const std::function<std::string(const HowFound&)>& text, std::string_view ending) {
  if (!worth_keeping(++hits_[group])) return;
  const std::string what = text({target_, seed_, executions, seconds()});
  // By name in the order in which they were seen: that is the order in which they are looked at.
  keep(fmt::format("{:010}-{}{}", executions, digest(what), ending), what);
}

void Diary::keep(const std::string& name, const std::string& text) {
  try {
    host::write_file(folder_ / kFindings / name, text);
  } catch (const std::exception&) {
    failed_ = true;
    static_cast<void>(box_.keep(name + '\n' + text));
  }
}

void Diary::tick(const Counters& result) {
  if (Clock::now() - written_ >= kInterval) write(result);
}

void Diary::write(Counters result) {
  written_ = Clock::now();
  result.milliseconds = static_cast<std::uint64_t>(seconds() * 1000);
  result.hits = hits_;
  try {
    host::write_file(folder_ / kStatistics, write_counters(result));
  } catch (const std::exception&) {
    failed_ = true;
  }
}

double Diary::seconds() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

std::string group_of(std::string_view section, const judge::Difference& difference) {
  // No clause enters a law: what it is broken by is known by its name.
  if (difference.kind == "law") return fmt::format("{}|law {}|", section, difference.field);
  return fmt::format("{}|{}|{}", section, difference.kind,
                     difference.clause ? spec::info(*difference.clause).id : std::string_view());
}

judge::Difference not_decided(const std::string& why) {
  judge::Difference open;
  open.kind = kUndecidedKind;
  open.field = "verdict";
  open.expected = "a verdict";
  open.actual = why;
  return open;
}

bool worth_keeping(std::uint64_t hit) {
  constexpr std::uint64_t kAll = 8;
  return hit <= kAll || (hit & (hit - 1)) == 0;
}

std::string digest(std::string_view bytes) {
  // FNV-1a: a name, not a proof.
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  return fmt::format("{:016x}", hash);
}

}  // namespace toolcomp::fuzz
