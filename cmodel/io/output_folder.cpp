// SPDX-License-Identifier: Apache-2.0
#include "output_folder.hpp"

#include <unistd.h>

#include <system_error>

#include "error.hpp"
#include "output_file.hpp"

namespace halfspace {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& path) : path_(fs::path(path).lexically_normal()) {
  if (!path_.has_filename()) path_ = path_.parent_path();
  std::error_code ignored;
  if (path.empty() || (fs::exists(path_, ignored) && !fs::is_directory(path_, ignored))) {
    throw Error(ErrorCode::kFileWrite, path, "cannot create the folder");
  }
  if (fs::exists(path_, ignored) && ::access(path_.c_str(), W_OK | X_OK) != 0) {
    throw Error(ErrorCode::kFileWrite, path, "cannot write into the folder");
  }
  std::vector<fs::path> missing;
  for (fs::path above = path_.parent_path(); !above.empty() && !fs::exists(above, ignored);
       above = above.parent_path()) {
    missing.push_back(above);
  }
  // "." is a folder that has no name to be written beside.
  const bool nameless = path_.filename() == "." || path_.filename() == ".." || path_ == "/";
  temporary_ = nameless ? path_ / "partial" : path_;
  temporary_ += ".partial-" + std::to_string(::getpid());
  missing.insert(missing.begin(), temporary_);
  for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) make(*folder);
}

OutputFolder::~OutputFolder() { discard(); }

void OutputFolder::discard() {
  std::error_code ignored;
  if (!made_.empty()) fs::remove_all(made_.back(), ignored);
  while (!made_.empty()) {
    fs::remove(made_.back(), ignored);
    made_.pop_back();
  }
  // Newest first, as they are registered.
  while (!removed_.empty()) removed_.pop_back();
}

void OutputFolder::make(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (error) {
    discard();
    throw Error(ErrorCode::kFileWrite, path_.string(), "cannot create the folder");
  }
  made_.push_back(folder);
  removed_.push_back(std::make_unique<RemovedOnInterrupt>(folder.string()));
}

std::string OutputFolder::file(const std::string& name) {
  names_.push_back(name);
  std::string path = (temporary_ / name).string();
  removed_.push_back(std::make_unique<RemovedOnInterrupt>(path));
  return path;
}

void OutputFolder::commit() {
  std::error_code error;
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
  made_.clear();
}

}  // namespace halfspace
