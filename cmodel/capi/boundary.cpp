// SPDX-License-Identifier: Apache-2.0
#include "boundary.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "../io/printable.hpp"

namespace halfspace::capi {
namespace {

// A fixed buffer: telling of a lack of memory must not need any.
using Message = std::array<char, 512>;

Message& last_message() noexcept {
  thread_local Message message{};
  return message;
}

hs_status status_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kConfigRead:
    case ErrorCode::kConfigKey:
    case ErrorCode::kConfigRange: return HS_ERROR_CONFIG;
    case ErrorCode::kSize:
    case ErrorCode::kFitRange:
    case ErrorCode::kTcovRange: return HS_ERROR_RANGE;
    case ErrorCode::kInternal: return HS_ERROR_INTERNAL;
    default: return HS_ERROR_FILE;
  }
}

}  // namespace

hs_status failed(hs_status status, const char* text) noexcept {
  Message& message = last_message();
  std::size_t size = 0;
  try {
    const std::string line = printable(first_line(text));
    size = std::min(line.size(), message.size() - 1);
    std::memcpy(message.data(), line.data(), size);
  } catch (...) {  // no memory for a line: the constant text of a status is short
    const std::string_view known = hs_status_text(status);
    size = known.copy(message.data(), message.size() - 1);
  }
  message[size] = '\0';
  return status;
}

hs_status failed(const Error& error) noexcept {
  Message text{};
  std::snprintf(text.data(), text.size(), "HS%03d: ", static_cast<int>(error.code()));
  try {
    return failed(status_of(error.code()), (text.data() + std::string(error.what())).c_str());
  } catch (...) {
    return failed(status_of(error.code()), text.data());
  }
}

}  // namespace halfspace::capi

using namespace halfspace::capi;

uint32_t hs_api_version(void) { return HALFSPACE_API_VERSION; }

const char* hs_version(void) { return HALFSPACE_VERSION; }

const char* hs_status_text(hs_status status) {
  switch (status) {
    case HS_OK: return "done";
    case HS_EMPTY: return "nothing waits";
    case HS_ERROR_ARGUMENT: return "a pointer, struct size or array size is wrong";
    case HS_ERROR_CONFIG: return "the configuration is not legal";
    case HS_ERROR_RANGE: return "a value is out of range";
    case HS_ERROR_ORDER: return "the call does not fit the state of the model";
    case HS_ERROR_FILE: return "a file cannot be read or is broken";
    case HS_ERROR_UNSUPPORTED: return "not in this build";
    case HS_ERROR_MEMORY: return "not enough memory";
    case HS_ERROR_INTERNAL: return "a bug in Halfspace";
  }
  return "no such status";
}

const char* hs_last_error(void) { return last_message().data(); }
