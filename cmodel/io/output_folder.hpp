// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interrupt.hpp"

namespace halfspace {

// Folders that were missing, made: those of a path, outermost first. Gone again, as far as they are
// empty, with this object or on an interrupt, unless kept. Throws Error(kFileWrite).
class MadeFolders {
 public:
  // shown: the name in an error.
  MadeFolders(const std::string& path, const std::string& shown);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;
  std::vector<std::unique_ptr<RemovedOnInterrupt>> removed_;
};

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
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::optional<MadeFolders> above_;  // and the temporary one, the last
  bool committed_ = false;
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<RemovedOnInterrupt>> removed_;
};

}  // namespace halfspace
