#include "durero/render/output/exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace durero::render {
namespace {

/// A file in memory.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : OStream("picture") {}
  void write(const char* from, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (bytes.size() < at_ + size) bytes.resize(at_ + size);
    std::copy_n(from, size, bytes.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ += size;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t place) override { at_ = place; }

  std::string bytes;

 private:
  std::size_t at_ = 0;
};

/// The channels of a file, which it lists and takes together.
class Planes {
 public:
  Planes(Imf::Header& header, std::size_t pixels) : header_(header), pixels_(pixels) {}

  /// The channel whose value at pixel i is of(i): binary32, or a whole number.
  template <class Sampler>
  void add(const char* name, Sampler&& of) {
    constexpr bool whole = std::is_integral_v<decltype(of(std::size_t{}))>;
    using Value = std::conditional_t<whole, std::uint32_t, float>;
    auto& values = std::get<std::vector<std::vector<Value>>>(planes_).emplace_back(pixels_);
    for (std::size_t i = 0; i < pixels_; ++i) values[i] = static_cast<Value>(of(i));
    constexpr auto type = whole ? Imf::UINT : Imf::FLOAT;
    header_.channels().insert(name, Imf::Channel(type));
    const auto row = sizeof(Value) * static_cast<std::size_t>(header_.dataWindow().max.x + 1);
    buffer_.insert(name, Imf::Slice(type, reinterpret_cast<char*>(values.data()), sizeof(Value), row));
  }

  const Imf::FrameBuffer& buffer() const { return buffer_; }

 private:
  Imf::Header& header_;
  std::size_t pixels_;
  std::tuple<std::vector<std::vector<float>>, std::vector<std::vector<std::uint32_t>>> planes_{};
  Imf::FrameBuffer buffer_{};
};

void add_channels(Planes& planes, const std::vector<PrimaryHit>& pixels) {
  planes.add("Z", [&](std::size_t i) { return pixels[i].depth; });
  planes.add("N.X", [&](std::size_t i) { return pixels[i].normal.x; });
  planes.add("N.Y", [&](std::size_t i) { return pixels[i].normal.y; });
  planes.add("N.Z", [&](std::size_t i) { return pixels[i].normal.z; });
  planes.add("id", [&](std::size_t i) { return pixels[i].element; });
  planes.add("level", [&](std::size_t i) { return pixels[i].level; });
}

std::string small_letters(std::string word) {
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return word;
}

}  // namespace

std::string encode_exr(const Picture& picture, std::span<const Note> notes, const std::optional<Channels>& channels) {
  Imf::Header header(static_cast<int>(picture.resolution.width), static_cast<int>(picture.resolution.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // those of Rec. ITU-R BT.709, which sRGB shares
  for (const Note& note : notes) header.insert(small_letters(note.keyword), Imf::StringAttribute(note.text));
  Planes planes(header, picture.rgb.size());
  planes.add("R", [&](std::size_t i) { return picture.rgb[i].r; });
  planes.add("G", [&](std::size_t i) { return picture.rgb[i].g; });
  planes.add("B", [&](std::size_t i) { return picture.rgb[i].b; });
  if (channels) {
    add_channels(planes, channels->pixels);
    header.insert("elements", Imf::StringVectorAttribute(channels->names));
  }
  MemoryStream file;
  {
    Imf::OutputFile out(file, header, 0);  // on this thread; its end writes the table of lines
    out.setFrameBuffer(planes.buffer());
    out.writePixels(static_cast<int>(picture.resolution.height));
  }
  return std::move(file.bytes);
}

}  // namespace durero::render
