#include "core/contact/pad_faces.hpp"

#include "core/contact/contact_model.hpp"
#include "core/contact/pad_weights.hpp"

namespace unbruised {
namespace {

/// Lists the candidates of a pad and their weights.
void add_weights(const ContactModel& contact, const PadBody& pad, int surface,
                 const std::array<double, 2>& middle_m, PadFaces::Face& face) {
  const FaceGrid& grid = contact.face[static_cast<std::size_t>(surface)];
  std::array<std::vector<PadWeights>, 2> along;
  for (std::size_t t = 0; t < 2; ++t) along[t] = pad_weights(grid.piece[t], pad.place_m[t], middle_m[t]);
  const std::size_t across = grid.piece[1].size();
  std::vector<std::size_t> place(contact.candidate.size());
  for (std::size_t at = 0; at < grid.candidate.size(); ++at) {
    if (grid.candidate[at] >= 0) place[static_cast<std::size_t>(grid.candidate[at])] = at;
  }
  for (std::size_t c = 0; c < contact.candidate.size(); ++c) {
    if (contact.candidate[c].surface != surface) continue;
    const PadWeights &y = along[0][place[c] / across], &z = along[1][place[c] % across];
    face.candidate.push_back(static_cast<int>(c));
    face.first.push_back(static_cast<int>(face.node.size()));
    for (std::size_t j = 0; j < z.weight.size(); ++j) {
      for (std::size_t i = 0; i < y.weight.size(); ++i) {
        face.node.push_back(static_cast<int>((z.first + j) * pad.columns() + y.first + i));
        face.weight.push_back(y.weight[i] * z.weight[j]);
      }
    }
  }
  face.first.push_back(static_cast<int>(face.node.size()));
}

/// What the particles of the pad's face have, at one candidate.
template <class Add>
void weigh(const PadFaces::Face& face, std::size_t k, const Add& add) {
  for (int w = face.first[k]; w < face.first[k + 1]; ++w) {
    add(static_cast<std::size_t>(face.node[static_cast<std::size_t>(w)]),
        face.weight[static_cast<std::size_t>(w)]);
  }
}

/// B A^-1 B', and the lag; x of the pad is that of the palm times its sign.
void add_compliance(const PadBody& pad, const WilsonTheta& wilson, double sign, PadFaces::Face& face) {
  const std::size_t m = face.candidate.size(), n = pad.face.size();
  const std::vector<double>& of_face = pad.compliance.block;
  std::vector<double> half(9 * m * n, 0.0);  // B A^-1
  face.compliance.assign(9 * m * m, 0.0);
  face.lag.assign(3 * m, 0.0);
  for (std::size_t k = 0; k < m; ++k) {
    weigh(face, k, [&](std::size_t node, double weight) {
      for (std::size_t i = 0; i < 9 * n; ++i) half[9 * n * k + i] += weight * of_face[9 * n * node + i];
      for (std::size_t i = 0; i < 3; ++i) {
        face.lag[3 * k + i] +=
            (i == 0 ? sign : 1.0) * wilson.a0 * weight * pad.lag[3 * static_cast<std::size_t>(pad.face[node]) + i];
      }
    });
  }
  for (std::size_t k = 0; k < m; ++k) {
    for (std::size_t l = 0; l < m; ++l) {
      double* block = face.compliance.data() + 9 * (k * m + l);
      weigh(face, l, [&](std::size_t node, double weight) {
        for (std::size_t i = 0; i < 9; ++i) block[i] += weight * half[9 * (n * k + node) + i];
      });
      for (std::size_t i = 1; i < 3; ++i) {
        block[i] *= sign;
        block[3 * i] *= sign;
      }
    }
  }
}

}  // namespace

PadFaces pad_faces(const ContactModel& contact, const PadBody& pad, const WilsonTheta& wilson,
                   const std::array<double, 2>& middle_m) {
  PadFaces faces;
  faces.place.assign(contact.candidate.size(), -1);
  for (int surface = 0; surface < kJawFingers; ++surface) {
    PadFaces::Face& face = faces.face[static_cast<std::size_t>(surface)];
    add_weights(contact, pad, surface, middle_m, face);
    add_compliance(pad, wilson, normal_sign(surface), face);
    for (std::size_t k = 0; k < face.candidate.size(); ++k) {
      faces.place[static_cast<std::size_t>(face.candidate[k])] = static_cast<int>(k);
    }
  }
  return faces;
}

}  // namespace unbruised
