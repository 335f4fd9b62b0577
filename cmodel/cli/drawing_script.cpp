// SPDX-License-Identifier: Apache-2.0
#include "drawing_script.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "../io/error.hpp"
#include "../io/interrupt.hpp"
#include "../io/output_file.hpp"
#include "source_tree.hpp"

extern char** environ;

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPython = "/usr/bin/python3";

fs::path script() {
  if (const char* named = std::getenv("HALFSPACE_CHARTS"); named != nullptr) return named;
  const fs::path folder = folder_with("testbench/charts.py");
  return folder.empty() ? folder : folder / "testbench" / "charts.py";
}

// Exit status, or -1 when it did not run to its end.
int run(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0) return -1;
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace

void require_drawing_script() {
  const fs::path path = script();
  if (path.empty() || !fs::exists(path)) {
    throw Error(ErrorCode::kDrawing, "--out",
                "testbench/charts.py is not there (a program outside its source tree draws no "
                "charts; --out F.json writes the data)");
  }
  if (run({kPython, "-c",
           "import importlib.util, sys; "
           "sys.exit(importlib.util.find_spec('matplotlib') is None)"}) != 0) {
    throw Error(ErrorCode::kDrawing, "--out",
                "python3-matplotlib is not installed (--out F.json writes the data)");
  }
}

void draw_chart(const std::string& name, const nlohmann::ordered_json& data,
                const std::string& out) {
  const std::string json = out + ".data.json";
  OutputFile file(json);
  file.write(data.dump() + "\n");
  file.commit();
  remove_on_interrupt(json);
  const int status = run({kPython, script().string(), "draw", name, json, out});
  fs::remove(json);
  remove_on_interrupt({});
  if (status != 0) {
    throw Error(ErrorCode::kDrawing, out,
                status == 3 ? "there is nothing to draw: the scene shows no pixels"
                            : fmt::format("charts.py ended with status {}", status));
  }
}

}  // namespace halfspace
