// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/verify.h"
#include "model/basis/clause_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include "certify/bundle/bundle_reader.h"
#include "certify/bundle/planned_cases.h"
#include "certify/bundle/record.h"
#include "certify/bundle/refused.h"
#include "certify/bundle/signature.h"
#include "certify/controller.h"
#include "certify/event_fields.h"
#include "certify/report.h"
#include "corpus/manifest.h"
#include "host/sha256.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/known.h"
#include "spec/language/outside_json.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify::bundle {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostRefusals = 20;
// A section is given up behind so many faults at least.
constexpr std::uint64_t kFewestFaults = 2;

// A line of each of the three files.
struct Lines {
  std::uint64_t number = 0;
  std::string request;
  std::string answer;
  std::string record;
};

// What is read inside a bundle; what cannot be read there speaks against it.
template <class Read>
auto or_refused(Read read) {
  try {
    return read();
  } catch (const spec::InputError& error) {
    throw Refused(error.what());
  }
}

class Verifying {
 public:
  explicit Verifying(const VerifyOptions& options) : options_(options) {}

  Verification run() {
    try {
      bundle_.emplace(read_bundle(options_.file));
    } catch (const Refused& why) {
      refuse(why.what());
      return std::move(result_);
    }
    result_.manifest = bundle_->manifest;
    check_signature_beside();
    const auto checks = {&Verifying::read_certificate, &Verifying::check_identity, &Verifying::check_cases,
                         &Verifying::judge_again,      &Verifying::check_findings, &Verifying::check_sums};
    for (const auto check : checks) {
      attempt([&] { (this->*check)(); });
      // What comes next rests on it.
      if (!result_.refused.empty()) break;
    }
    return std::move(result_);
  }

 private:
  template <class Check>
  void attempt(Check check) {
    try {
      check();
    } catch (const Refused& why) {
      refuse(why.what());
    } catch (const Json::exception& error) {
      refuse(std::string(kCertificate) + ": " + error.what());
    }
  }

  void refuse(std::string why) {
    if (result_.refused.size() < kMostRefusals) result_.refused.push_back(std::move(why));
  }

  static void expect_same(const std::string& what, const Json& here, const Json& there) {
    if (here == there) return;
    const auto dump = [](const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); };
    throw Refused(fmt::format("{}: is {} and should be {}", what, dump(here), dump(there)));
  }

  void check_signature_beside() {
    const Signature signature = check_signature(options_.file);
    result_.signature = signature.words;
    if (signature.there && !signature.good) refuse(signature_file(options_.file).string() + ": " + signature.words);
  }

  void read_certificate() {
    const std::string name(kCertificate);
    certificate_ = or_refused([&] { return spec::read_outside_json(bundle_->files.at(name), name); });
    result_.verdict = certificate_.at("verdict").get<std::string>();
    const auto hello = bundle_->files.find(std::string(kHello));
    if (hello == bundle_->files.end()) return;
    capabilities_ =
        or_refused([&] { return capabilities_from(spec::read_outside_json(hello->second, std::string(kHello))); });
    result_.controller = capabilities_->name + " " + capabilities_->version;
    try {
      capabilities_->known =
          spec::KnownSet::of(certificate_.at("left_out").at("judged").get<std::vector<std::string>>());
    } catch (const std::invalid_argument& error) {
      throw Refused(name + ": left_out: judged: " + error.what());
    }
  }

  void check_identity() {
    const Json& identity = certificate_.at("identity");
    expect_same("certificate.json: tool", identity.at("tool"), bundle_->manifest.tool);
    if (identity.at("clauses_sha256") != clause_set_hash())
      throw Refused("certificate.json: was made by " + bundle_->manifest.tool +
                    " with clauses other than those of this toolcomp " TOOLCOMP_VERSION);
    result_.corpus = identity.at("corpus").get<std::string>();
    const auto manifest = bundle_->files.find(std::string(kCorpus));
    if (result_.corpus == "none") {
      if (manifest != bundle_->files.end()) throw Refused(std::string(kCorpus) + ": the certificate has no corpus");
      return;
    }
    if (manifest == bundle_->files.end()) throw Refused(std::string(kCorpus) + ": is missing");
    expect_same(std::string(kCorpus) + ": its SHA-256", host::sha256(manifest->second), identity.at("corpus_sha256"));
    const corpus::Manifest here = corpus::read_manifest(options_.corpus);
    if (identity.at("corpus_sha256") != here.hash || result_.corpus != here.version)
      throw Refused(fmt::format("corpus: the certificate used {} ({}), and this corpus is {} ({})", result_.corpus,
                                identity.at("corpus_sha256").get<std::string>(), here.version, here.hash));
  }

  // Calls with each line of the three files, which have to have as many as the manifest says.
  template <class Take>
  void for_each_line(Take take) {
    bundle_->cases.rewind();
    bundle_->answers.rewind();
    bundle_->results.rewind();
    Lines lines;
    for (; bundle_->cases.next_line(lines.request); ++lines.number) {
      if (!bundle_->answers.next_line(lines.answer))
        throw Refused(std::string(kAnswers) + ": has fewer lines than cases.jsonl");
      if (!bundle_->results.next_line(lines.record))
        throw Refused(std::string(kResults) + ": has fewer lines than cases.jsonl");
      take(lines);
    }
    if (bundle_->answers.next_line(lines.answer))
      throw Refused(std::string(kAnswers) + ": has more lines than cases.jsonl");
    if (bundle_->results.next_line(lines.record))
      throw Refused(std::string(kResults) + ": has more lines than cases.jsonl");
    if (lines.number != bundle_->manifest.cases)
      throw Refused(
          fmt::format("cases.jsonl: has {} cases, and the manifest says {}", lines.number, bundle_->manifest.cases));
  }

  static Record record_of(const Lines& lines) {
    return or_refused([&] { return read_record(lines.number, lines.record); });
  }

  static spec::Case read_request(const Lines& lines) {
    return or_refused(
        [&] { return spec::read_case(lines.request, fmt::format("cases.jsonl: line {}", lines.number + 1)); });
  }

  [[nodiscard]] Plan plan() const {
    const Json& identity = certificate_.at("identity");
    Plan plan;
    plan.sections = bundle_->manifest.sections;
    plan.known = capabilities_->sections;
    if (result_.corpus != "none") plan.corpus = options_.corpus;
    plan.seed = identity.at("seed").get<std::uint64_t>();
    plan.generated = identity.at("generated").get<std::uint32_t>();
    plan.of_adapter = !bundle_->manifest.adapter.empty();
    plan.interrupted = !bundle_->manifest.interrupted.empty();
    plan.regenerate = options_.all;
    return plan;
  }

  // Each is planned, and has an answer or a reason to have none.
  void check_cases() {
    std::optional<PlannedCases> planned;
    if (capabilities_) planned.emplace(plan());
    for_each_line([&](const Lines& lines) {
      const Record record = record_of(lines);
      const spec::Case c = read_request(lines);
      if (record.result.id != c.id || record.result.section != c.section)
        throw Refused(fmt::format("results.jsonl: line {}: is not the result of {}", lines.number + 1, c.id));
      if (planned) planned->take(c, record.result.origin, lines.request);
      check_shape(c, record, lines.answer);
      if (record.asked) {
        asked_.push_back(lines.number);
        setups_.insert(spec::write_setup_json(c.setup));
      }
      if (record.fault) ++faults_[c.section];
      if (record.result.result == Result::differs) ++groups_[record.result.key];
      sums_[c.section].section = c.section;
      add(sums_[c.section], record.result);
      results_.push_back(record.result);
    });
    if (planned) planned->finish();
    if (!capabilities_ && results_.size() > 1)
      throw Refused("cases.jsonl: has cases, but the bundle has no answer to hello");
    result_.asked = asked_.size();
    if (!capabilities_) return;
    const Json& identity = certificate_.at("identity");
    expect_same("certificate.json: setups", identity.at("setups"), setups_.size());
    expect_same("certificate.json: setups_sha256", identity.at("setups_sha256"), setups_hash(setups_));
  }

  void check_shape(const spec::Case& c, const Record& record, const std::string& answer) {
    const Result result = record.result.result;
    const auto fail = [&c](const std::string& why) { throw Refused(c.id + ": " + why); };
    const std::string inapplicable = capabilities_ ? why_not_applicable(*capabilities_, c) : std::string();
    if (!record.asked) {
      if (!answer.empty() || record.fault) fail("the controller was not asked, and there is an answer");
      if (result == Result::not_applicable) {
        if (inapplicable.empty()) fail("is recorded as not applicable, and applies to the controller");
      } else if (result != Result::not_run || record.result.why != kLeftOut || faults_[c.section] < kFewestFaults) {
        fail("the controller was not asked, and no reason is given");
      }
      return;
    }
    if (!inapplicable.empty()) fail("does not apply to the controller: " + inapplicable);
    if (result == Result::not_run) fail("the controller was asked, and the case was not judged");
    if (record.cut && !record.fault) fail("has an answer that is not complete");
    if (answer.empty() && !record.fault) fail("has no answer");
  }

  // Numbers of cases, ascending.
  std::vector<std::uint64_t> sample() {
    std::vector<std::uint64_t> chosen = asked_;
    if (!options_.all && options_.sample < chosen.size()) {
      std::mt19937_64 random(options_.seed);
      for (std::size_t i = 0; i < options_.sample; ++i)
        std::swap(chosen[i], chosen[i + random() % (chosen.size() - i)]);
      chosen.resize(options_.sample);
      std::ranges::sort(chosen);
    }
    return chosen;
  }

  void judge_again() {
    const std::vector<std::uint64_t> chosen = sample();
    auto next = chosen.begin();
    clauses_.resize(spec::kClauseCount);
    for_each_line([&](const Lines& lines) {
      if (next == chosen.end() || *next != lines.number) return;
      ++next;
      judge_again(lines);
      if (options_.progress) options_.progress(++result_.judged_again, chosen.size());
    });
    result_.judged_again = chosen.size();
  }

  void judge_again(const Lines& lines) {
    const Record record = record_of(lines);
    const spec::Case c = read_request(lines);
    const Capabilities capabilities = capabilities_.value_or(Capabilities{});
    try {
      Answer answer;
      if (lines.answer.empty() || record.cut)
        answer.result = record.fault.value();
      else
        answer = read_answer(capabilities, c, lines.answer);
      const judge::ModelRun run = judge::run_model(c);
      Record again;
      again.asked = true;
      again.result = asked_and_judged(c, record.result.origin, run, answer, judge_answer(capabilities, c, run, answer));
      if (const auto* fault = std::get_if<Fault>(&answer.result)) again.fault = *fault;
      add(clauses_, run.recorder.counts());
      if (const std::string words = difference(record, again); !words.empty())
        refuse(c.id + ": the recorded result and the result judged again differ: " + words);
    } catch (const spec::InputError& error) {
      refuse(c.id + ": " + error.message());
    }
  }

  // The findings of the certificate are those of the cases, with their files.
  void check_findings() {
    std::map<FailureKey, std::uint64_t> groups;
    std::map<std::string, std::uint64_t> never;  // by field
    std::set<std::string> fields;                // of the others
    for (const Json& json : certificate_.at("findings")) {
      FailureKey key{json.at("section").get<std::string>(), "", json.at("kind").get<std::string>()};
      if (!json.at("clause").is_null()) key.clause = json.at("clause").get<std::string>();
      const auto occurrences = json.at("occurrences").get<std::uint64_t>();
      const auto field = json.at("field").get<std::string>();
      check_file(json.at("file").get<std::string>(), key);
      if (key.kind == kNeverSent) {
        never[field] += occurrences;
      } else {
        groups[key] += occurrences;
        fields.insert(field);
      }
    }
    for (const auto& [key, cases] : groups_)
      if (!groups.contains(key))
        throw Refused(fmt::format("certificate.json: has no finding {} {}", key.kind, key.clause));
    for (const auto& [key, cases] : groups) {
      const auto found = groups_.find(key);
      expect_same(fmt::format("certificate.json: cases of the finding {} {}", key.kind, key.clause), cases,
                  found == groups_.end() ? 0 : found->second);
    }
    std::map<std::string, std::uint64_t> due;
    if (capabilities_)
      for (const NeverSent& field : never_sent(capabilities_->fields, results_))
        if (const std::string name(spec::field_name(field.field)); !fields.contains(name)) due[name] = field.cases;
    expect_same("certificate.json: fields never sent", never, due);
  }

  void check_file(const std::string& name, const FailureKey& key) {
    const auto file = bundle_->files.find(name);
    if (file == bundle_->files.end()) throw Refused(name + ": is missing");
    if (or_refused([&] { return read_finding(file->second, name); }).key != key)
      throw Refused(name + ": is not the finding that the certificate names");
  }

  // The certificate says what the cases add up to.
  void check_sums() {
    Certificate sum;
    if (capabilities_) sum.subject = *capabilities_;
    sum.self_check = certificate_.at("self_check") == "passed" ? "" : certificate_.at("self_check").get<std::string>();
    sum.interrupted = bundle_->manifest.interrupted;
    sum.chatter = certificate_.at("controller").at("chatter").get<std::string>();
    sum.findings.resize(certificate_.at("findings").size());
    if (options_.all) sum.clauses = clauses_;
    for (const Json& section : certificate_.at("sections")) sum.sections.push_back(section_of(section));
    for (const auto& [name, left] : sums_) throw Refused("certificate.json: has no section \"" + name + "\"");
    const Json expected = Json::parse(json_report(sum));
    for (const char* key :
         {"sections", "interrupted", "cases_not_run", "scope", "exit_status", "verdict", "controller", "left_out"})
      expect_same(std::string("certificate.json: ") + key, certificate_.at(key), expected.at(key));
    // What was judged in a controller that did not say hello reached no clause that counts.
    if (!options_.all || !capabilities_) return;
    for (const char* key : {"clauses", "clauses_not_exercised", "open_clauses_relied_on", "known"})
      expect_same(std::string("certificate.json: ") + key, certificate_.at(key), expected.at(key));
  }

  // Its sums; of one that was interrupted, cases that nobody looked at count as not run.
  SectionResult section_of(const Json& section) {
    const auto name = section.at("section").get<std::string>();
    SectionResult sum;
    sum.section = name;
    if (const auto found = sums_.find(name); found != sums_.end()) {
      sum = found->second;
      sums_.erase(found);
    }
    if (bundle_->manifest.interrupted.empty()) return sum;
    for (const Origin origin : {Origin::golden, Origin::generated, Origin::own}) {
      const auto cases = section.at("cases").at(std::string(certify::name(origin))).get<std::uint64_t>();
      std::uint64_t& count = sum.cases.at(static_cast<std::size_t>(origin));
      if (cases < count) continue;  // the comparison says so
      sum.results.at(static_cast<std::size_t>(Result::not_run)) += cases - count;
      count = cases;
    }
    return sum;
  }

  const VerifyOptions& options_;
  Verification result_;
  std::optional<Bundle> bundle_;
  Json certificate_;
  std::optional<Capabilities> capabilities_;  // none: the controller could not be asked
  std::vector<std::uint64_t> asked_;
  std::vector<CaseResult> results_;
  std::set<std::string> setups_;
  std::map<std::string, std::uint64_t> faults_;  // by section
  std::map<FailureKey, std::uint64_t> groups_;
  std::map<std::string, SectionResult> sums_;  // by section
  std::vector<model::ClauseCount> clauses_;
};

}  // namespace

Verification verify(const VerifyOptions& options) { return Verifying(options).run(); }

}  // namespace toolcomp::certify::bundle
