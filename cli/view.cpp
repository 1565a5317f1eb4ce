// SPDX-License-Identifier: Apache-2.0
// toolcomp view: a page to step through a program, written or served.
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "certify/view/program_page.h"
#include "cli/manners.h"
#include "cli/page_server.h"
#include "cli/program_page.h"
#include "cli/shown_place.h"
#include "cli/stop.h"
#include "cli/verbs.h"
#include "cli/watched_files.h"
#include "host/file_writer.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

std::string usual_file(const ViewOptions& options) {
  if (options.program == "-") return "-";
  const std::string file = fs::path(options.program).stem().string() + ".html";
  expect_page_of_ours(file);
  return file;
}

int write(const ViewOptions& options) {
  const std::string file = options.out.empty() ? usual_file(options) : options.out;
  const ProgramPage page = program_page(options, {}, false, [] {});
  if (file == "-") {
    std::cout << page.html;
  } else {
    try {
      host::write_file(file, page.html);
    } catch (const std::runtime_error& error) {
      throw spec::InputError("--out", 0, 0, error.what());
    }
  }
  report_alarms(page);
  if (file != "-") note("wrote " + file);
  return page.undecided ? kUndecided : kAgrees;
}

// A rebuild that is no longer wanted.
struct GivenUp : std::exception {};

// Serves the page and makes it anew, in a thread of its own, when a file has changed.
class Serving {
 public:
  explicit Serving(const ViewOptions& options)
      : options_(options), server_(options.port), begun_(std::to_string(::getpid()) + '.' + ticks()) {}
  ~Serving() {
    give_up_ = true;
    if (worker_.joinable()) worker_.join();
  }
  Serving(const Serving&) = delete;
  Serving& operator=(const Serving&) = delete;

  void run() {
    const Stop stop;
    server_.show(certify::waiting_page(names(begun_)), begun_);
    build();
    std::cout << server_.address() << std::endl;  // NOLINT(performance-avoid-endl): it waits from here on
    note("serves " + options_.program + ", and watches this file and its setup; Ctrl-C ends it");
    server_.run(std::chrono::milliseconds(200), [&] {
      if (!stop.why().empty()) return server_.stop();
      look();
    });
  }

 private:
  static std::string ticks() {
    return std::to_string(std::chrono::system_clock::now().time_since_epoch() / std::chrono::milliseconds(1));
  }

  [[nodiscard]] certify::ProgramPageNames names(const std::string& version) const {
    return {options_.program, setup_of(options_), version};
  }

  void look() {
    if (!is_building_ && worker_.joinable()) {
      worker_.join();
      files_.watch_too(called_);
    }
    wanted_ = files_.changed() || wanted_;
    if (!wanted_) return;
    // What is being made is of files that are no more.
    give_up_ = true;
    if (!is_building_) build();
  }

  void build() {
    wanted_ = false;
    give_up_ = false;
    is_building_ = true;
    files_.watch({options_.program, setup_of(options_)});
    files_.watch_too(called_);
    worker_ = std::thread([this, version = begun_ + '.' + std::to_string(++count_)] {
      make(version);
      is_building_ = false;
    });
  }

  void make(const std::string& version) {
    try {
      ProgramPage page = program_page(options_, version, false, [this] {
        if (give_up_) throw GivenUp();
      });
      report_alarms(page);
      called_ = page.called_files;
      server_.show(std::move(page.html), version);
    } catch (const GivenUp&) {
      wanted_ = true;
    } catch (const spec::InputError& error) {
      show_fault(in_characters(error), version);
    } catch (const std::exception& error) {
      show_fault({options_.program, 0, 0, std::string("internal error: ") + error.what()}, version);
    }
  }

  void show_fault(const spec::InputError& fault, const std::string& version) {
    std::cerr << painted_diagnostic(fault.what()) << '\n';
    server_.show(certify::fault_page(fault, names(version)), version);
  }

  const ViewOptions& options_;
  PageServer server_;
  WatchedFiles files_;
  std::string begun_;  // tells this server from one before it
  std::uint64_t count_ = 0;
  std::vector<std::string> called_;  // the worker's while it runs
  std::thread worker_;
  std::atomic<bool> is_building_ = false;
  std::atomic<bool> give_up_ = false;
  std::atomic<bool> wanted_ = false;  // a new page
};

}  // namespace

int view(const ViewOptions& options) {
  say_what_is_read(options.program, options.setup);
  if (!options.serve) return write(options);
  if (!options.out.empty()) throw spec::InputError("--out", 0, 0, "cannot be given together with --serve");
  if (options.program == "-") throw spec::InputError("--serve", 0, 0, "needs a program file, not standard input");
  // A program that is not there is a slip of the command line; one that cannot be read may be mended.
  static_cast<void>(spec::file_source(options.program));
  Serving(options).run();
  return kAgrees;
}

}  // namespace toolcomp::cli
