// SPDX-License-Identifier: Apache-2.0
//
// Where C meets C++: no exception passes, every refusal leaves its text behind.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>

#include "../io/error.hpp"
#include "halfspace.h"

namespace halfspace::capi {

// Bad input, found by the C interface itself.
class Refusal : public std::runtime_error {
 public:
  Refusal(hs_status status, const std::string& text) : std::runtime_error(text), status_(status) {}
  hs_status status() const { return status_; }

 private:
  hs_status status_;
};

// Remembers text, cut to its first line, for this thread's hs_last_error(); returns status.
hs_status failed(hs_status status, const char* text) noexcept;
hs_status failed(const Error& error) noexcept;

// Runs body() and turns what it throws into a status. body returns an hs_status.
template <class Body>
hs_status call(Body&& body) noexcept {
  try {
    return body();
  } catch (const Refusal& refusal) {
    return failed(refusal.status(), refusal.what());
  } catch (const Error& error) {
    return failed(error);
  } catch (const std::bad_alloc&) {
    return failed(HS_ERROR_MEMORY, "not enough memory");
  } catch (const std::length_error&) {
    return failed(HS_ERROR_MEMORY, "not enough memory");
  } catch (const std::exception& error) {
    return failed(HS_ERROR_INTERNAL, error.what());
  } catch (...) {
    return failed(HS_ERROR_INTERNAL, "an exception that is no std::exception");
  }
}

inline void require(bool condition, hs_status status, const char* text) {
  if (!condition) throw Refusal(status, text);
}
inline void require_pointer(const void* pointer, const char* name) {
  if (pointer == nullptr) throw Refusal(HS_ERROR_ARGUMENT, std::string(name) + " is null");
}

// A struct from the caller, who may know fewer or more fields than this library. Fields beyond ours
// must be 0: they would ask for something this library does not do.
template <class Struct>
Struct read_struct(const Struct* from, std::size_t first_version, const char* name) {
  require_pointer(from, name);
  Struct out{};
  const std::size_t size = from->struct_size;
  if (size < first_version || size > 4096) {
    throw Refusal(HS_ERROR_ARGUMENT, std::string(name) + "->struct_size = " + std::to_string(size) +
                                         ", not " + std::to_string(sizeof out));
  }
  const char* bytes = reinterpret_cast<const char*>(from);
  for (std::size_t i = sizeof out; i < size; ++i) {
    if (bytes[i] != 0) {
      throw Refusal(HS_ERROR_ARGUMENT, std::string(name) + " has a field set that is unknown here");
    }
  }
  std::memcpy(&out, from, size < sizeof out ? size : sizeof out);
  return out;
}

// A struct for the caller: as many bytes as he has room for, 0 beyond those known here.
template <class Struct>
void write_struct(Struct value, std::size_t first_version, Struct* to, const char* name) {
  require_pointer(to, name);
  const std::size_t size = to->struct_size;
  if (size < first_version || size > 4096) {
    throw Refusal(HS_ERROR_ARGUMENT, std::string(name) + "->struct_size = " + std::to_string(size) +
                                         ", not " + std::to_string(sizeof value));
  }
  value.struct_size = size;
  char* bytes = reinterpret_cast<char*>(to);
  std::memset(bytes, 0, size);
  std::memcpy(bytes, &value, size < sizeof value ? size : sizeof value);
}

}  // namespace halfspace::capi
