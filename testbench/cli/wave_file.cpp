// SPDX-License-Identifier: Apache-2.0
#include "wave_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>

#include "io/error.hpp"

namespace halfspace {

// A block is a byte of its kind and eight of its length, those eight included, highest first.
void require_whole_waves(const std::string& file, const std::string& path) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code ignored;
  const std::uint64_t size = std::filesystem::file_size(file, ignored);
  std::uint64_t at = 0;
  while (at < size && stream) {
    std::array<char, 9> head{};
    stream.seekg(static_cast<std::streamoff>(at));
    if (!stream.read(head.data(), head.size())) break;
    std::uint64_t length = 0;
    for (std::size_t i = 1; i < head.size(); ++i) {
      length = length << 8 | static_cast<unsigned char>(head[i]);
    }
    if (length < 8 || length > size - at - 1) break;
    at += 1 + length;
  }
  if (at == size) return;
  throw Error(ErrorCode::kFileWrite, path, "cannot write: the waves are cut (is the disk full?)");
}

void write_save_file(const std::string& fst, const Config& config, std::uint64_t first_clock) {
  OutputFile file(std::filesystem::path(fst).replace_extension(".gtkw").string());
  file.write(fmt::format("[dumpfile] \"{}\"\n[timestart] {}\n",
                         std::filesystem::path(fst).filename().string(), 2 * first_clock));
  for (const char* name : {"clk_i", "rst_ni", "valid_i", "ready_o", "setup_valid", "setup_ready"}) {
    file.write(fmt::format("rasterizer.hs_rasterizer.{}\n", name));
  }
  file.write(
      fmt::format("rasterizer.hs_rasterizer.link_valid[{0}:0]\n"
                  "rasterizer.hs_rasterizer.link_ready[{0}:0]\n",
                  config.levels() - 1));
  for (const char* name : {"valid_o", "ready_i", "busy_o"}) {
    file.write(fmt::format("rasterizer.hs_rasterizer.{}\n", name));
  }
  file.commit();
}

}  // namespace halfspace
