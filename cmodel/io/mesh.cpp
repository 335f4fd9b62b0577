// SPDX-License-Identifier: Apache-2.0
#include "mesh.hpp"

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <exception>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string_view>

#include "error.hpp"
#include "mesh_checks.hpp"
#include "obj_check.hpp"
#include "output_file.hpp"

namespace halfspace {
namespace {

constexpr float kCreaseDegrees = 66.0F;

// Gives the library the bytes that were checked in place of the file; files beside it (materials,
// buffers) are opened as usual.
class CheckedFile : public Assimp::DefaultIOSystem {
 public:
  CheckedFile(std::string path, const std::string& bytes) : path_(std::move(path)), bytes_(bytes) {}

  bool Exists(const char* path) const override {
    return path_ == path || Assimp::DefaultIOSystem::Exists(path);
  }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (path_ != path) {
      // Never a device or a pipe, which might not end.
      std::error_code ignored;
      if (!std::filesystem::is_regular_file(path, ignored)) return nullptr;
      return Assimp::DefaultIOSystem::Open(path, mode);
    }
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes_.data()),
                                      bytes_.size());
  }

 private:
  std::string path_;
  const std::string& bytes_;
};

// What the checks of a format leave for the library, and what they found.
struct Checked {
  std::string bytes;
  std::size_t faces = 0;  // that the library must find; 0 where that is not known
  bool is_stl = false;
  bool shares_vertices = false;  // as a format, by index: the library need not look for equal ones
};

Checked check_format(const std::string& path, std::string bytes) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".obj") {
    PlainObj obj = check_obj(path, bytes);
    if (obj.faces == 0) throw Error(ErrorCode::kMeshEmpty, path, "has no triangles");
    return {std::move(obj.text), obj.faces};
  }
  if (extension == ".gltf" || extension == ".glb") {
    PlainGltf gltf = plain_gltf(path, bytes, extension == ".glb");
    return {std::move(gltf.bytes), gltf.faces, false, true};
  }
  if (extension == ".ply") {
    const std::size_t faces = check_ply(path, bytes);
    return {std::move(bytes), faces, false, true};
  }
  if (extension == ".stl") {
    const std::size_t faces = check_stl(path, bytes);
    return {std::move(bytes), faces, true};
  }
  throw Error(ErrorCode::kMeshBroken, path,
              "is not a mesh format that is read here: .obj .gltf .glb .ply .stl");
}

glm::vec3 to_vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Before post-processing, which sorts positions and follows indices.
void check_part(const std::string& path, const aiMesh& part) {
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    if (!is_finite(to_vec3(part.mVertices[i])) ||
        (part.HasNormals() && !is_finite(to_vec3(part.mNormals[i])))) {
      throw Error(ErrorCode::kMeshNotFinite, path,
                  "vertex " + std::to_string(i) + " (counted from 0) is not finite");
    }
  }
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (std::any_of(face.mIndices, face.mIndices + face.mNumIndices,
                    [&part](unsigned index) { return index >= part.mNumVertices; })) {
      throw Error(
          ErrorCode::kMeshIndex, path,
          "face " + std::to_string(f) + " (counted from 0) names a vertex that is not there");
    }
  }
}

void check_scene(const std::string& path, const aiScene& scene, std::size_t faces) {
  std::size_t found = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    check_part(path, *scene.mMeshes[m]);
    found += scene.mMeshes[m]->mNumFaces;
  }
  if (faces != 0 && found != faces) {
    throw Error(ErrorCode::kMeshIndex, path,
                "has " + std::to_string(faces) + " faces, but only " + std::to_string(found) +
                    " of them name vertices that are there");
  }
}

glm::vec3 material_color(const aiScene& scene, unsigned index) {
  if (index >= scene.mNumMaterials) return glm::vec3(1.0F);
  const aiMaterial& material = *scene.mMaterials[index];
  aiString name;
  aiColor4D color;
  // The material that the library makes up for files without one is a mid grey.
  const bool made_up = material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS &&
                       std::string_view(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME;
  if (made_up || material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != AI_SUCCESS) {
    return glm::vec3(1.0F);
  }
  return {color.r, color.g, color.b};
}

// A colour of the file, which may be anything at all, in 0..1.
glm::vec3 to_unit(const glm::vec3& color) {
  return is_finite(color) ? glm::clamp(color, 0.0F, 1.0F) : glm::vec3(0.0F);
}

void append_vertices(const aiScene& scene, const aiMesh& part, Mesh& mesh) {
  const glm::vec3 plain = to_unit(material_color(scene, part.mMaterialIndex));
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    mesh.positions.push_back(to_vec3(part.mVertices[i]));
    const glm::vec3 normal = part.HasNormals() ? to_vec3(part.mNormals[i]) : glm::vec3(0.0F);
    const float length = glm::length(normal);
    const bool usable = std::isfinite(length) && length > 1e-12F;
    mesh.normals.push_back(usable ? normal / length : glm::vec3(0.0F));
    if (part.HasVertexColors(0)) {
      const aiColor4D& color = part.mColors[0][i];
      mesh.colors.push_back(to_unit({color.r, color.g, color.b}));
    } else {
      mesh.colors.push_back(plain);
    }
  }
}

void append_part(const std::string& path, const aiScene& scene, const aiMesh& part, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  if (mesh.positions.size() + part.mNumVertices > UINT32_MAX) {
    throw Error(ErrorCode::kMeshBroken, path, "has more than 2^32 - 1 vertices");
  }
  append_vertices(scene, part, mesh);
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;
    mesh.triangles.push_back(
        {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

// Formats that share vertices by index may have some that no triangle names. The others keep their
// order.
void drop_unused_vertices(Mesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) used[index] = true;
  }
  if (std::find(used.begin(), used.end(), false) == used.end()) return;
  std::vector<std::uint32_t> place(used.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    mesh.positions[kept] = mesh.positions[i];
    mesh.normals[kept] = mesh.normals[i];
    mesh.colors[kept] = mesh.colors[i];
    place[i] = kept++;
  }
  mesh.positions.resize(kept);
  mesh.normals.resize(kept);
  mesh.colors.resize(kept);
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& index : triangle) index = place[index];
  }
}

Mesh convert(const std::string& path, const aiScene& scene) {
  Mesh mesh;
  std::size_t vertices = 0, faces = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    vertices += scene.mMeshes[m]->mNumVertices;
    faces += scene.mMeshes[m]->mNumFaces;
  }
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  mesh.colors.reserve(vertices);
  mesh.triangles.reserve(faces);
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    append_part(path, scene, *scene.mMeshes[m], mesh);
  }
  if (mesh.triangles.empty()) throw Error(ErrorCode::kMeshEmpty, path, "has no triangles");
  // Finite before its node's transform does not mean finite after it.
  if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite)) {
    throw Error(ErrorCode::kMeshNotFinite, path, "a transformed vertex is not finite");
  }
  drop_unused_vertices(mesh);
  return mesh;
}

Mesh import(const std::string& path, Checked checked) {
  Assimp::Importer importer;
  importer.SetIOHandler(new CheckedFile(path, checked.bytes));  // the importer deletes it
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kCreaseDegrees);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const auto require = [&](const aiScene* scene) -> const aiScene& {
    if (scene != nullptr) return *scene;
    std::string text = importer.GetErrorString();
    const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
    std::replace_if(text.begin(), text.end(), ends_line, ' ');
    throw Error(ErrorCode::kMeshBroken, path, text.empty() ? "cannot be read" : text);
  };
  const aiScene& raw = require(importer.ReadFile(path, 0));
  check_scene(path, raw, checked.faces);
  checked.bytes = {};  // read; the steps that follow need memory too

  unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_PreTransformVertices |
                   aiProcess_GenSmoothNormals;
  // Joining takes 600 bytes a vertex.
  if (!checked.shares_vertices) steps |= aiProcess_JoinIdenticalVertices;
  // Many writers of STL leave the normals zero.
  if (checked.is_stl) steps |= aiProcess_ForceGenNormals;
  return convert(path, require(importer.ApplyPostProcessing(steps)));
}

}  // namespace

Mesh load_mesh(const std::string& path) {
  try {
    return import(path, check_format(path, read_file(path)));
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorCode::kMeshBroken, path, error.what());
  }
}

}  // namespace halfspace
