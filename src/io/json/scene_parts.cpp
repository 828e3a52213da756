#include "durero/io/json/scene_parts.hpp"

#include <algorithm>
#include <array>

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/json_pointer.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/scene_file.hpp"

namespace durero::io {
namespace {

/// Where the parts of a kind stand: one that is the value of the key, or many in its object or its array.
enum class Holder : std::uint8_t { none, object, array };

struct PartRow {
  std::string_view key;
  Holder holder;
};

/// In step with PartKind.
constexpr std::array part_rows = {PartRow{"camera", Holder::object},           PartRow{"resolution", Holder::none},
                                  PartRow{"background", Holder::none},         PartRow{"lights", Holder::none},
                                  PartRow{"directional_lights", Holder::none}, PartRow{"environment", Holder::none},
                                  PartRow{"textures", Holder::object},         PartRow{"materials", Holder::object},
                                  PartRow{"max_depth", Holder::none},          PartRow{"groups", Holder::object},
                                  PartRow{"elementos", Holder::array},         PartRow{"mallas", Holder::array}};

const PartRow& row_of(PartKind kind) { return part_rows[static_cast<std::size_t>(kind)]; }

/// Takes the value that stands here, without the comma and the blanks behind it.
std::string take_value(const Source& source, json::Reader& in) {
  const std::size_t begin = in.offset();
  in.skip();
  const std::string_view value = source.text().substr(begin, in.offset() - begin);
  return std::string(value.substr(0, value.find_last_not_of(", \n") + 1));
}

void take_parts(const Source& source, json::Reader& in, PartKind kind, SceneParts& parts) {
  const auto take = [&](std::string_view name) {
    std::string value = take_value(source, in);
    parts.emplace_hint(parts.end(), PartKey{kind, std::string(name)}, std::move(value));
  };
  const PartRow& row = row_of(kind);
  switch (row.holder) {
    case Holder::none:
      return take("");
    case Holder::object:
      return in.members(row.key, [&](const json::Key& key) { take(key.name); });
    case Holder::array:
      return in.array(row.key, [&] { take(in.member("id").value().string("id")); });
  }
}

/// Writes a scene file around values that are text already.
class PartsText {
 public:
  explicit PartsText(const SceneParts& parts) : parts_(parts) {}

  std::string text() {
    json::Writer out(text_);
    write_version(out.begin_object(), scene_format);
    for (std::size_t i = 0; i < part_rows.size(); ++i) append_kind(static_cast<PartKind>(i));
    return text_ + "}\n";
  }

 private:
  void append_kind(PartKind kind) {
    const auto first = parts_.lower_bound({kind, ""});
    if ((first == parts_.end() || first->first.kind != kind) && kind != PartKind::elementos) return;
    const PartRow& row = row_of(kind);
    text_ += ",\n\"";
    text_.append(row.key).append("\":");
    if (row.holder == Holder::none) {
      text_ += first->second;
      return;
    }
    const bool is_object = row.holder == Holder::object;
    text_ += is_object ? "{" : "[";
    for (auto part = first; part != parts_.end() && part->first.kind == kind; ++part) {
      text_ += part == first ? "\n" : ",\n";
      if (is_object) append_key(part->first.name);
      text_ += part->second;
    }
    text_ += is_object ? "}" : "]";
  }

  void append_key(std::string_view key) { json::Writer(text_).key(key); }

  const SceneParts& parts_;
  std::string text_{};
};

}  // namespace

std::string_view key_of(PartKind kind) { return row_of(kind).key; }

std::string PartKey::pointer() const {
  std::string text = "/" + std::string(key_of(kind));
  if (row_of(kind).holder != Holder::none) text += "/" + json::pointer_token(name);
  return text;
}

SceneParts scene_parts(const scene::GroupedScene& of) {
  return scene_parts(Source("a scene", scene_text(of.scene, of.groups)));
}

SceneParts scene_parts(const Source& canonical) {
  const json::Document document(canonical);
  json::Reader in(document);
  SceneParts parts;
  in.members("a scene", [&](const json::Key& key) {
    const auto row = std::ranges::find(part_rows, key.name, &PartRow::key);
    if (row == part_rows.end())
      in.skip();  // format and version, which all scenes share
    else
      take_parts(canonical, in, static_cast<PartKind>(row - part_rows.begin()), parts);
  });
  return parts;
}

std::string parts_text(const SceneParts& parts) { return PartsText(parts).text(); }

}  // namespace durero::io
