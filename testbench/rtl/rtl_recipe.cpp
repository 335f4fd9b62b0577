// SPDX-License-Identifier: Apache-2.0
#include "rtl_recipe.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "io/config_package.hpp"
#include "io/error.hpp"
#include "io/fnv.hpp"
#include "io/output_file.hpp"
#include "io/source_tree.hpp"

namespace halfspace {

namespace fs = std::filesystem;

namespace {

void add_list(const fs::path& rtl, const std::string& folder, const std::string& list,
              RtlRecipe& recipe) {
  std::istringstream lines(read_file((rtl / folder / list).string()));
  for (std::string name; std::getline(lines, name);) {
    if (name.empty()) continue;
    const std::string path = (fs::path(folder) / name).string();
    recipe.files["rtl/" + path] = read_file((rtl / path).string());
    recipe.sources += " rtl/" + path;
  }
}

}  // namespace

const char* const kVerilateCommand =
    "verilator --cc --assert -O3 --x-assign unique --x-initial unique -Wno-fatal "
    "--top-module hs_rasterizer --prefix Vrtl --Mdir .";

// In the folder of the build, after Verilator: one file of what runs every clock, one of what runs
// once, one of Verilator's own. $1 the compiler and its flags, $2 libraries.
const char* const kCompileCommands = R"SH(
for file in Vrtl*.cpp; do
  case $file in
    *Slow.cpp | *__Syms*.cpp) echo "#include \"$file\"" >> slow.cc ;;
    *) echo "#include \"$file\"" >> fast.cc ;;
  esac
done
echo '#include "rtl_object.cpp"' >> fast.cc
$1 -O2 -c fast.cc -o fast.o & fast=$!
{ $1 -O0 -c slow.cc -o slow.o && $1 -O1 -c runtime.cc -o runtime.o; } || { kill $fast; exit 1; }
wait $fast
$1 -shared fast.o slow.o runtime.o -o object.so $2
)SH";

std::string first_line_of(const std::string& command) {
  std::FILE* pipe = ::popen(("{ " + command + "; } 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return {};
  std::string text;
  std::array<char, 256> some{};
  while (std::fgets(some.data(), some.size(), pipe) != nullptr) text += some.data();
  return ::pclose(pipe) == 0 ? text.substr(0, text.find('\n')) : std::string();
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

std::string RtlTools::missing() const {
  if (verilator.empty()) return "Verilator is not installed (package verilator)";
  if (compiler.empty()) {
    return fmt::format("the C++ compiler {} is not installed (package g++)", command);
  }
  return {};
}

const RtlTools& rtl_tools() {
  static const RtlTools found = [] {
    RtlTools tools;
    tools.verilator = first_line_of("verilator_bin --version || verilator --version");
    tools.command = variable("CXX").empty() ? "c++" : variable("CXX");
    tools.compiler = first_line_of(tools.command + " --version");
    return tools;
  }();
  return found;
}

RtlRecipe rtl_recipe(const Config& config, const std::string& place) {
  const fs::path tree = folder_with("testbench/rtl/rtl_object.cpp");
  const fs::path rtl =
      variable("HALFSPACE_RTL").empty() ? tree / "rtl" : fs::path(variable("HALFSPACE_RTL"));
  if (tree.empty() || !fs::exists(rtl / "rtl.f")) {
    throw Error(
        ErrorCode::kLevel, place,
        fmt::format("no RTL to build: {} is not there",
                    tree.empty() ? "rtl/rtl.f around the program" : (rtl / "rtl.f").string()));
  }
  RtlRecipe recipe;
  for (const char* name : {"rtl_object.cpp", "rtl_object.h", "ports.hpp"}) {
    recipe.files[name] = read_file((tree / "testbench/rtl" / name).string());
  }
  recipe.files["rtl/hs_lint.vlt"] = read_file((rtl / "hs_lint.vlt").string());
  recipe.files["hs_config_pkg.sv"] =
      config_package(config, "a Config; they are compared on loading");
  recipe.sources = " rtl/hs_lint.vlt hs_config_pkg.sv";
  add_list(rtl, "", "rtl.f", recipe);
  add_list(rtl, "checkers", "checkers.f", recipe);
  return recipe;
}

std::uint64_t hash_of(const RtlRecipe& recipe, const RtlTools& tools) {
  Fnv hash;
  for (const auto& [name, text] : recipe.files) hash.add(name), hash.add(text);
  for (const std::string& text : {recipe.sources, tools.verilator, tools.compiler, tools.command,
                                  std::string(kVerilateCommand), std::string(kCompileCommands)}) {
    hash.add(text);
  }
  return hash.value();
}

}  // namespace halfspace
