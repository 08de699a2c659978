#include "studies/ranks/rank_messages.hpp"

#include <stdexcept>
#include <vector>

#include "studies/ranks/scenario_bytes.hpp"
#include "studies/results/bytes.hpp"
#include "studies/results/journal.hpp"

namespace unbruised::studies {
namespace {

/// Writes what stands behind the number of the word.
struct Writer {
  ByteWriter& out;

  void operator()(const RankHello& hello) const {
    out.put_text(hello.build);
    out.put(hello.seats);
  }
  void operator()(const RankOrder& order) const { out.put(static_cast<std::uint8_t>(order.curves)); }
  void operator()(const RankQuestion& question) const {
    out.put(question.ticket);
    out.put_text(scenario_bytes(question.scenario));
  }
  void operator()(const RankAnswer& answer) const {
    out.put(answer.ticket);
    out.put_text(encode_scenario_row({.id = answer.ticket, .result = answer.result, .inputs = {}}));
    for (const auto* numbers :
         {&answer.curve.time_s, &answer.curve.closure_m, &answer.curve.force_N, &answer.curve.slide_N}) {
      out.put(static_cast<std::uint64_t>(numbers->size()));
      for (const double number : *numbers) out.put(number);
    }
  }
  void operator()(const RankEnd&) const {}
};

/// The reader takes no more than there is, whatever a length says.
void read_numbers(ByteReader& in, std::vector<double>& numbers) {
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t i = 0; i < count && in.ok(); ++i) numbers.push_back(in.get<double>());
}

RankQuestion question_of(ByteReader& in) {
  RankQuestion question{.ticket = in.get<std::uint64_t>(), .scenario = {}};
  auto scenario = scenario_of_bytes(in.get_text());
  if (!scenario) throw std::runtime_error("a rank asked for no scenario");
  question.scenario = *std::move(scenario);
  return question;
}

RankAnswer answer_of(ByteReader& in) {
  RankAnswer answer{.ticket = in.get<std::uint64_t>(), .result = {}, .curve = {}};
  const auto row = decode_scenario_row(answer.ticket, in.get_text());
  if (!row) throw std::runtime_error("a rank answered with no result");
  answer.result = row->result;
  for (auto* numbers :
       {&answer.curve.time_s, &answer.curve.closure_m, &answer.curve.force_N, &answer.curve.slide_N}) {
    read_numbers(in, *numbers);
  }
  return answer;
}

RankWord read_word(std::uint8_t number, ByteReader& in) {
  switch (number) {
    case 0: {
      RankHello hello{.build = in.get_text(), .seats = 1};
      hello.seats = in.get<std::uint64_t>();
      return hello;
    }
    case 1:
      return RankOrder{in.get<std::uint8_t>() == 0 ? Curves::none : Curves::kept};
    case 2:
      return question_of(in);
    case 3:
      return answer_of(in);
    default:
      return RankEnd{};
  }
}

}  // namespace

std::string bytes_of(const RankWord& word) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(word.index()));
  std::visit(Writer{out}, word);
  return out.text();
}

RankWord word_of(const std::string& bytes) {
  ByteReader in(bytes);
  const auto number = in.get<std::uint8_t>();
  RankWord word = read_word(number, in);
  if (!in.at_end() || word.index() != number) throw std::runtime_error("a rank sent a broken message");
  return word;
}

}  // namespace unbruised::studies
