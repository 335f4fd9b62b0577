// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "../io/error.hpp"
#include "../io/interrupt.hpp"

namespace halfspace {

// Verilator's waves, written beside their destination and put in place by commit(). It writes a
// second file, .hier, while they are open. Destroyed or interrupted, it leaves neither.
class WaveFile {
 public:
  explicit WaveFile(const std::string& path)
      : path_(path),
        temporary_(path + ".partial-" + std::to_string(::getpid())),
        removed_(temporary_),
        hier_removed_(temporary_ + ".hier") {}
  ~WaveFile() {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    std::filesystem::remove(temporary_ + ".hier", ignored);
  }
  WaveFile(const WaveFile&) = delete;
  WaveFile& operator=(const WaveFile&) = delete;

  const std::string& temporary() const { return temporary_; }

  // After the waves were closed. Without waves, nothing is there. Throws Error(kFileWrite).
  void commit() {
    std::error_code error;
    if (std::filesystem::exists(temporary_)) std::filesystem::rename(temporary_, path_, error);
    if (error) throw Error(ErrorCode::kFileWrite, path_, "cannot write: " + error.message());
  }

 private:
  std::string path_, temporary_;
  RemovedOnInterrupt removed_, hier_removed_;
};

}  // namespace halfspace
