// SPDX-License-Identifier: Apache-2.0
// The check of the formal specification can fail: one spoilt copy for each thing it looks for.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

namespace fs = std::filesystem;

class FormalCheck : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("formal_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
               std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "source/fanuc");
    // Two files are enough, and quick.
    for (const char* file : {"Vectors.v", "fanuc/ToolLengthOffset.v", "allowed_axioms.txt", "README.md"})
      fs::copy(kSource / file, folder_ / "source" / file);
  }
  void TearDown() override { fs::remove_all(folder_); }

  int check() {
    const std::string command = "'" + (kSource / "check").string() + "' '" + (folder_ / "build").string() + "' '" +
                                (folder_ / "source").string() + "' >/dev/null 2>'" + (folder_ / "messages").string() +
                                "'";
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe): a script of ours
    return status == -1 ? -1 : WEXITSTATUS(status);
  }
  std::string messages() {
    std::ifstream in(folder_ / "messages");
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void append(const std::string& text) {
    std::ofstream(folder_ / "source/fanuc/ToolLengthOffset.v", std::ios::app) << text;
  }
  void expect_refused(const std::string& message) {
    EXPECT_EQ(check(), 1);
    EXPECT_NE(messages().find(message), std::string::npos) << messages();
  }

  const fs::path kSource = fs::path(TOOLCOMP_SOURCE_DIR) / "spec/formal";
  fs::path folder_;
};

const std::string kTheorem =
    "\n(** fanuc.length-offset.direction: truth. *)\nTheorem truth : True.\nProof. exact I. Qed.\n";
const std::string kInstance = "Example truth_instance : True.\nProof. exact truth. Qed.\n";

TEST_F(FormalCheck, AcceptsAGoodTheorem) {
  append(kTheorem + kInstance);
  std::ofstream(folder_ / "source/README.md", std::ios::app) << "* `truth`\n";
  EXPECT_EQ(check(), 0) << messages();
}

TEST_F(FormalCheck, RefusesATheoremThatIsNotListed) {
  append(kTheorem + kInstance);
  expect_refused("README.md does not list truth");
}

TEST_F(FormalCheck, RefusesATheoremWithoutInstance) {
  append(kTheorem);
  expect_refused("truth: no instance satisfies the hypotheses");
}

TEST_F(FormalCheck, RefusesAnInstanceThatIsNone) {
  append(kTheorem + "Example truth_instance : True.\nProof. exact I. Qed.\n");
  expect_refused("truth_instance: not an instance");
}

TEST_F(FormalCheck, RefusesATheoremWithoutClause) {
  append("\nTheorem truth : True.\nProof. exact I. Qed.\n" + kInstance);
  expect_refused("truth: the docstring has no clause id");
}

TEST_F(FormalCheck, RefusesWhatIsAdmitted) {
  append("\nLemma wrong : 1 = 2.\nProof. Admitted.\n");
  expect_refused("assumes without proof");
}

TEST_F(FormalCheck, RefusesAProofThatFails) {
  append("\nLemma wrong : 1 = 2.\nProof. lra. Qed.\n");
  EXPECT_EQ(check(), 1);
}

TEST_F(FormalCheck, RefusesAnAxiomThatIsNotAllowed) {
  std::ofstream(folder_ / "source/allowed_axioms.txt") << "Classical_Prop.classic\n";
  expect_refused("these axioms are not allowed");
}

TEST_F(FormalCheck, BadUsage) {
  const int status = std::system(("'" + (kSource / "check").string() + "' 2>/dev/null").c_str());  // NOLINT(*)
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

}  // namespace
