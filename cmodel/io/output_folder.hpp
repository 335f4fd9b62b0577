// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "interrupt.hpp"

namespace halfspace {

// A folder that is whole or as it was: its files are written into one beside it under a temporary
// name and put in place by commit(). Destroyed without commit(), or interrupted, it leaves nothing
// behind, nor the folders made above it. Every failure throws Error(kFileWrite).
class OutputFolder {
 public:
  // path: of the folder; one that is there keeps the files that are not written anew.
  explicit OutputFolder(const std::string& path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Where to write the file of that name, each one once.
  std::string file(const std::string& name);
  // Files move in the order of file(), those that were not written excepted.
  void commit();

 private:
  void make(const std::filesystem::path& folder);
  void discard();

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::vector<std::filesystem::path> made_;  // folders, outermost first, the temporary one last
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<RemovedOnInterrupt>> removed_;
};

}  // namespace halfspace
