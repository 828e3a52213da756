// Spoiled files: whatever bit of a store is turned, and wherever its file is cut, it is refused, or has the scene that
// it had. No call gives another scene in silence, crashes or does not end.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "durero/io/source.hpp"
#include "durero/store/blame.hpp"
#include "durero/store/verification.hpp"
#include "kept.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using test::edit;

namespace {

/// A store with branches, tags and something to do again.
void fill(const test::KeptStore& kept) {
  store::Store of = kept.open();
  edit(of, test::balls(0, 10));
  of.add_branch("other", "HEAD~1");
  of.go_to("other");
  edit(of, "group g=none\n" + test::balls(20, 30));
  edit(of, "Eliminar_Esfera e=s20\n");
  of.undo();
  of.add_tag("v1", "main");
  of.go_to("main");
}

std::string bytes_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What is asked of a store: the scenes and events of revisions that were there.
struct Asked {
  std::string scene, other, tagged, events;
  bool operator==(const Asked&) const = default;
};

Asked asked(const std::string& path) {
  store::Store of(path, store::StoreAccess::read);
  Asked all{test::text_at(of), test::text_at(of, "other"), test::text_at(of, "v1"), ""};
  for (store::EventNumber number = of.find("HEAD"); number != store::no_event; number = of.event(number).parent) {
    const store::HistoryEvent event = of.event(number);
    of.state(number);  // its hash is held against what it says
    all.events += event.operation + event.answer + event.by.author + event.by.time + event.by.comment + "\n";
  }
  return all;
}

/// Nothing where the store is refused.
std::optional<Asked> answer(const std::string& path) {
  try {
    return asked(path);
  } catch (const io::FileError& error) {
    CHECK(std::string(error.what()).starts_with(path + ": "));
    CHECK(std::string(error.what()).find("; expected ") != std::string::npos);
    return std::nullopt;
  }
}

/// Whether the store is told to be whole. What it salvages, where it is asked to and something is left, is whole.
bool is_found_whole(const std::string& path, bool salvages) {
  const std::string left = path + ".left";
  std::filesystem::remove(left);
  try {
    store::Store of(path, store::StoreAccess::read);
    const store::StoreReport report = store::verify(of);
    if (!salvages) return report.is_whole();
    store::salvage(of, report, left);
    store::Store again(left, store::StoreAccess::read);
    CHECK(store::verify(again).defects == std::vector<std::string>());
    return report.is_whole();
  } catch (const io::FileError&) {
    return false;
  }
}

class Spoiling {
 public:
  Spoiling() : Spoiling(test::KeptStore()) {}

  const std::string& whole() const { return whole_; }

  /// Holds a spoiled store against the whole one. Whether it is refused.
  bool try_one(const std::string& bytes) {
    const std::string path = folder_.file("spoiled.store");
    for (const char* const beside : {"", "-wal", "-shm"}) std::filesystem::remove(path + beside);
    std::ofstream(path, std::ios::binary) << bytes;
    const std::optional<Asked> is = answer(path);
    if (is) CHECK(*is == was_);
    const bool salvages = ++tried_ % 16 == 0;  // the disk is waited for then
    if (is_found_whole(path, salvages)) CHECK(is.has_value());
    return !is;
  }

 private:
  explicit Spoiling(const test::KeptStore& kept) {
    fill(kept);
    whole_ = bytes_of_file(kept.path);
    was_ = asked(kept.path);
  }

  std::string whole_;
  Asked was_;
  std::size_t tried_ = 0;
  test::Folder folder_;
};

/// Turns a bit of each byte from `first` on, `stride` apart. How many of these are refused.
std::size_t turned(std::size_t first, std::size_t stride, unsigned bits) {
  Spoiling spoiling;
  test::Random random(first + stride);
  std::size_t refused = 0;
  for (std::size_t at = first; at < spoiling.whole().size(); at += stride) {
    for (unsigned i = 0; i < bits; ++i) {
      const auto bit = bits == 8 ? i : static_cast<unsigned>(random.below(8));
      std::string bytes = spoiling.whole();
      bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << bit));
      INFO("byte " << at << ", bit " << bit);
      if (spoiling.try_one(bytes)) ++refused;
    }
  }
  return refused;
}

}  // namespace

TEST_CASE("A bit that is turned is found, or changes nothing that is asked") {
  CHECK(turned(0, 3, 1) > 300);  // the rest of the bytes is room
}

TEST_CASE("Each bit that is turned is found, or changes nothing that is asked", "[long]") {
  CHECK(turned(0, 1, 8) > 8000);
}

TEST_CASE("A file that is cut is refused, wherever that is") {
  Spoiling spoiling;
  for (std::size_t size = 1; size < spoiling.whole().size(); size += size % 512 == 0 || size % 512 == 511 ? 1 : 97) {
    INFO("the first " << size << " bytes");
    CHECK(spoiling.try_one(spoiling.whole().substr(0, size)));
  }
}
