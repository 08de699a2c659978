#include "core/body/static_columns.hpp"

#include "core/door/require.hpp"

namespace unbruised {

Eigen::MatrixXd shifted_columns(const StaticSolver& statics, const Eigen::MatrixXd& force_N) {
  require(force_N.cols() <= kLanes, "shifted_columns: more than lanes");
  const auto rows = static_cast<std::size_t>(force_N.rows());
  LaneArray force(rows), moved(rows);
  for (Eigen::Index j = 0; j < force_N.cols(); ++j) {
    for (std::size_t i = 0; i < rows; ++i) {
      force.at(i, static_cast<int>(j)) = force_N(static_cast<Eigen::Index>(i), j);
    }
  }
  statics.shifted_solve(force, moved);
  Eigen::MatrixXd shape(force_N.rows(), force_N.cols());
  for (Eigen::Index j = 0; j < shape.cols(); ++j) {
    for (std::size_t i = 0; i < rows; ++i) {
      shape(static_cast<Eigen::Index>(i), j) = moved.at(i, static_cast<int>(j));
    }
  }
  return shape;
}

}  // namespace unbruised
