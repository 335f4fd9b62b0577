// SPDX-License-Identifier: Apache-2.0
#include "vectors_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/output_folder.hpp"
#include "io/tcov.hpp"
#include "vectors_meta.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

std::string crc_text(const std::string& bytes) { return fmt::format("{:08x}", crc32_of(bytes)); }

[[noreturn]] void broken(const std::string& place, const std::string& text) {
  throw Error(ErrorCode::kVectorsBroken, place, text);
}

// The files that a manifest names, by name, read and compared with their CRCs.
std::map<std::string, std::string> manifest_files(const nlohmann::json& json,
                                                  const fs::path& path) {
  std::map<std::string, std::string> files;
  const auto listed = json.find("files");
  if (listed == json.end() || !listed->is_array()) broken(path.string(), "has no list 'files'");
  for (const nlohmann::json& entry : *listed) {
    const auto text = [&entry](const char* key) {
      return entry.is_object() && entry.contains(key) && entry[key].is_string()
                 ? entry[key].get<std::string>()
                 : std::string();
    };
    const std::string name = text("name");
    if (name.empty() || name.find('/') != std::string::npos) {
      broken(path.string(), "a file has no name, or one with a folder");
    }
    std::string bytes = read_file((path.parent_path() / name).string());
    if (crc_text(bytes) != text("crc32")) {
      broken((path.parent_path() / name).string(),
             fmt::format("CRC-32 {} is not the manifest's {:.16}", crc_text(bytes), text("crc32")));
    }
    files.emplace(name, std::move(bytes));
  }
  return files;
}

VectorSet parse_one(VectorFormat format, const std::string& bytes, const std::string& place) {
  switch (format) {
    case VectorFormat::kCsv: return vectors_from_csv(bytes, place);
    case VectorFormat::kJsonLines: return vectors_from_json_lines(bytes, place);
    default: return vectors_from_binary(bytes, place);
  }
}

std::vector<PlacedVectors> read_manifest(const std::string& path) {
  const std::string text = read_file(path);
  const nlohmann::json json = parse_vector_json(text, path);
  if (!json.is_object()) broken(path, "not a JSON object");
  const auto files = manifest_files(json, path);
  const fs::path folder = fs::path(path).parent_path();
  const VectorHeader header = parse_vector_meta(json, path);
  std::vector<PlacedVectors> sets;
  for (const auto& [name, bytes] : files) {
    const std::string place = (folder / name).string();
    const std::string extension = fs::path(name).extension().string();
    if (extension == ".hex") {
      if (!name.ends_with(".in.hex")) continue;
      const std::string stem = name.substr(0, name.size() - 7);
      HexFiles hex;
      for (auto [to, part] : {std::pair{&hex.run, "run"}, std::pair{&hex.in, "in"},
                              std::pair{&hex.out, "out"}, std::pair{&hex.ready, "ready"}}) {
        const auto found = files.find(fmt::format("{}.{}.hex", stem, part));
        if (found == files.end()) broken(path, fmt::format("{}.{}.hex is missing", stem, part));
        *to = found->second;
      }
      sets.push_back({place, vectors_from_hex(hex, text, place)});
    } else if (extension == ".csv" || extension == ".jsonl" || extension == ".hsv") {
      sets.push_back({place, parse_one(vector_format(name, ""), bytes, place)});
      if (!(sets.back().set.meta == header.meta)) broken(place, "its header is not the manifest's");
    }
  }
  if (sets.empty()) throw Error(ErrorCode::kVectorsEmpty, path, "names no vectors");
  return sets;
}

}  // namespace

VectorFormat vector_format(const std::string& path, const std::string& name) {
  const std::string word = name.empty() ? fs::path(path).extension().string() : name;
  if (word == ".hex" || word == "readmemh") return VectorFormat::kReadmemh;
  if (word == ".csv" || word == "csv") return VectorFormat::kCsv;
  if (word == ".jsonl" || word == "jsonl") return VectorFormat::kJsonLines;
  if (word == ".hsv" || word == "binary") return VectorFormat::kBinary;
  if (!name.empty()) {
    throw Error(ErrorCode::kVectorRequest, "--format",
                fmt::format("'{:.40}' is not readmemh, csv, jsonl or binary", name));
  }
  throw Error(ErrorCode::kVectorRequest, path,
              "the name does not end in .hex, .csv, .jsonl or .hsv");
}

std::vector<NamedBytes> vector_files(const VectorSet& set, VectorFormat format,
                                     const std::string& name) {
  switch (format) {
    case VectorFormat::kCsv: return {{name, vectors_to_csv(set)}};
    case VectorFormat::kJsonLines: return {{name, vectors_to_json_lines(set)}};
    case VectorFormat::kBinary: return {{name, vectors_to_binary(set)}};
    case VectorFormat::kReadmemh: break;
  }
  const std::string stem = name.ends_with(".hex") ? name.substr(0, name.size() - 4) : name;
  HexFiles hex = vectors_to_hex(set);
  return {{stem + ".run.hex", std::move(hex.run)},
          {stem + ".in.hex", std::move(hex.in)},
          {stem + ".out.hex", std::move(hex.out)},
          {stem + ".ready.hex", std::move(hex.ready)}};
}

NamedBytes vector_manifest(const VectorSet& set, const std::vector<NamedBytes>& files,
                           const std::string& name) {
  nlohmann::ordered_json json = vector_meta_json(set);
  json["files"] = nlohmann::ordered_json::array();
  for (const NamedBytes& file : files) {
    json["files"].push_back(
        {{"name", file.name}, {"bytes", file.bytes.size()}, {"crc32", crc_text(file.bytes)}});
  }
  return {name, json.dump(1) + "\n"};
}

void write_files(const FolderFiles& folders) {
  std::vector<std::unique_ptr<MadeFolders>> made;
  OutputGroup outputs;  // its unfinished files go before their folders
  for (const auto& [folder, files] : folders) {
    made.push_back(std::make_unique<MadeFolders>(folder, folder));
    for (const NamedBytes& file : files) {
      outputs.open((fs::path(folder) / file.name).string()).write(file.bytes);
    }
  }
  outputs.commit();
  for (const auto& folder : made) folder->keep();
  for (const auto& [folder, files] : folders) {
    for (const NamedBytes& file : files) {
      if (!file.executable) continue;
      std::error_code ignored;  // a file system without permissions
      fs::permissions(fs::path(folder) / file.name, fs::perms::owner_exec | fs::perms::group_exec,
                      fs::perm_options::add, ignored);
    }
  }
}

std::vector<PlacedVectors> read_vectors(const std::string& path) {
  if (fs::path(path).extension() == ".json") return read_manifest(path);
  const std::string bytes = read_file(path);  // a file that is not there is said before its name
  const VectorFormat format = vector_format(path, "");
  if (format == VectorFormat::kReadmemh) {
    throw Error(ErrorCode::kVectorRequest, path, "hex files are read by their manifest (.json)");
  }
  std::vector<PlacedVectors> sets;
  sets.push_back({path, parse_one(format, bytes, path)});
  return sets;
}

}  // namespace halfspace
