// SPDX-License-Identifier: Apache-2.0
// program: coq
// begins first
// The formal specification proves golden vectors: lemmas are generated and given to Coq (corpus/proofs/check).
#include "corpus/proofs/proofs.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "corpus/golden.h"
#include "host/file_writer.h"
#include "tests/effort.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

int run(const std::string& command) {
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe): a script of ours
  return status == -1 ? -1 : WEXITSTATUS(status);
}

std::string quoted(const fs::path& path) { return '\'' + path.string() + '\''; }

// Exit status of the check of a folder; the formal specification it rests on is compiled once for all of them.
int check(const fs::path& folder, const std::string& messages = "") {
  return run(quoted(fs::path(TOOLCOMP_SOURCE_DIR) / "corpus/proofs/check") + ' ' + quoted(folder) + ' ' +
             quoted(fs::path(TOOLCOMP_BINARY_DIR) / "spec/formal/compiled") + messages);
}

// Of each section some vectors; all of them: ./dev proofs.
TEST(GoldenProofs, CoqProvesASampleOfTheVectors) {
  const fs::path folder = fs::path(TOOLCOMP_BINARY_DIR) / "golden_proofs";
  fs::remove_all(folder);
  ProofOptions options;
  // Coq gives the same answer in every build.
  options.a_section = toolcomp::test::effort(1U, 12U);
  if (!toolcomp::test::whole())
    options.sections = {"fanuc/tool-length-offset", "fanuc/cutter-compensation-c", "fanuc/tool-posture-control",
                        "heidenhain/face-milling"};
  const ProofFiles written = write_proofs(default_folder(), folder, options);
  EXPECT_EQ(written.vectors.size(),
            toolcomp::test::whole() ? count_proofs(default_folder()).size() : options.sections.size());
  for (const auto& [section, vectors] : written.vectors) EXPECT_GT(vectors, 0U) << section;
  EXPECT_EQ(check(folder), 0);
}

// A vector that is wrong by one in the last decimal has no proof.
TEST(GoldenProofs, CoqRefusesAWrongVector) {
  const fs::path folder = fs::path(TOOLCOMP_BINARY_DIR) / "golden_proofs_wrong";
  fs::remove_all(folder);
  spec::Case c = read_cases(default_folder() / "fanuc/leading-edge-offset/rules.jsonl").front();
  ASSERT_TRUE(c.comment.starts_with("19631 = 30"));
  // The start: VC = (-5 sqrt 2, 5 sqrt 2, 0) = (-7.0710678118654752…, 7.0710678118654752…, 0).
  ASSERT_EQ(c.expect[1].point[1].v, "7.071067811865475");
  const auto write = [&](const std::string& v) {
    c.expect[1].point.value[1].v = v;
    host::write_file(folder / "GoldenOne.v", proofs_head() + proof_of(c));
  };
  write("7.071067811865475");
  EXPECT_EQ(check(folder), 0);
  write("7.071067811865476");
  EXPECT_NE(check(folder, " 2>/dev/null"), 0);
}

// Every vector listed exists; of each section some are proven.
TEST(GoldenProofs, TheListOfUnprovenVectorsIsWhole) {
  std::size_t listed = 0;
  for (const spec::ProofCount& count : count_proofs(default_folder())) {
    EXPECT_GT(count.proven, 0U) << count.section;
    listed += count.vectors - count.proven;
  }
  EXPECT_EQ(listed, unproven().size());
}

}  // namespace
}  // namespace toolcomp::corpus
