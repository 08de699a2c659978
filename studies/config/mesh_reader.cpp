#include "studies/config/mesh_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef UNBRUISED_HAS_ASSIMP
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

#include "studies/process/child_work.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

using Result = ValueOr<TriangleMesh, std::string>;

#ifdef UNBRUISED_HAS_ASSIMP

/// Text of 1 MB takes a tenth of a second and some 20 MB; broken files are known over which the reader goes round
/// for ever.
ChildLimits limits_for(std::size_t bytes) {
  return {.seconds_most = 2 + static_cast<unsigned>(bytes >> 20),
          .bytes_more = (std::size_t{1} << 30) + 32 * bytes};
}
/// Far more than is taken, so that whoever has too many hears how many they are.
constexpr std::size_t kMostRead = 5'000'000;

/// A file may name others, as those of materials; none is opened.
class NoOtherFiles final : public Assimp::IOSystem {
 public:
  [[nodiscard]] bool Exists(const char*) const override { return false; }
  [[nodiscard]] char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

TriangleMesh triangles_of(const aiScene& scene) {
  TriangleMesh mesh;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    const auto first = static_cast<int>(mesh.place.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const aiVector3D& place = part.mVertices[v];
      mesh.place.push_back(
          {static_cast<double>(place.x), static_cast<double>(place.y), static_cast<double>(place.z)});
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      std::array<int, 3> corner{};
      for (unsigned k = 0; k < 3; ++k) corner[k] = first + static_cast<int>(face.mIndices[k]);
      mesh.triangle.push_back(corner);
    }
  }
  return mesh;
}

template <class T>
void put(const std::vector<T>& values, std::string& bytes) {
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
}

template <class T>
bool take(std::string_view& bytes, std::vector<T>& values) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (count > bytes.size() / sizeof(T)) return false;
  values.resize(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return true;
}

/// In the child: a complaint behind 'x', or the triangles behind 'm'.
std::string read_here(std::string_view content, const std::string& ending) {
  Assimp::Importer importer;
  importer.SetIOHandler(new NoOtherFiles);  // the importer owns it
  const aiScene* scene =
      importer.ReadFileFromMemory(content.data(), content.size(), aiProcess_Triangulate, ending.c_str());
  if (scene == nullptr) return joined({"x", importer.GetErrorString()});
  const TriangleMesh mesh = triangles_of(*scene);
  if (mesh.triangle.size() > kMostRead) {
    return joined({"xit has ", std::to_string(mesh.triangle.size()), " triangles, more than anybody needs"});
  }
  std::string bytes = "m";
  put(mesh.place, bytes);
  put(mesh.triangle, bytes);
  return bytes;
}

bool is_sound(const TriangleMesh& mesh) {
  const auto is_finite = [](const std::array<double, 3>& place) {
    return std::ranges::all_of(place, [](double x) { return std::isfinite(x); });
  };
  const auto has = [&](int corner) { return corner >= 0 && static_cast<std::size_t>(corner) < mesh.place.size(); };
  return std::ranges::all_of(mesh.place, is_finite) &&
         std::ranges::all_of(mesh.triangle,
                             [&](const std::array<int, 3>& corner) { return std::ranges::all_of(corner, has); });
}

/// One line without what only a programmer would say.
std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  constexpr std::size_t kLongest = 200;
  if (text.size() > kLongest) text.resize(kLongest);
  return text.empty() ? "nobody knows why" : text;
}

Result read_lower_case(std::string_view content, const std::string& ending) {
  const ChildEnd end = work_in_child([&] { return read_here(content, ending); }, limits_for(content.size()));
  if (end.no_child != 0)
    return joined({"cannot be read: no process could be started (", std::strerror(end.no_child), ")"});
  if (!end.answer) return joined({"cannot be read: the process that read it ", end.how});
  std::string_view rest = *end.answer;
  if (!rest.starts_with('m')) {
    return joined({"cannot be read as a mesh of kind ", ending, ": ", one_line(end.answer->substr(1))});
  }
  rest.remove_prefix(1);
  TriangleMesh mesh;
  if (!take(rest, mesh.place) || !take(rest, mesh.triangle)) return std::string("cannot be read");
  if (!is_sound(mesh)) return std::string("has corners that are no places");
  return mesh;
}

#else

Result read_lower_case(std::string_view, const std::string&) {
  return std::string("cannot be read: this program was built without Assimp (libassimp-dev), which reads meshes");
}

#endif

}  // namespace

Result read_triangles(std::string_view content, const std::string& ending) {
  std::string lower = ending;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (lower != "stl" && lower != "obj" && lower != "ply") {
    return std::string("is no mesh that is read: its name must end in .stl, .obj or .ply");
  }
  if (content.empty()) return std::string("is empty");
  return read_lower_case(content, lower);
}

}  // namespace unbruised::studies
