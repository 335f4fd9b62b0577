// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

#include "config.hpp"
#include "io/output_file.hpp"

namespace halfspace {

// Throws Error(kFileWrite) when an FST file's blocks do not end where the file does: the disk was
// full, or a limit reached. path: for the message. An empty file has no waves, and is whole.
void require_whole_waves(const std::string& file, const std::string& path);

// Beside the waves, a file with which GTKWave opens them with the handshakes already shown, from
// that clock on.
void write_save_file(const std::string& fst, const Config& config, std::uint64_t first_clock);

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

  // After the waves were closed, which the simulator does not check: all of them are there. Throws
  // Error(kFileWrite).
  void finish() { require_whole_waves(temporary(), file_.path()); }
  // After finish(). Without waves, nothing is there.
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
