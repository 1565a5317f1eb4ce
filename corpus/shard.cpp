// SPDX-License-Identifier: Apache-2.0
#include "corpus/shard.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "corpus/select.h"
#include "fuzz/gen/generator.h"
#include "host/file_writer.h"
#include "host/sha256.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// What all shards of one run have in common.
Json run_of(const GenerateOptions& options, std::size_t count) {
  return {{"shards", 1},
          {"of", count},
          {"generator", kGenerator},
          {"build", host::sha256_file("/proc/self/exe")},
          {"seed", std::to_string(options.seed)},
          {"vectors", options.vectors},
          {"candidates", options.candidates},
          {"sections", options.sections}};
}

SelectOptions select_options(const GenerateOptions& options) {
  return {options.seed, options.vectors, options.candidates};
}

// A file line by line: the run, then of each section its name and its contenders, then the digest of all that. A
// contender is a line with its number and what it reaches and one with the case; where the engines differ, its number
// alone.
class Reader {
 public:
  explicit Reader(fs::path file) : file_(std::move(file)), text_(spec::read_file(file_)) { expect_whole(); }

  // The run that it says it belongs to.
  const Json& run() const { return run_; }

  void add_to(std::map<std::string, std::vector<Contender>>& sections) {
    std::vector<Contender>* contenders = nullptr;
    while (at_ < end_) {
      const Json line = next_json();
      if (line.contains("section")) {
        contenders = &sections[line.at("section").get<std::string>()];
        continue;
      }
      if (contenders == nullptr) refuse("names no section");
      Contender contender;
      contender.index = line.at("candidate").get<std::size_t>();
      if (line.contains("features")) {
        contender.features = line.at("features").get<std::vector<std::uint32_t>>();
        contender.c = spec::read_case(next_line(), file_.string());
      }
      contenders->push_back(std::move(contender));
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw spec::InputError(file_.string(), number_, 0, "is not a complete shard: " + why);
  }

  void expect_whole() {
    const std::size_t last = text_.size() < 2 ? 0 : text_.rfind('\n', text_.size() - 2) + 1;
    const std::string digest = text_.substr(last);
    if (digest != host::sha256(std::string_view(text_).substr(0, last)) + '\n')
      refuse("its digest does not belong to its text");
    end_ = last;
    run_ = next_json();
  }

  std::string_view next_line() {
    const std::size_t begin = at_;
    if (begin >= end_) refuse("it ends too early");
    at_ = text_.find('\n', begin) + 1;
    ++number_;
    return std::string_view(text_).substr(begin, at_ - begin - 1);
  }

  Json next_json() {
    try {
      return Json::parse(next_line());
    } catch (const Json::exception& error) {
      refuse(error.what());
    }
  }

  fs::path file_;
  std::string text_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;
  std::size_t number_ = 0;
  Json run_;
};

// "shard-2-of-4.jsonl": how many there are.
std::optional<std::size_t> count_in(const std::string& name) {
  const std::size_t of = name.find("-of-");
  if (!name.starts_with("shard-") || !name.ends_with(".jsonl") || of == std::string::npos) return std::nullopt;
  std::size_t count = 0;
  const char* const end = name.data() + name.size() - std::string_view(".jsonl").size();
  const auto [at, error] = std::from_chars(name.data() + of + 4, end, count);
  return error == std::errc() && at == end && count > 0 ? std::optional(count) : std::nullopt;
}

std::size_t expect_all(const fs::path& folder) {
  std::optional<std::size_t> count;
  if (!fs::is_directory(folder)) throw spec::InputError(folder.string(), 0, 0, "is not a folder");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const auto here = count_in(entry.path().filename().string());
    if (!here) continue;
    if (count && *count != *here)
      throw spec::InputError(folder.string(), 0, 0, fmt::format("contains shards of {} and of {}", *count, *here));
    count = here;
  }
  if (!count) throw spec::InputError(folder.string(), 0, 0, "contains no shard (shard-I-of-N.jsonl)");
  std::vector<std::string> missing;
  for (std::size_t i = 1; i <= *count; ++i)
    if (!fs::exists(shard_file(folder, {i, *count}))) missing.push_back(fmt::format("{}/{}", i, *count));
  if (!missing.empty())
    throw spec::InputError(folder.string(), 0, 0,
                           fmt::format("shards are missing; run them again: {}", fmt::join(missing, " ")));
  return *count;
}

}  // namespace

fs::path shard_file(const fs::path& folder, const Share& share) {
  return folder / fmt::format("shard-{}-of-{}.jsonl", share.index, share.count);
}

void write_shard(const GenerateOptions& options, const Share& share) {
  expect_sections(options.sections);
  std::string text = run_of(options, share.count).dump() + '\n';
  for (const std::string_view section : fuzz::sections()) {
    if (!wants(options, section)) continue;
    text += Json{{"section", section}}.dump() + '\n';
    std::size_t count = 0;
    look(section, select_options(options), share, [&](const Contender& contender) {
      ++count;
      Json line{{"candidate", contender.index}};
      if (contender.c) line["features"] = contender.features;
      text += line.dump() + '\n';
      if (contender.c) text += spec::write_case_line(*contender.c) + '\n';
    });
    if (options.progress) options.progress(std::string(section), count);
  }
  text += host::sha256(text) + '\n';
  host::write_file(shard_file(options.folder, share), text);
}

GenerateResult merge_shards(const fs::path& shards, const GenerateOptions& options) {
  const std::size_t count = expect_all(shards);
  GenerateOptions whole = options;
  std::map<std::string, std::vector<Contender>> contenders;
  Json run;
  for (std::size_t i = 1; i <= count; ++i) {
    const fs::path file = shard_file(shards, {i, count});
    Reader reader(file);
    try {
      if (run.is_null()) {
        run = reader.run();
        whole.seed = std::stoull(run.at("seed").get<std::string>());
        whole.vectors = run.at("vectors").get<std::size_t>();
        whole.candidates = run.at("candidates").get<std::size_t>();
        whole.sections = run.at("sections").get<std::vector<std::string>>();
        if (run != run_of(whole, count))
          throw spec::InputError(file.string(), 1, 0, "was made by another build of toolcomp");
      }
      if (reader.run() != run)
        throw spec::InputError(file.string(), 1, 0,
                               "is from another run than " + shard_file(shards, {1, count}).string());
      reader.add_to(contenders);
    } catch (const Json::exception& error) {
      throw spec::InputError(file.string(), 0, 0, error.what());
    }
  }
  return generate(whole, [&](std::string_view section) {
    return select(section, select_options(whole), std::move(contenders[std::string(section)]));
  });
}

}  // namespace toolcomp::corpus
