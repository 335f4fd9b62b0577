// SPDX-License-Identifier: Apache-2.0
#include "png_file.hpp"

#include <png.h>

#include <cstring>

#include "error.hpp"

namespace halfspace {

// libpng's simplified interface: it reports errors by return value, so nothing is jumped over.
void write_png(OutputFile& file, const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png.flags = PNG_IMAGE_FLAG_FAST;  // no filter, zlib level 3: else files take longer than frames
  if (png_image_write_to_stdio(&png, file.stream(), 0, image.pixel.data(), 0, nullptr) == 0) {
    throw Error(ErrorCode::kFileWrite, file.path(), std::string("cannot write: ") + png.message);
  }
}

void write_png(const std::string& path, const Image& image) {
  OutputFile file(path);
  write_png(file, image);
  file.commit();
}

Image read_png(const std::string& path) {
  const std::string bytes = read_file(path);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    throw Error(ErrorCode::kFileRead, path, std::string("not a PNG: ") + png.message);
  }
  png.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.pixel.resize(static_cast<std::size_t>(png.width) * png.height);
  if (png_image_finish_read(&png, nullptr, image.pixel.data(), 0, nullptr) == 0) {
    throw Error(ErrorCode::kFileRead, path, std::string("cannot read: ") + png.message);
  }
  return image;
}

}  // namespace halfspace
