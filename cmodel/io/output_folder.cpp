// SPDX-License-Identifier: Apache-2.0
#include "output_folder.hpp"

#include <unistd.h>

#include <system_error>

#include "error.hpp"
#include "input_files.hpp"
#include "output_file.hpp"

namespace halfspace {

namespace fs = std::filesystem;

MadeFolders::MadeFolders(const std::string& path, const std::string& shown) {
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path folder = path; !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path()) {
    if (folder.has_filename()) missing.push_back(folder);
  }
  for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) {
    const InterruptsHeld held;  // until it is known what to remove
    const bool made = fs::create_directory(*folder, error);
    if (error) throw Error(ErrorCode::kFileWrite, shown, "cannot create the folder");
    if (!made) continue;  // another program did
    made_.push_back(*folder);
    removed_.push_back(std::make_unique<RemovedOnInterrupt>(folder->string()));
  }
}

MadeFolders::~MadeFolders() {
  std::error_code ignored;
  for (; !made_.empty(); made_.pop_back()) fs::remove(made_.back(), ignored);
  while (!removed_.empty()) removed_.pop_back();  // newest first, as they are registered
}

OutputFolder::OutputFolder(const std::string& path) : path_(fs::path(path).lexically_normal()) {
  if (!path_.has_filename()) path_ = path_.parent_path();
  std::error_code ignored;
  if (path.empty() || (fs::exists(path_, ignored) && !fs::is_directory(path_, ignored))) {
    throw Error(ErrorCode::kFileWrite, path, "cannot create the folder");
  }
  if (fs::exists(path_, ignored) && ::access(path_.c_str(), W_OK | X_OK) != 0) {
    throw Error(ErrorCode::kFileWrite, path, "cannot write into the folder");
  }
  // "." is a folder that has no name to be written beside.
  const bool nameless = path_.filename() == "." || path_.filename() == ".." || path_ == "/";
  temporary_ = nameless ? path_ / "partial" : path_;
  temporary_ += ".partial-" + std::to_string(::getpid());
  above_.emplace(temporary_.string(), path);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(temporary_, ignored);
  while (!removed_.empty()) removed_.pop_back();  // newest first, as they are registered
}

std::string OutputFolder::file(const std::string& name) {
  names_.push_back(name);
  std::string path = (temporary_ / name).string();
  removed_.push_back(std::make_unique<RemovedOnInterrupt>(path));
  return path;
}

void OutputFolder::commit() {
  std::error_code error;
  for (const std::string& name : names_) {
    if (is_input((path_ / name).string())) {
      throw Error(ErrorCode::kUsage, (path_ / name).string(), "is an input: it would be replaced");
    }
  }
  flush_standard_output();
  const InterruptsHeld held;  // all or none
  if (!fs::exists(path_)) {
    fs::rename(temporary_, path_, error);
  } else {
    for (const std::string& name : names_) {
      if (fs::is_directory(path_ / name, error)) {  // before anything is moved
        throw Error(ErrorCode::kFileWrite, (path_ / name).string(),
                    "cannot write: it is a directory");
      }
    }
    error.clear();
    for (const std::string& name : names_) {
      if (!error && fs::exists(temporary_ / name))
        fs::rename(temporary_ / name, path_ / name, error);
    }
    if (!error) fs::remove(temporary_, error);
  }
  if (error) {
    throw Error(ErrorCode::kFileWrite, path_.string(),
                "cannot move the finished files into place: " + error.message());
  }
  outputs_stay_on_interrupt();
  committed_ = true;
  above_->keep();
}

}  // namespace halfspace
