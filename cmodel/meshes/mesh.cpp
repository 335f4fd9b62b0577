// SPDX-License-Identifier: Apache-2.0
#include "mesh.hpp"

#include <cctype>
#include <exception>
#include <filesystem>
#include <new>
#include <utility>

#include "../io/error.hpp"
#include "../io/output_file.hpp"
#include "raw_mesh.hpp"

namespace halfspace {
namespace {

RawMesh read_format(const MeshSource& source, MeshFormat format) {
  switch (format) {
    case MeshFormat::kObj: return read_obj(source);
    case MeshFormat::kPly: return read_ply(source);
    case MeshFormat::kStl: return read_stl(source);
    default: return read_gltf(source, format == MeshFormat::kGlb);
  }
}

}  // namespace

MeshFormat mesh_format(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".gltf") return MeshFormat::kGltf;
  if (extension == ".glb") return MeshFormat::kGlb;
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".stl") return MeshFormat::kStl;
  throw Error(ErrorCode::kMeshBroken, path,
              "is not a mesh format that is read here: .obj .gltf .glb .ply .stl");
}

Mesh load_mesh(const std::string& path, const MeshProgress& progress) {
  std::string bytes = read_file(path);
  return parse_mesh(path, mesh_format(path), std::move(bytes), progress);
}

Mesh parse_mesh(const std::string& path, MeshFormat format, std::string bytes,
                const MeshProgress& progress) {
  try {
    LeftOut left_out;
    RawMesh raw = read_format({path, bytes, progress, left_out}, format);
    std::string().swap(bytes);  // what follows needs memory too
    Mesh mesh = finish_mesh(path, std::move(raw), progress);
    mesh.left_out = std::move(left_out);
    return mesh;
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {  // not the file's fault
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorCode::kMeshBroken, path, error.what());
  }
}

}  // namespace halfspace
