#include "studies/results/vtkhdf_file.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/scenario/attitude.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/hdf5_file.hpp"

namespace unbruised::studies {
namespace {

using Vector = std::array<double, 3>;

/// Kinds of cells, as VTK numbers them; its reader takes no other type than this.
enum class Cell : std::uint8_t { vertex = 1, line = 3, triangle = 5, quad = 9 };

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

Vector vector_at(const std::vector<double>& values, std::size_t at) {
  return {values[3 * at], values[3 * at + 1], values[3 * at + 2]};
}

Attitude attitude_at(const std::vector<double>& values, std::size_t at) {
  return {values[4 * at], {values[4 * at + 1], values[4 * at + 2], values[4 * at + 3]}};
}

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// The cells of all steps: points come product first, then the faces, then a point for each force.
class Grid {
 public:
  explicit Grid(const Replay& replay) : replay_(replay) {
    for (const auto& triangle : replay.triangle) add(Cell::triangle, {triangle.begin(), triangle.end()}, 0);
    for (const auto& line : replay.line) add(Cell::line, {line.begin(), line.end()}, 0);
    if (replay.triangle.empty() && replay.line.empty()) {
      for (int v = 0; v < static_cast<int>(replay.vertex_m.size()); ++v) add(Cell::vertex, {v}, 0);
    }
    points_ = static_cast<int>(replay.vertex_m.size());
    int of_part = 0;
    for (const ReplaySurface& surface : replay.surface) add_face(surface, ++of_part);
    first_force_ = points_;
    of_part = 0;
    for (std::size_t s = 0; s < replay.surface.size(); ++s) add(Cell::vertex, {points_++}, ++of_part);
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }

  [[nodiscard]] std::size_t point_count() const { return static_cast<std::size_t>(points_); }
  [[nodiscard]] std::size_t first_force() const { return static_cast<std::size_t>(first_force_); }

  /// Where the points are in a frame.
  [[nodiscard]] std::vector<double> places(std::size_t frame) const {
    std::vector<double> all;
    const auto put = [&all](const Vector& place) { all.insert(all.end(), place.begin(), place.end()); };
    const Attitude attitude = attitude_at(replay_.attitude, frame);
    for (std::size_t v = 0; v < replay_.vertex_m.size(); ++v) {
      const std::size_t row = frame * replay_.vertex_m.size() + v;
      Vector place = replay_.vertex_m[v];
      for (std::size_t i = 0; i < 3; ++i) place[i] += static_cast<double>(replay_.deformation_m[3 * row + i]);
      put(vector_at(replay_.product_m, frame) + turned(attitude, place));
    }
    std::size_t pad = 0, listed = 0;
    for (const ReplaySurface& surface : replay_.surface) put_face(surface, frame, pad, listed, put);
    for (std::size_t s = 0; s < replay_.surface.size(); ++s) {
      put(vector_at(replay_.force_place_m, frame * replay_.surface.size() + s));
    }
    return all;
  }

  std::vector<std::uint8_t> types;
  std::vector<std::int64_t> offsets, connectivity;
  std::vector<std::int32_t> part;

 private:
  static constexpr int kFlatSide = 2;
  static int side_of(const ReplaySurface& surface) {
    return surface.height_m.empty() ? kFlatSide : kReplayFaceSide;
  }
  /// A face without an edge is drawn this large [m].
  static constexpr double kEndless_m = 0.4;

  void add(Cell type, const std::vector<int>& points, int of_part) {
    types.push_back(static_cast<std::uint8_t>(type));
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    connectivity.insert(connectivity.end(), points.begin(), points.end());
    part.push_back(of_part);
  }

  void add_face(const ReplaySurface& surface, int of_part) {
    if (surface.kind == ReplaySurface::Kind::absent) return;
    const int side = side_of(surface), first = points_;
    for (int i = 0; i + 1 < side; ++i) {
      for (int j = 0; j + 1 < side; ++j) {
        const int at = first + i * side + j;
        add(Cell::quad, {at, at + side, at + side + 1, at + 1}, of_part);
      }
    }
    points_ += side * side;
  }

  template <class Put>
  void put_face(const ReplaySurface& surface, std::size_t frame, std::size_t& pad, std::size_t& listed,
                const Put& put) const {
    if (surface.kind == ReplaySurface::Kind::absent) return;
    const bool is_pad = surface.kind == ReplaySurface::Kind::pad;
    Vector moved{};
    if (surface.kind == ReplaySurface::Kind::support) moved = vector_at(replay_.support_m, frame);
    if (surface.kind == ReplaySurface::Kind::listed) {
      moved = vector_at(replay_.listed_m, frame * count_of(ReplaySurface::Kind::listed) + listed++);
    }
    if (is_pad) {
      const double way_m = replay_.finger_way_m[frame * count_of(ReplaySurface::Kind::pad) + pad++];
      for (std::size_t i = 0; i < 3; ++i) moved[i] = way_m * surface.axes[2][i];
    }
    const int side = side_of(surface);
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const std::array<int, 2> at = {i, j};
        Vector place = surface.origin_m + moved;
        for (std::size_t t = 0; t < 2; ++t) {
          const double size_m = surface.size_m[t] > 0.0 ? surface.size_m[t] : kEndless_m;
          const double along_m = (static_cast<double>(at[t]) / (side - 1) - 0.5) * size_m;
          for (std::size_t k = 0; k < 3; ++k) place[k] += along_m * surface.axes[t][k];
        }
        if (!surface.height_m.empty()) {
          const double height_m = surface.height_m[static_cast<std::size_t>(i * side + j)];
          for (std::size_t k = 0; k < 3; ++k) place[k] += height_m * surface.axes[2][k];
        }
        if (is_pad) {
          place = turned(attitude_at(replay_.palm_attitude, frame), place) + replay_.grip_m +
                  vector_at(replay_.palm_m, frame);
        }
        put(place);
      }
    }
  }

  [[nodiscard]] std::size_t count_of(ReplaySurface::Kind kind) const {
    std::size_t count = 0;
    for (const ReplaySurface& surface : replay_.surface) count += surface.kind == kind ? 1 : 0;
    return count;
  }

  const Replay& replay_;
  int points_ = 0, first_force_ = 0;
};

/// A field of the product at the points of every step; nothing elsewhere.
std::vector<double> product_field(const Replay& replay, const Grid& grid, const std::vector<float>& values,
                                  std::size_t width) {
  std::vector<double> all;
  const std::size_t row = width * replay.vertex_m.size();
  for (std::size_t frame = 0; frame < replay.frame_count(); ++frame) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(frame * row);
    all.insert(all.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
    all.insert(all.end(), width * (grid.point_count() - replay.vertex_m.size()), kNothing);
  }
  return all;
}

void write_steps(const Replay& replay, const Grid& grid, Hdf5File& file) {
  const std::size_t steps = replay.frame_count();
  std::vector<std::int64_t> zeros(steps, 0), firsts;
  for (std::size_t frame = 0; frame < steps; ++frame) {
    firsts.push_back(static_cast<std::int64_t>(frame * grid.point_count()));
  }
  const std::string at = "/VTKHDF/Steps";
  file.make_group(at);
  file.set_attribute(at, "NSteps", static_cast<std::int32_t>(steps));
  file.write(at + "/Values", std::span(replay.time_s), {steps});
  const std::vector<std::int64_t> ones(steps, 1);
  file.write(at + "/NumberOfParts", std::span(ones), {steps});
  file.write(at + "/PartOffsets", std::span(zeros), {steps});
  file.write(at + "/PointOffsets", std::span(firsts), {steps});
  file.write(at + "/CellOffsets", std::span(zeros), {steps, 1});
  file.write(at + "/ConnectivityIdOffsets", std::span(zeros), {steps, 1});
  for (const char* name : {"displacement_m", "plastic_strain", "von_mises_Pa", "pressure_Pa", "force_N"}) {
    file.write(at + "/PointDataOffsets/" + name, std::span(firsts), {steps});
  }
  // What is left behind at the end is the same in every step.
  file.write(at + "/PointDataOffsets/permanent_set_m", std::span(zeros), {steps});
  file.write(at + "/CellDataOffsets/part", std::span(zeros), {steps});
}

void write_point_data(const Replay& replay, const Grid& grid, Hdf5File& file) {
  const std::size_t rows = replay.frame_count() * grid.point_count();
  const std::string at = "/VTKHDF/PointData/";
  file.write(at + "displacement_m", std::span<const double>(product_field(replay, grid, replay.deformation_m, 3)),
             {rows, 3});
  const std::array<std::pair<const char*, const std::vector<float>*>, 3> fields = {
      {{"plastic_strain", &replay.plastic_strain},
       {"von_mises_Pa", &replay.von_mises_Pa},
       {"pressure_Pa", &replay.pressure_Pa}}};
  for (const auto& [name, values] : fields) {
    file.write(at + name, std::span<const double>(product_field(replay, grid, *values, 1)), {rows});
  }
  std::vector<double> forces;
  for (std::size_t frame = 0; frame < replay.frame_count(); ++frame) {
    forces.insert(forces.end(), 3 * grid.first_force(), kNothing);
    for (std::size_t s = 0; s < replay.surface.size(); ++s) {
      const Vector force_N = vector_at(replay.force_N, frame * replay.surface.size() + s);
      forces.insert(forces.end(), force_N.begin(), force_N.end());
    }
  }
  file.write(at + "force_N", std::span<const double>(forces), {rows, 3});
  std::vector<double> permanent(replay.permanent_m.begin(), replay.permanent_m.end());
  permanent.resize(3 * grid.point_count(), kNothing);
  file.write(at + "permanent_set_m", std::span<const double>(permanent), {grid.point_count(), 3});
}

std::string vtkhdf_image(const std::filesystem::path& path, const Replay& replay) {
  const Grid grid(replay);
  Hdf5File file = Hdf5File::create(path);
  const std::string at = "/VTKHDF";
  file.make_group(at);
  const std::array<std::int64_t, 2> version = {2, 0};
  file.set_attribute(at, "Version", std::span(version));
  file.set_fixed_attribute(at, "Type", "UnstructuredGrid");
  const auto one = [&](const char* name, std::size_t value) {
    const std::array<std::int64_t, 1> values = {static_cast<std::int64_t>(value)};
    file.write(at + "/" + name, std::span<const std::int64_t>(values), {1});
  };
  one("NumberOfPoints", grid.point_count());
  one("NumberOfCells", grid.types.size());
  one("NumberOfConnectivityIds", grid.connectivity.size());
  std::vector<double> points;
  for (std::size_t frame = 0; frame < replay.frame_count(); ++frame) {
    const std::vector<double> here = grid.places(frame);
    points.insert(points.end(), here.begin(), here.end());
  }
  file.write(at + "/Points", std::span<const double>(points), {points.size() / 3, 3});
  file.write(at + "/Types", std::span<const std::uint8_t>(grid.types), {grid.types.size()});
  file.write(at + "/Offsets", std::span<const std::int64_t>(grid.offsets), {grid.offsets.size()});
  file.write(at + "/Connectivity", std::span<const std::int64_t>(grid.connectivity), {grid.connectivity.size()});
  file.write(at + "/CellData/part", std::span<const std::int32_t>(grid.part), {grid.part.size()});
  write_point_data(replay, grid, file);
  write_steps(replay, grid, file);
  return file.image();
}

}  // namespace

MaybeError write_vtkhdf(const std::filesystem::path& path, const Replay& replay) {
  try {
    return write_text_file(path, vtkhdf_image(path, replay));
  } catch (const Hdf5Failure& failure) {
    return ResultsError{ResultsErrorKind::io, failure.what(), {}};
  }
}

}  // namespace unbruised::studies
