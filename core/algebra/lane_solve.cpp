#include "core/algebra/lane_solve.hpp"

#include "core/algebra/lane_solve_kernels.hpp"

namespace unbruised {

void solve_forward(const SupernodalFactor& factor, double* x) {
  for (const Supernode& s : factor.supernode) kernels::forward_supernode<Lane>(factor, s, x);
}

void solve_backward(const SupernodalFactor& factor, double* x) {
  for (std::size_t i = factor.supernode.size(); i-- > 0;) {
    kernels::backward_supernode<Lane>(factor, factor.supernode[i], x);
  }
}

void solve_forward(const SupernodalFactor& factor, std::span<const int> reach, double* x) {
  for (int s : reach) kernels::forward_supernode<Lane>(factor, factor.supernode[s], x);
}

void solve_backward(const SupernodalFactor& factor, std::span<const int> reach, double* x) {
  for (std::size_t i = reach.size(); i-- > 0;) {
    kernels::backward_supernode<Lane>(factor, factor.supernode[reach[i]], x);
  }
}

}  // namespace unbruised
