#include "durero/render/output/exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "support/catch.hpp"

using namespace durero;

namespace {

struct Reader : Imf::IStream {
  explicit Reader(const std::string& all) : IStream("picture"), bytes(all) {}
  bool read(char* to, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (at + size > bytes.size()) throw std::runtime_error("the file ends");
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), size, to);
    at += size;
    return at < bytes.size();
  }
  std::uint64_t tellg() override { return at; }
  void seekg(std::uint64_t place) override { at = place; }
  const std::string& bytes;
  std::size_t at = 0;
};

template <class Value>
std::vector<Value> channel(Imf::InputFile& file, const char* name) {
  const auto window = file.header().dataWindow();
  const auto width = static_cast<std::size_t>(window.max.x + 1), height = static_cast<std::size_t>(window.max.y + 1);
  std::vector<Value> values(width * height);
  Imf::FrameBuffer buffer;
  const Imf::Channel* const found = file.header().channels().findChannel(name);
  REQUIRE(found != nullptr);
  buffer.insert(name,
                Imf::Slice(found->type, reinterpret_cast<char*>(values.data()), sizeof(Value), sizeof(Value) * width));
  file.setFrameBuffer(buffer);
  file.readPixels(0, window.max.y);
  return values;
}

render::Picture ramp() {
  render::Picture picture({3, 2});
  for (std::size_t i = 0; i < 6; ++i) picture.rgb[i] = {0.1 * double(i), 1000.0 + double(i), 0x1p-30 * double(i)};
  return picture;
}

}  // namespace

TEST_CASE("an OpenEXR file reads back to the linear picture, rounded to binary32, whatever was above 1") {
  const render::Picture picture = ramp();
  const render::Note notes[] = {{"Software", "Durero"}, {"Comment", "durero render größer.json"}};
  const std::string bytes = render::encode_exr(picture, notes);
  CHECK(bytes == render::encode_exr(picture, notes));
  Reader reader(bytes);
  Imf::InputFile file(reader);
  CHECK(file.header().dataWindow().max == Imath::V2i(2, 1));
  const auto r = channel<float>(file, "R"), g = channel<float>(file, "G"), b = channel<float>(file, "B");
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(r[i] == static_cast<float>(picture.rgb[i].x));
    CHECK(g[i] == static_cast<float>(picture.rgb[i].y));
    CHECK(b[i] == static_cast<float>(picture.rgb[i].z));
  }
  CHECK(file.header().channels().findChannel("Z") == nullptr);
  CHECK(file.header().typedAttribute<Imf::StringAttribute>("software").value() == "Durero");
  CHECK(file.header().typedAttribute<Imf::StringAttribute>("comment").value() == notes[1].text);
  CHECK(Imf::hasChromaticities(file.header()));
}

TEST_CASE("what is seen has channels of its own, and the names stand beside the numbers") {
  render::Channels seen{{}, {"ball", "wall"}};
  for (std::uint32_t i = 0; i < 6; ++i) seen.pixels.push_back({1.5 * i, {0, 0.6, -0.8}, i % 3, 3 - i % 3});
  seen.pixels[5] = {};
  const std::string bytes = render::encode_exr(ramp(), {}, seen);
  Reader reader(bytes);
  Imf::InputFile file(reader);
  const auto z = channel<float>(file, "Z"), ny = channel<float>(file, "N.Y"), nz = channel<float>(file, "N.Z");
  const auto id = channel<std::uint32_t>(file, "id"), level = channel<std::uint32_t>(file, "level");
  CHECK(z == std::vector<float>{0, 1.5, 3, 4.5, 6, std::numeric_limits<float>::infinity()});
  CHECK(ny[4] == 0.6F);
  CHECK(nz[4] == -0.8F);
  CHECK(ny[5] == 0);
  CHECK(id == std::vector<std::uint32_t>{0, 1, 2, 0, 1, 0});
  CHECK(level == std::vector<std::uint32_t>{3, 2, 1, 3, 2, 0});
  CHECK(file.header().typedAttribute<Imf::StringVectorAttribute>("elements").value() == seen.names);
}
