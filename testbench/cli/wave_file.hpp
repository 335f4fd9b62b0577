// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "io/output_file.hpp"

namespace halfspace {

// Verilator's waves as an OutputFile, with the second file, .hier, that it writes while they are
// open. Destroyed or interrupted, it leaves neither.
class WaveFile {
 public:
  explicit WaveFile(const std::string& path)
      : file_(path), hier_(file_.temporary() + ".hier"), hier_removed_(hier_) {}
  ~WaveFile() {
    std::error_code ignored;
    std::filesystem::remove(hier_, ignored);
  }
  WaveFile(const WaveFile&) = delete;
  WaveFile& operator=(const WaveFile&) = delete;

  const std::string& temporary() const { return file_.temporary(); }

  // After the waves were closed. Without waves, nothing is there. Throws Error(kFileWrite).
  void commit() {
    std::error_code ignored;
    if (std::filesystem::file_size(temporary(), ignored) > 0) file_.commit();
  }

 private:
  OutputFile file_;
  std::string hier_;
  RemovedOnInterrupt hier_removed_;
};

}  // namespace halfspace
