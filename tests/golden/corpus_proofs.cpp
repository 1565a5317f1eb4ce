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
#include "spec/language/file_writer.h"
#include "tests/sanitized.h"

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

TEST(GoldenProofs, CoqProvesASampleOfTheVectors) {
  const fs::path folder = fs::path(TOOLCOMP_BINARY_DIR) / "golden_proofs";
  fs::remove_all(folder);
  for (const ProofFile& file : write_proofs(default_folder(), folder)) {
    EXPECT_GE(file.lemmas, 10U) << file.file;
    EXPECT_GE(file.vectors, 10U) << file.file;
  }
  // Coq gives the same answer in every build: the sanitized one proves a few.
  if (toolcomp::test::kSanitized) write_proofs(default_folder(), folder, {6, 1, 1});
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
    const std::vector<Lemma> lemmas = leading_edge_lemmas(c);
    ASSERT_FALSE(lemmas.empty());
    spec::write_file(folder / "GoldenOne.v",
                     "From Coq Require Import Reals Lra List.\n"
                     "From Toolcomp Require Import Vectors LeadingEdgeOffset ToolLengthOffset ToolDirection Golden.\n"
                     "Open Scope R_scope.\n" +
                         lemmas.front().text);
  };
  write("7.071067811865475");
  EXPECT_EQ(check(folder), 0);
  write("7.071067811865476");
  EXPECT_NE(check(folder, " 2>/dev/null"), 0);
}

// Programs beyond the formal specification are left alone.
TEST(GoldenProofs, NothingIsSaidBeyondTheSpecification) {
  for (const spec::Case& c : read_cases(default_folder() / "fanuc/tool-length-offset/examples.jsonl")) {
    const bool beyond = c.program.find("G53") != std::string::npos || c.program.find("G28") != std::string::npos ||
                        c.program.find("G10") != std::string::npos || c.setup.bit(5001, 0) || c.setup.bit(5001, 2);
    EXPECT_EQ(length_offset_lemmas(c).empty(), beyond) << c.comment;
  }
}

}  // namespace
}  // namespace toolcomp::corpus
