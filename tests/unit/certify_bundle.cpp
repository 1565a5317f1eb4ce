// SPDX-License-Identifier: Apache-2.0
// Archives that nobody would make who means well, and the parts of a bundle by themselves.
#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "certify/bundle/archive_reader.h"
#include "certify/bundle/archive_writer.h"
#include "certify/bundle/bundle_reader.h"
#include "certify/bundle/plain_name.h"
#include "certify/bundle/record.h"
#include "certify/bundle/refused.h"
#include "certify/bundle/seal.h"
#include "certify/bundle/spool.h"
#include "certify/schema.h"
#include "host/sha256.h"
#include "host/temporary_folder.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::bundle {
namespace {

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Bundle, PlainNames) {
  for (const char* name : {"manifest.json", "inputs/001-a_b.nc", "x"}) EXPECT_TRUE(is_plain_name(name)) << name;
  for (const char* name : {"", "/etc/passwd", "../a", "a/../b", "a/..", ".hidden", "a/.b", "a//b", "a/b/c", "a\\b",
                           "a b", "a\n", "\xc3\xa4", "a/"})
    EXPECT_FALSE(is_plain_name(name)) << name;
  EXPECT_FALSE(is_plain_name(std::string("a\0b", 3)));
  EXPECT_FALSE(is_plain_name(std::string(500, 'a')));
}

TEST(Bundle, ASealIsThatOfEveryByte) {
  const host::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "f";
  const std::string body = "what stands before";
  const std::string whole = body + seal(host::sha256(body));
  // A frame that decompressors skip: 0x184D2A50, its length, its content (RFC 8878).
  EXPECT_EQ(whole.substr(body.size(), 8), std::string("\x50\x2a\x4d\x18\x47\0\0\0", 8));
  EXPECT_EQ(whole.size(), body.size() + 8 + 0x47);
  const auto sealed = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return is_sealed(file);
  };
  EXPECT_TRUE(sealed(whole));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_FALSE(sealed(changed)) << i;
    EXPECT_FALSE(sealed(whole.substr(0, i))) << i;
  }
  EXPECT_FALSE(sealed(whole + "x"));
  EXPECT_TRUE(sealed(seal(host::sha256(""))));
  EXPECT_THROW(static_cast<void>(is_sealed(folder.path() / "none")), spec::InputError);
}

TEST(Bundle, ASpoolGivesBackWhatItGot) {
  const host::TemporaryFolder folder;
  Spool spool(folder.path());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "it has no name";
  const std::string long_line(200'000, 'x');
  spool.append("one\n\n");
  spool.append(long_line + "\nlast");
  EXPECT_EQ(spool.finish(), host::sha256("one\n\n" + long_line + "\nlast"));
  EXPECT_EQ(spool.size(), 5 + long_line.size() + 5);
  for (int round = 0; round < 2; ++round) {
    std::string line;
    for (const std::string& expected : {std::string("one"), std::string(), long_line, std::string("last")}) {
      EXPECT_TRUE(spool.next_line(line));
      EXPECT_EQ(line, expected);
    }
    EXPECT_FALSE(spool.next_line(line));
    spool.rewind();
  }
}

TEST(Bundle, AnArchiveIsTheSameEveryTime) {
  const host::TemporaryFolder folder;
  const auto write = [&](const std::string& name) {
    ArchiveWriter archive(folder.path() / name);
    archive.add("a.txt", "text");
    Spool spool(folder.path());
    spool.append(std::string(300'000, 'y'));
    static_cast<void>(spool.finish());
    archive.add("b/c.txt", spool);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / name)) << "not before it is whole";
    archive.finish();
    return contents(folder.path() / name);
  };
  EXPECT_EQ(write("one"), write("two"));
  ArchiveReader archive(folder.path() / "one");
  const auto text = [&] {
    std::string bytes;
    archive.read([&](std::string_view piece) { bytes += piece; });
    return bytes;
  };
  EXPECT_EQ(archive.next().value().name, "a.txt");
  EXPECT_EQ(text(), "text");
  EXPECT_EQ(archive.next().value().name, "b/c.txt");
  EXPECT_EQ(text(), std::string(300'000, 'y'));
  EXPECT_FALSE(archive.next());
  // What is never finished leaves nothing.
  {
    ArchiveWriter left(folder.path() / "left");
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

// A sealed archive with members that libarchive itself writes as it is told.
class Hostile {
 public:
  using Add = std::function<void(struct archive*, archive_entry*)>;

  std::string refused(const Add& add) const {
    std::string bytes(std::size_t{1} << 20, '\0');
    std::size_t used = 0;
    struct archive* archive = archive_write_new();
    archive_write_add_filter_zstd(archive);
    archive_write_set_format_pax_restricted(archive);
    EXPECT_EQ(archive_write_open_memory(archive, bytes.data(), bytes.size(), &used), ARCHIVE_OK);
    archive_entry* entry = archive_entry_new();
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    add(archive, entry);
    archive_entry_free(entry);
    archive_write_close(archive);
    archive_write_free(archive);
    bytes.resize(used);
    const std::filesystem::path file = folder_.path() / "hostile.tar.zst";
    std::ofstream(file, std::ios::binary) << bytes << seal(host::sha256(bytes));
    try {
      static_cast<void>(read_bundle(file));
    } catch (const Refused& why) {
      return why.what();
    } catch (const spec::InputError& why) {  // what cannot be read, with its place
      return std::string("unreadable: ") + why.what();
    }
    return "";
  }
  static void text(struct archive* archive, archive_entry* entry, const char* name, const std::string& bytes) {
    archive_entry_set_pathname(entry, name);
    archive_entry_set_size(entry, static_cast<la_int64_t>(bytes.size()));
    EXPECT_EQ(archive_write_header(archive, entry), ARCHIVE_OK);
    archive_write_data(archive, bytes.data(), bytes.size());
  }

 private:
  host::TemporaryFolder folder_;
};

// A manifest that names these files, each of `size` bytes.
std::string manifest_of(const std::vector<std::string>& files, std::uint64_t size) {
  Manifest manifest;
  for (const std::string& file : files) manifest.files.push_back({file, size, host::sha256("")});
  return write_manifest(manifest);
}

const std::vector<std::string> kNeeded{"answers.jsonl", "cases.jsonl", "certificate.json", "results.jsonl",
                                       "sbom.spdx.json"};

TEST(Bundle, HostileArchivesAreRefused) {
  const Hostile hostile;
  const std::string manifest = manifest_of(kNeeded, 0);
  for (const char* name : {"../manifest.json", "/etc/passwd", "a/../../b", "manifest.json/"})
    EXPECT_EQ(hostile.refused([&](auto* archive, auto* entry) { Hostile::text(archive, entry, name, "x"); }),
              "a member has a name that is not allowed in a bundle")
        << name;
  EXPECT_EQ(hostile.refused([&](auto* archive, auto* entry) {
    archive_entry_set_filetype(entry, AE_IFLNK);
    archive_entry_set_symlink(entry, "/etc/passwd");
    Hostile::text(archive, entry, "manifest.json", "");
  }),
            "manifest.json: is not a regular file");
  EXPECT_EQ(hostile.refused([&](auto* archive, auto* entry) {
    Hostile::text(archive, entry, "manifest.json", manifest);
    archive_entry_set_hardlink(entry, "manifest.json");
    Hostile::text(archive, entry, "cases.jsonl", "");
  }),
            "cases.jsonl: is not a regular file");
  EXPECT_EQ(hostile.refused([&](auto* archive, auto* entry) {
    Hostile::text(archive, entry, "manifest.json", manifest);
    for (const std::string& name : kNeeded) Hostile::text(archive, entry, name.c_str(), "");
    Hostile::text(archive, entry, "cases.jsonl", "");
  }),
            "cases.jsonl: is in the bundle twice");
  EXPECT_EQ(hostile.refused([&](auto* archive, auto* entry) {
    for (int i = 0; i < 2; ++i) Hostile::text(archive, entry, "manifest.json", manifest);
  }),
            "manifest.json: is not in the manifest");
  EXPECT_EQ(hostile.refused([&](auto* archive, auto* entry) {
    Hostile::text(archive, entry, "manifest.json", manifest);
    Hostile::text(archive, entry, "answers.jsonl", "longer");
  }),
            "answers.jsonl: has 6 bytes and should have 0");
  EXPECT_EQ(hostile.refused([&](auto* archive, auto* entry) {
    archive_entry_set_pathname(entry, "manifest.json");
    archive_entry_set_size(entry, la_int64_t{600} << 20);
    archive_write_header(archive, entry);
  }),
            "manifest.json: is too large");
  EXPECT_EQ(hostile.refused([](auto*, auto*) {}), "does not begin with manifest.json");
}

TEST(Bundle, ManifestsThatCannotBeAreRefused) {
  const Hostile hostile;
  const auto refused = [&](const std::string& manifest) {
    return hostile.refused(
        [&](auto* archive, auto* entry) { Hostile::text(archive, entry, "manifest.json", manifest); });
  };
  std::vector<std::string> files = kNeeded;
  EXPECT_EQ(refused(manifest_of(files, 0)), "answers.jsonl: is missing");
  EXPECT_EQ(refused(manifest_of(files, std::uint64_t{1} << 33)),
            "manifest.json: the files are larger in total than toolcomp can read");
  EXPECT_TRUE(refused(manifest_of(files, UINT64_MAX)).starts_with("unreadable: manifest.json:"));
  EXPECT_EQ(refused(manifest_of(files, std::uint64_t{1} << 29)),
            "manifest.json: the files are larger in total than toolcomp can hold in memory");
  files.push_back("cases.jsonl");
  EXPECT_EQ(refused(manifest_of(files, 0)), "manifest.json: names cases.jsonl twice");
  files.back() = "../x";
  EXPECT_EQ(refused(manifest_of(files, 0)), "manifest.json: has a file name that is not allowed in a bundle");
  files.back() = "manifest.json";
  EXPECT_EQ(refused(manifest_of(files, 0)), "manifest.json: names manifest.json twice");
  EXPECT_EQ(refused(manifest_of({"cases.jsonl"}, 0)), "manifest.json: does not name answers.jsonl");
  for (const char* text : {"", "[]", "{", "null", R"({"evidence":"1"})", R"({"evidence":1})",
                           "{\"evidence\":1,\"tool\":7}", R"({"evidence":2})", R"({"evidence":1,"more":1})"})
    EXPECT_TRUE(refused(text).starts_with("unreadable: manifest.json:1:")) << text;
  EXPECT_EQ(refused(std::string(1'000'000, '[')), "unreadable: manifest.json:1:66: nested too deep");
}

TEST(Bundle, SchemaFilesAreTheSchemas) {
  const auto file = [](const std::string& name) {
    std::ifstream stream(TOOLCOMP_SOURCE_DIR "/corpus/schema/" + name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(file("finding.schema.json"), finding_schema());
  EXPECT_EQ(file("manifest.schema.json"), manifest_schema());
}

TEST(Bundle, ARecordComesBackAsItWas) {
  Record record;
  record.asked = true;
  record.result.id = "a";
  record.result.section = "fanuc/tool-offset";
  record.result.origin = Origin::golden;
  record.result.result = Result::differs;
  record.result.key = {"fanuc/tool-offset", "fanuc.tool-offset.x", "crash"};
  record.result.why = "why";
  record.result.sent = {spec::Field::kind, spec::Field::clauses};
  record.result.verdict.values = 17;
  record.result.verdict.worst_ulp = 0.1;
  record.result.verdict.left_out = 5;
  record.result.verdict.left_out_for = {{static_cast<spec::Clause>(3), 4}, {static_cast<spec::Clause>(7), 2}};
  record.result.verdict.bias = {3, -0.25, 0.125};
  record.result.verdict.widths.add(1.5);
  record.fault = Fault{FaultKind::crash, "ended\xff", "exit status 3", "servo"};
  record.cut = true;
  const std::string line = write_record(4, record);
  const Record again = read_record(4, line);
  EXPECT_EQ(difference(record, again), "");
  EXPECT_EQ(again.result.key, record.result.key);
  EXPECT_EQ(again.result.sent, record.result.sent);
  EXPECT_EQ(again.result.verdict.left_out, 5U);
  EXPECT_EQ(again.result.verdict.left_out_for, record.result.verdict.left_out_for);
  EXPECT_EQ(again.fault->status, "exit status 3");
  EXPECT_TRUE(again.cut);
  Record other = again;
  other.result.verdict.values = 18;
  EXPECT_EQ(difference(again, other), "values: 17 and 18");
  other = again;
  other.fault.reset();
  EXPECT_EQ(difference(again, other), "fault: \"crash\" and null");
  EXPECT_THROW(static_cast<void>(read_record(5, line)), spec::InputError);
  for (const char* text : {"", "{}", "[]", R"({"case":0,"id":1})"})
    EXPECT_THROW(static_cast<void>(read_record(0, text)), spec::InputError) << text;
}

}  // namespace
}  // namespace toolcomp::certify::bundle
