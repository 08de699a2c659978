#include "core/contact/pad_contacts.hpp"

namespace unbruised {
namespace {

/// Weighted mean over the particles of a face along the axes of the palm. @param row of a particle's x
template <class Row>
LaneVector mean(const PadFaces::Face& face, std::size_t k, const LaneArray& values, double sign, const Row& row) {
  LaneVector sum;
  for (int w = face.first[k]; w < face.first[k + 1]; ++w) {
    const auto at = static_cast<std::size_t>(w);
    const Lane weight(face.weight[at]);
    const std::size_t first = row(static_cast<std::size_t>(face.node[at]));
    for (std::size_t i = 0; i < 3; ++i) sum[i] += weight * values.get(first + i);
  }
  sum[0] *= Lane(sign);
  return sum;
}

}  // namespace

PadContacts::PadContacts(const ContactModel& model) : model_(model), faces_(*model.pads) {
  now_ = LaneArray(model.candidate.size());
  for (LaneArray* rows : {&free_, &theta_, &next_}) *rows = LaneArray(3 * model.candidate.size());
  for (std::size_t f = 0; f < kJawFingers; ++f) push_[f] = LaneArray(3 * faces_.face[f].candidate.size());
}

void PadContacts::begin_step(const PadLanes& pads, const GripperLanes& gripper) {
  const PadBody& pad = pads.model();
  const PadForces no_force = without_force();
  for (int f = 0; f < kJawFingers; ++f) {
    const auto at = static_cast<std::size_t>(f);
    const PadFaces::Face& face = faces_.face[at];
    const double sign = normal_sign(f);
    way_free_[at] = gripper.way_at_theta(f, no_force);
    for (std::size_t k = 0; k < face.candidate.size(); ++k) {
      const auto c = static_cast<std::size_t>(face.candidate[k]);
      Lane now(0.0);
      for (int w = face.first[k]; w < face.first[k + 1]; ++w) {
        const auto node =
            static_cast<std::size_t>(pad.face[static_cast<std::size_t>(face.node[static_cast<std::size_t>(w)])]);
        now += Lane(face.weight[static_cast<std::size_t>(w)]) * pads.body(f).u().get(3 * node);
      }
      now_.put(c, Lane(sign) * now);
      put_vector(free_, c, mean(face, k, pads.free(f), sign, [](std::size_t node) { return 3 * node; }));
    }
    if (node_force_[at].rows() == 0) node_force_[at] = LaneArray(3 * pad.face.size());
  }
}

Lane PadContacts::free_m(std::size_t c) const {
  const Place at = place(c);
  return free_.get(3 * c) - Lane(face(at).lag[3 * at.number]) * way_free_[at.pad];
}

void PadContacts::list_near(std::span<const int> candidates) {
  for (std::vector<int>& near : near_) near.clear();
  for (const int c : candidates) {
    const auto at = static_cast<std::size_t>(c);
    if (has(at)) near_[static_cast<std::size_t>(model_.candidate[at].surface)].push_back(faces_.place[at]);
  }
}

void PadContacts::restart(const Mask& lanes) {
  solving_ = BusyPacks(lanes);
  for (LaneArray& push : push_) {
    for (std::size_t row = 0; row < push.rows(); ++row) push.put(row, select(lanes, Lane(0.0), push.get(row)));
  }
}

LaneVector PadContacts::motion(std::size_t c, const Lane& way) const {
  const Place at = place(c);
  const PadFaces::Face& of = face(at);
  LaneVector moved = get_vector(free_, c);
  const double* row = of.compliance.data() + 9 * at.number * of.candidate.size();
  add_blocks({&row, 1}, near_[at.pad], push_[at.pad], solving_, {&moved.at, 1});
  for (std::size_t i = 0; i < 3; ++i) moved[i] -= Lane(of.lag[3 * at.number + i]) * way;
  return moved;
}

const LaneArray* PadContacts::face_force(int pad) {
  const auto at = static_cast<std::size_t>(pad);
  if (near_[at].empty()) return nullptr;
  const PadFaces::Face& of = faces_.face[at];
  LaneArray& force = node_force_[at];
  force.fill(0.0);
  for (const int number : near_[at]) {
    const auto k = static_cast<std::size_t>(number);
    LaneVector push = get_vector(push_[at], k);
    push[0] *= Lane(normal_sign(pad));
    for (int w = of.first[k]; w < of.first[k + 1]; ++w) {
      const auto i = static_cast<std::size_t>(w);
      const auto node = static_cast<std::size_t>(of.node[i]);
      put_vector(force, node, get_vector(force, node) + Lane(of.weight[i]) * push);
    }
  }
  return &force;
}

void PadContacts::end_step(const PadLanes& pads) {
  const PadBody& pad = pads.model();
  const auto row = [&pad](std::size_t node) { return 3 * static_cast<std::size_t>(pad.face[node]); };
  for (int f = 0; f < kJawFingers; ++f) {
    const PadFaces::Face& face = faces_.face[static_cast<std::size_t>(f)];
    const BodyLanes& body = pads.body(f);
    for (std::size_t k = 0; k < face.candidate.size(); ++k) {
      const auto c = static_cast<std::size_t>(face.candidate[k]);
      put_vector(theta_, c, mean(face, k, body.u_theta(), normal_sign(f), row));
      put_vector(next_, c, mean(face, k, body.u(), normal_sign(f), row));
    }
  }
}

}  // namespace unbruised
