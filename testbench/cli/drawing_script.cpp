// SPDX-License-Identifier: Apache-2.0
#include "drawing_script.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/child_process.hpp"
#include "io/error.hpp"
#include "io/interrupt.hpp"
#include "io/output_file.hpp"
#include "io/source_tree.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPython = "/usr/bin/python3";

fs::path script() {
  if (const char* named = std::getenv("HALFSPACE_CHARTS"); named != nullptr) return named;
  const fs::path folder = folder_with("testbench/charts/charts.py");
  return folder.empty() ? folder : folder / "testbench" / "charts" / "charts.py";
}

}  // namespace

void require_drawing_script() {
  const fs::path path = script();
  if (path.empty() || !fs::exists(path)) {
    throw Error(
        ErrorCode::kDrawing, "--out",
        "testbench/charts/charts.py is not there (a program outside its source tree draws no "
        "charts; --out F.json writes the data)");
  }
  if (run_child({kPython, "-c",
                 "import importlib.util, sys; "
                 "sys.exit(importlib.util.find_spec('matplotlib') is None)"}) != 0) {
    throw Error(ErrorCode::kDrawing, "--out",
                "python3-matplotlib is not installed (--out F.json writes the data)");
  }
}

void draw_chart(const std::string& name, const nlohmann::ordered_json& data,
                const std::string& out) {
  // The script knows the format by the ending.
  const fs::path whole(out);
  fs::path picture = whole;
  picture.replace_filename(fmt::format("{}.partial-{}{}", whole.stem().string(), ::getpid(),
                                       whole.extension().string()));
  const std::string json = picture.string() + ".json";
  const RemovedOnInterrupt data_removed(json);
  write_text(json, data.dump() + "\n");
  const RemovedOnInterrupt picture_removed(picture.string());
  const int status = run_child({kPython, script().string(), "draw", name, json, picture.string()});
  fs::remove(json);
  std::error_code error;
  if (status == 0) {
    const InterruptsHeld held;
    fs::rename(picture, whole, error);
    if (!error && !is_removed_on_interrupt(out)) outputs_stay_on_interrupt();
  }
  if (status != 0 || error) fs::remove(picture, error);
  if (status != 0) {
    throw Error(ErrorCode::kDrawing, out,
                status == 3 ? "there is nothing to draw: the scene shows no pixels"
                            : fmt::format("charts.py ended with status {}", status));
  }
}

}  // namespace halfspace
