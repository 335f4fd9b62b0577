// SPDX-License-Identifier: Apache-2.0
#include "scene_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <span>

#include "choice.hpp"
#include "io/error.hpp"
#include "io/input_files.hpp"
#include "io/output_file.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr Choice<const char*> kFormats[] = {{"obj", ".obj"}, {"gltf", ".gltf"}, {"glb", ".glb"},
                                            {"ply", ".ply"}, {"stl", ".stl"},   {"tcov", ".tcov"}};

// Readers go back and forth in a file, and know its format by its name.
class StandardInput {
 public:
  explicit StandardInput(const std::string& extension)
      : path_(
            (fs::temp_directory_path() / fmt::format("halfspace-stdin-{}{}", ::getpid(), extension))
                .string()),
        removed_(path_) {
    OutputFile file(path_);
    std::array<char, 1 << 16> buffer;
    for (;;) {
      const ssize_t got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
      if (got == 0) break;
      if (got < 0 && errno != EINTR) {
        throw Error(ErrorCode::kFileRead, kStandardStream,
                    std::string("cannot read: ") + std::strerror(errno));
      }
      if (got > 0) file.write({buffer.data(), static_cast<std::size_t>(got)});
    }
    file.commit();
  }
  ~StandardInput() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  RemovedOnInterrupt removed_;
};

std::optional<StandardInput>& standard_input() {
  static std::optional<StandardInput> input;
  return input;
}

}  // namespace

void add_format_option(Command& command, std::string& format) {
  command.add_option("--format", format, "Format of a scene from standard input (-)")
      ->type_name(type_name_of(std::span(kFormats)));
}

std::string scene_file(const std::string& name, const std::string& format) {
  note_input(name);
  if (name != kStandardStream) {
    if (format.empty()) return name;
    throw Error(ErrorCode::kUsage, "--format",
                fmt::format("is for standard input (-): the name of {} says its format", name));
  }
  if (format.empty()) {
    throw Error(ErrorCode::kUsage, kStandardStream,
                fmt::format("standard input has no name to know its format by: give --format {}",
                            type_name_of(std::span(kFormats))));
  }
  const char* extension = chosen(std::span(kFormats), format, "--format");
  if (!standard_input()) standard_input().emplace(extension);
  return standard_input()->path();
}

std::string with_scene_names(const std::string& text) {
  if (!standard_input()) return text;
  const std::string& path = standard_input()->path();
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, from)) {
    out.append(text, from, at - from);
    out += kStandardStream;
    from = at + path.size();
  }
  return out.append(text, from);
}

}  // namespace halfspace
