// SPDX-License-Identifier: Apache-2.0
#include "rtl_build.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <sstream>
#include <system_error>

#include "io/child_process.hpp"
#include "io/error.hpp"
#include "io/escape.hpp"
#include "io/interrupt.hpp"
#include "io/output_file.hpp"
#include "io/source_tree.hpp"
#include "rtl_recipe.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

// Verilator 4 does not read the checkers. Others than these are built with, and named.
constexpr std::array kTested{"5.006", "5.032"};

bool can_write(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  return ::access(folder.c_str(), W_OK) == 0;
}

fs::path cache_folder() {
  if (const std::string named = variable("HALFSPACE_RTL_CACHE"); !named.empty()) return named;
  std::error_code error;
  const fs::path tree = fs::canonical(folder_with("testbench/rtl/rtl_object.cpp"), error);
  if (!tree.empty() && fs::exists(tree / "CMakeLists.txt", error) &&
      can_write(tree / "build/rtl")) {
    return tree / "build/rtl";
  }
  if (const std::string xdg = variable("XDG_CACHE_HOME"); !xdg.empty()) {
    return fs::path(xdg) / "halfspace/rtl";
  }
  if (const std::string home = variable("HOME"); !home.empty()) {
    return fs::path(home) / ".cache/halfspace/rtl";
  }
  // Not a folder in /tmp: anybody could have put an object there.
  throw Error(ErrorCode::kFileWrite, "HALFSPACE_RTL_CACHE",
              "is not set, nor is HOME: there is no place for the built RTL");
}

// One line on a terminal, replaced by the next and erased in the end.
class StatusLine {
 public:
  StatusLine() : terminal_(::isatty(STDERR_FILENO) != 0) {}
  ~StatusLine() {
    if (shown_) fmt::print(stderr, "\r\033[K");
  }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;
  void show(const std::string& text) {
    if (!terminal_) return;
    shown_ = true;
    fmt::print(stderr, "\r\033[K{}", text);
  }

 private:
  bool terminal_;
  bool shown_ = false;
};

// Held by whoever builds the object of that hash: a byte of one file, so that no file is left.
class BuildLock {
  using FileRange = struct flock;

 public:
  BuildLock(const fs::path& cache, std::uint64_t hash, StatusLine& status)
      : file_(::open((cache / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    FileRange range{};
    range.l_type = F_WRLCK;
    range.l_whence = SEEK_SET;
    range.l_start = static_cast<off_t>(hash >> 1);
    range.l_len = 1;
    if (file_ < 0 || ::fcntl(file_, F_OFD_SETLK, &range) == 0) return;
    // Where files cannot be locked, two build it and the later one stays.
    if (errno != EAGAIN && errno != EACCES) return;
    status.show("waiting for another process that builds this RTL");
    ::fcntl(file_, F_OFD_SETLKW, &range);
  }
  ~BuildLock() {
    if (file_ >= 0) ::close(file_);
  }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;

 private:
  int file_;
};

// The folder in which an object is built, gone with this object or on an interrupt.
class WorkFolder {
 public:
  explicit WorkFolder(const fs::path& path)
      : path_(path), removed_(path.string(), RemovedOnInterrupt::Kind::kTree) {
    std::error_code error;
    fs::create_directories(path / "rtl/checkers", error);
    if (error)
      throw Error(ErrorCode::kFileWrite, path.string(), "cannot write: " + error.message());
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  RemovedOnInterrupt removed_;
};

// The line of a log that says what went wrong.
std::string complaint(const fs::path& log) {
  std::istringstream lines(read_file(log.string()));
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("rror:") != std::string::npos) return line;
    if (!line.empty()) last = line;
  }
  return last;
}

class Build {
 public:
  Build(const fs::path& object, const RtlRecipe& recipe, const RtlTools& tools, bool waves)
      : object_(object),
        log_(fs::path(object).replace_extension(".log")),
        recipe_(recipe),
        tools_(tools),
        waves_(waves),
        work_(fs::path(object).replace_extension(fmt::format(".partial-{}", ::getpid()))),
        log_removed_(std::in_place, log_.string()) {}

  void run(StatusLine& status) {
    for (const auto& [name, text] : recipe_.files) write_text((work_.path() / name).string(), text);
    write_text(log_.string(), tools_.verilator + "\n" + tools_.compiler + "\n");
    status.show("building this RTL, once: Verilator (1/2)");
    step(fmt::format("{}{}{}", kVerilateCommand, waves_ ? " --trace-fst" : "", recipe_.sources));
    const fs::path include =
        fs::path(first_line_of("verilator --getenv VERILATOR_ROOT")) / "include";
    write_runtime(include);
    status.show("building this RTL, once: the C++ compiler (2/2)");
    step(fmt::format("set -- {}{}", arguments(include), kCompileCommands));
    std::error_code error;
    fs::rename(work_.path() / "object.so", object_, error);
    if (error) {
      throw Error(ErrorCode::kFileWrite, object_.string(), "cannot write: " + error.message());
    }
    fs::remove(log_, error);
  }

 private:
  void step(const std::string& command) {
    const std::string line =
        fmt::format("cd {} && {{ {}\n}} >> {} 2>&1", quoted(work_.path().string()), command,
                    quoted(fs::absolute(log_).string()));
    if (run_child({"/bin/sh", "-e", "-c", line}) == 0) return;
    log_removed_.reset();  // it stays
    throw Error(
        ErrorCode::kRtlBuild, "",
        fmt::format("building the RTL failed: {:.200} (log: {})", complaint(log_), log_.string()));
  }

  void write_runtime(const fs::path& include) const {
    std::string text = "#include \"verilated.cpp\"\n";
    if (fs::exists(include / "verilated_threads.cpp")) {
      text += "#include \"verilated_threads.cpp\"\n";
    }
    if (waves_) text += "#include \"verilated_fst_c.cpp\"\n";
    write_text((work_.path() / "runtime.cc").string(), text);
  }

  std::string arguments(const fs::path& include) const {
    const std::string compile = fmt::format(
        "{} -std=c++20 -fPIC -fvisibility=hidden -w -I. -I{} -I{} -DVL_TIME_CONTEXT "
        "-DVM_COVERAGE=0 "
        "-DVM_SC=0 -DVM_TRACE={} -DVM_TRACE_FST={} -DVM_TRACE_VCD=0 -DHS_WAVES={}",
        tools_.command, include.string(), (include / "vltstd").string(), waves_ ? 1 : 0,
        waves_ ? 1 : 0, waves_ ? 1 : 0);
    return fmt::format("{} {}", quoted(compile), quoted(waves_ ? "-lz -pthread" : "-pthread"));
  }

  fs::path object_;
  fs::path log_;
  const RtlRecipe& recipe_;
  const RtlTools& tools_;
  bool waves_;
  WorkFolder work_;
  std::optional<RemovedOnInterrupt> log_removed_;
};

// What a process that was killed left of the same object; nobody else builds it now.
void remove_remains(const fs::path& object) {
  std::error_code ignored;
  const std::string start = object.stem().string() + ".partial-";
  for (const auto& entry : fs::directory_iterator(object.parent_path(), ignored)) {
    if (entry.path().filename().string().starts_with(start)) fs::remove_all(entry.path(), ignored);
  }
}

void name_untested(const std::string& verilator) {
  for (const char* version : kTested) {
    if (verilator.find(fmt::format("Verilator {} ", version)) != std::string::npos) return;
  }
  fmt::print(stderr, "halfspace: note: {} has not been tried with this RTL ({} have)\n", verilator,
             fmt::join(kTested, ", "));
}

}  // namespace

std::string rtl_tools_missing() { return rtl_tools().missing(); }

fs::path rtl_object_file(const Config& config, bool waves, const std::string& place) {
  const RtlTools& tools = rtl_tools();
  if (const std::string lack = tools.missing(); !lack.empty()) {
    throw Error(ErrorCode::kLevel, place, "the RTL is built when it is asked for: " + lack);
  }
  const RtlRecipe recipe = rtl_recipe(config, place);
  const std::uint64_t hash = hash_of(recipe, tools);
  const fs::path cache = cache_folder();
  const fs::path object =
      cache / fmt::format("s{}n{}k{}x{}m{}g{}i{}t{}{}-{:016x}.so", config.subpixel_bits,
                          config.viewport_bits, config.guard_bits, config.extent_bits,
                          config.samples, config.grid_log2, config.setup_interval, config.tag_bits,
                          waves ? "-waves" : "", hash);
  if (fs::exists(object)) return object;
  if (!can_write(cache)) {
    throw Error(ErrorCode::kFileWrite, cache.string(),
                "cannot write the built RTL (set HALFSPACE_RTL_CACHE)");
  }
  StatusLine status;
  const BuildLock lock(cache, hash, status);
  if (fs::exists(object)) return object;
  remove_remains(object);
  name_untested(tools.verilator);
  Build(object, recipe, tools, waves).run(status);
  return object;
}

}  // namespace halfspace
