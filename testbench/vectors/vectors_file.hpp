// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vectors_format.hpp"

namespace halfspace {

// A finished file: written only when all of its fellows are ready.
struct NamedBytes {
  std::string name;  // without folder
  std::string bytes;
  bool executable = false;
};

// The format of a file by its extension (.hex, .csv, .jsonl, .hsv) or by name (readmemh, csv,
// jsonl, binary) when one is given. Throws Error(kVectorRequest).
VectorFormat vector_format(const std::string& path, const std::string& name);

// The files of one format, named after `stem`; several for readmemh: STEM.run.hex, STEM.in.hex,
// STEM.out.hex, STEM.ready.hex.
std::vector<NamedBytes> vector_files(const VectorSet& set, VectorFormat format,
                                     const std::string& name);

// The manifest: the header of the set and, of each file, its name, bytes and CRC-32.
NamedBytes vector_manifest(const VectorSet& set, const std::vector<NamedBytes>& files,
                           const std::string& name);

// Files by folder.
using FolderFiles = std::vector<std::pair<std::string, std::vector<NamedBytes>>>;

// Writes all of them and makes folders that are missing, or nothing when one cannot be written.
// Throws Error(kFileWrite).
void write_files(const FolderFiles& folders);

// Every set that a file holds or a manifest (.json) names, each with its place for messages. CRCs
// are compared. Throws Error(kFileRead), Error(kVectorsBroken), ...
struct PlacedVectors {
  std::string place;
  VectorSet set;
};
std::vector<PlacedVectors> read_vectors(const std::string& path);

}  // namespace halfspace
