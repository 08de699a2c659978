// What contact asks of its callers, in every build.

#include "core/contact/contact_lanes.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "core/simulation/model_parts.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(ContactLanes, AreLoadedIntoALaneThatThereIs) {
  const auto model = build(small_box());
  const Model::Parts& parts = model->parts();
  ContactLanes contact(parts.contact, parts.body, *parts.wilson);
  for (const int lane : {-1, kLanes}) {
    EXPECT_THROW(contact.load(lane, small_box()), std::logic_error);
    EXPECT_THROW(contact.set_rest(lane, {}), std::logic_error);
  }
}

TEST(ContactLanes, TakeTheRestOfTheirOwnProductOnly) {
  const auto model = build(small_box());
  const Model::Parts& parts = model->parts();
  ContactLanes contact(parts.contact, parts.body, *parts.wilson);
  contact.load(0, small_box());
  const std::vector<double> fewer(parts.contact.candidate.size() - 1, 0.0);
  EXPECT_THROW(contact.set_rest(0, {{}, fewer, fewer}), std::logic_error);
}

TEST(ContactLanes, NeedAContactModelWithItsCompliance) {
  Scenario scenario = small_box();
  const auto model = build(scenario);
  const Model::Parts& parts = model->parts();
  const ContactModel candidates_only = lattice_contact(lattice_of(scenario), *parts.body.lattice, {});
  EXPECT_THROW(ContactLanes(candidates_only, parts.body, *parts.wilson), std::logic_error);
}

TEST(ContactModel, IsMadeOfTheBodyOfItsProduct) {
  const auto model = build(small_box());
  const BodyModel& box = model->parts().body;
  NetworkParameters network;
  network.particle.resize(2);
  Scenario scenario;
  scenario.product = network;
  EXPECT_THROW(product_contact(scenario, box, *model->parts().wilson), std::logic_error);
}

}  // namespace
}  // namespace unbruised
