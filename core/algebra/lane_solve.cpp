#include "core/algebra/lane_solve.hpp"

#include <utility>

#include "core/algebra/lane_solve_kernels.hpp"
#include "core/lanes/single_lanes.hpp"

namespace unbruised {
namespace {

template <class F>
void with_packs_for(const double*, const Mask& lanes, F&& f) {
  with_packs(lanes, std::forward<F>(f));
}
template <class F>
void with_packs_for(const float*, const Mask& lanes, F&& f) {
  with_single_packs(lanes, std::forward<F>(f));
}

template <class Number>
void forward(const SupernodalFactor& factor, Number* x, const Mask& lanes) {
  with_packs_for(x, lanes, [&](const auto& packs) {
    for (const Supernode& s : factor.supernode) kernels::forward_supernode(factor, s, x, packs);
  });
}

template <class Number>
void backward(const SupernodalFactor& factor, Number* x, const Mask& lanes) {
  with_packs_for(x, lanes, [&](const auto& packs) {
    for (std::size_t i = factor.supernode.size(); i-- > 0;) {
      kernels::backward_supernode(factor, factor.supernode[i], x, packs);
    }
  });
}

template <class Number>
void forward(const SupernodalFactor& factor, std::span<const int> reach, Number* x, const Mask& lanes) {
  with_packs_for(x, lanes, [&](const auto& packs) {
    for (int s : reach) kernels::forward_supernode(factor, factor.supernode[s], x, packs);
  });
}

template <class Number>
void backward(const SupernodalFactor& factor, std::span<const int> reach, Number* x, const Mask& lanes) {
  with_packs_for(x, lanes, [&](const auto& packs) {
    for (std::size_t i = reach.size(); i-- > 0;) {
      kernels::backward_supernode(factor, factor.supernode[reach[i]], x, packs);
    }
  });
}

}  // namespace

void solve_forward(const SupernodalFactor& factor, double* x, const Mask& lanes) { forward(factor, x, lanes); }
void solve_forward(const SupernodalFactor& factor, float* x, const Mask& lanes) { forward(factor, x, lanes); }
void solve_backward(const SupernodalFactor& factor, double* x, const Mask& lanes) { backward(factor, x, lanes); }
void solve_backward(const SupernodalFactor& factor, float* x, const Mask& lanes) { backward(factor, x, lanes); }
void solve_forward(const SupernodalFactor& factor, std::span<const int> reach, double* x, const Mask& lanes) {
  forward(factor, reach, x, lanes);
}
void solve_forward(const SupernodalFactor& factor, std::span<const int> reach, float* x, const Mask& lanes) {
  forward(factor, reach, x, lanes);
}
void solve_backward(const SupernodalFactor& factor, std::span<const int> reach, double* x, const Mask& lanes) {
  backward(factor, reach, x, lanes);
}
void solve_backward(const SupernodalFactor& factor, std::span<const int> reach, float* x, const Mask& lanes) {
  backward(factor, reach, x, lanes);
}

}  // namespace unbruised
