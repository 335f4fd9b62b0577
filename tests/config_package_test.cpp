// SPDX-License-Identifier: Apache-2.0
#include "io/config_package.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "io/output_file.hpp"
#include "rtl/rtl_configs.hpp"

namespace halfspace {
namespace {

// The macros that a package defines.
std::map<std::string, std::string> macros(const std::string& package) {
  std::map<std::string, std::string> found;
  std::istringstream lines(package);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string define, name, value;
    if (words >> define >> name >> value && define == "`define") found[name] = value;
  }
  return found;
}

void expect_committed(const std::string& folder, const char* name, const Config& config) {
  const std::string path =
      std::string(HALFSPACE_TEST_DIR) + "/../" + folder + "/" + name + "/hs_config_pkg.sv";
  const auto expected = macros(config_package(config, ""));
  EXPECT_EQ(macros(read_file(path)), expected) << name;
  EXPECT_EQ(expected.size(), 8u);
}

TEST(ConfigPackage, CommittedPackagesAreThoseOfTheConfigs) {
  for (const Preset& preset : kPresets) {
    expect_committed("rtl/config", std::string(preset.name).c_str(), preset.config);
  }
  const std::string folder = "testbench/rtl/config";
  expect_committed(folder, "interval3", kTestInterval3);
  expect_committed(folder, "samples16", kTestSamples16);
  expect_committed(folder, "one_level", kTestOneLevel);
  expect_committed(folder, "fitted", kTestFitted);
  expect_committed(folder, "fitted_band", kTestFittedBand);
}

}  // namespace
}  // namespace halfspace
