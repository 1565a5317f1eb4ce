// SPDX-License-Identifier: Apache-2.0
// toolcomp verify: whether a certificate is what its evidence says.
#include <fmt/format.h>

#include <iostream>
#include <random>

#include "certify/bundle/verify.h"
#include "cli/manners.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "corpus/golden.h"
#include "spec/language/printable.h"

namespace toolcomp::cli {
namespace {

// Whoever makes a bundle must not know what will be looked at.
std::uint64_t any_seed() { return std::random_device{}(); }

// All of this is what the bundle says of itself.
void print(const certify::bundle::Verification& v, const VerifyOptions& options, std::uint64_t seed) {
  using spec::printable;
  if (!v.manifest.tool.empty())
    fmt::print("evidence of {}, made {}{}\n", printable(v.manifest.tool), printable(v.manifest.made),
               v.manifest.interrupted.empty() ? "" : ", " + printable(v.manifest.interrupted));
  if (!v.controller.empty()) fmt::print("controller: {}\n", printable(v.controller));
  if (!v.verdict.empty())
    fmt::print("certificate: {}; {} cases asked; corpus {}\n", printable(v.verdict), v.asked, printable(v.corpus));
  if (v.judged_again > 0) {
    const bool all = v.judged_again == v.asked;
    fmt::print("judged again: {} of {} cases{}\n", v.judged_again, v.asked, all ? "" : fmt::format(", seed {}", seed));
  }
  fmt::print("signature: {}\n", v.signature.empty() ? "none" : printable(v.signature));
  for (const std::string& why : v.refused) fmt::print("refused: {}\n", printable(why));
  fmt::print("{}: {}\n", printable(options.file), v.refused.empty() ? "accepted" : "refused");
}

}  // namespace

int verify(const VerifyOptions& options) {
  certify::bundle::VerifyOptions how;
  how.file = options.file;
  how.corpus = options.corpus.empty() ? corpus::default_folder() : std::filesystem::path(options.corpus);
  how.sample = options.sample;
  how.seed = options.seed.value_or(any_seed());
  how.all = options.all;
  detail(fmt::format("reads {}; corpus {}; seed {}", how.file.string(), how.corpus.string(), how.seed));
  certify::bundle::Verification verification;
  {
    const Progress progress("cases");
    how.progress = [](std::uint64_t done, std::uint64_t all) {
      Progress::line(fmt::format("{} of {} cases judged again", done, all));
    };
    verification = certify::bundle::verify(how);
  }
  print(verification, options, how.seed);
  return verification.refused.empty() ? kAgrees : kDiffers;
}

}  // namespace toolcomp::cli
