// Journals. The first byte chooses what the rest is: the bytes of a file, the payload of a row, or pieces of a
// file: each piece is a byte for its kind, one for its length and its bytes; odd kinds become whole records with
// right checksums.

#include <string>
#include <vector>

#include "studies/results/journal.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace unbruised::studies;
using unbruised::fuzz::require;

constexpr std::uint64_t kPrefix = 0x0123456789ABCDEFU;
constexpr std::size_t kHeaderBytes = 40;

/// Every byte of a file is a record, damage, or the torn tail.
JournalScan check_scan(const std::string& bytes) {
  JournalScan scan = scan_journal_bytes(bytes, kPrefix);
  std::uint64_t accounted = scan.torn_tail_bytes;
  for (const JournalDamage& damage : scan.damage) {
    require(damage.bytes > 0 && damage.offset + damage.bytes <= bytes.size(), "damage lies inside the file");
    accounted += damage.bytes;
  }
  for (const JournalRecord& record : scan.records) accounted += kHeaderBytes + record.payload.size();
  if (scan.other_config_records == 0) require(accounted == bytes.size(), "every byte is accounted for");
  require(accounted <= bytes.size(), "no byte is counted twice");
  return scan;
}

/// What was decoded is encoded and decoded to the same bytes.
void check_payload(std::string_view payload) {
  if (const auto row = decode_scenario_row(7, payload)) {
    const std::string bytes = encode_scenario_row(*row);
    const auto again = decode_scenario_row(7, bytes);
    require(again && encode_scenario_row(*again) == bytes, "a scenario row survives the journal");
  }
}

void check_pieces(std::string_view pieces) {
  std::string bytes;
  std::vector<std::string> whole;
  while (pieces.size() >= 2) {
    const auto kind = static_cast<unsigned char>(pieces[0]);
    const std::string payload(pieces.substr(2, static_cast<unsigned char>(pieces[1])));
    pieces.remove_prefix(2 + payload.size());
    if (kind % 2 == 0) {
      bytes += payload;
    } else {
      bytes += encode_record({static_cast<RecordKind>(kind % 8), kind, 0, payload}, kPrefix);
      whole.push_back(payload);
    }
  }
  const JournalScan scan = check_scan(bytes);
  std::size_t found = 0;
  for (const JournalRecord& record : scan.records) {
    if (found < whole.size() && record.payload == whole[found]) ++found;
  }
  // Bytes in between may claim the start of a record that follows them, but only with right checksums: out of
  // reach here.
  require(found == whole.size(), "every whole record is found, in order");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest = unbruised::fuzz::text_of(data + 1, size - 1);
  switch (data[0] % 3) {
    case 0:
      for (const JournalRecord& record : check_scan(std::string(rest)).records) check_payload(record.payload);
      break;
    case 1:
      check_payload(rest);
      break;
    default:
      check_pieces(rest);
  }
  return 0;
}
