#include "core/algebra/lane_solve.hpp"

#include "core/algebra/lane_solve_kernels.hpp"

namespace unbruised {

void solve_forward(const SupernodalFactor& factor, double* x, const Mask& lanes) {
  with_packs(lanes, [&](const auto& packs) {
    for (const Supernode& s : factor.supernode) kernels::forward_supernode(factor, s, x, packs);
  });
}

void solve_backward(const SupernodalFactor& factor, double* x, const Mask& lanes) {
  with_packs(lanes, [&](const auto& packs) {
    for (std::size_t i = factor.supernode.size(); i-- > 0;) {
      kernels::backward_supernode(factor, factor.supernode[i], x, packs);
    }
  });
}

void solve_forward(const SupernodalFactor& factor, std::span<const int> reach, double* x, const Mask& lanes) {
  with_packs(lanes, [&](const auto& packs) {
    for (int s : reach) kernels::forward_supernode(factor, factor.supernode[s], x, packs);
  });
}

void solve_backward(const SupernodalFactor& factor, std::span<const int> reach, double* x, const Mask& lanes) {
  with_packs(lanes, [&](const auto& packs) {
    for (std::size_t i = reach.size(); i-- > 0;) {
      kernels::backward_supernode(factor, factor.supernode[reach[i]], x, packs);
    }
  });
}

}  // namespace unbruised
