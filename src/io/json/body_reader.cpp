#include "body_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "durero/scene/solids.hpp"
#include "durero/text/shown.hpp"
#include "map_fields.hpp"
#include "solid_bodies.hpp"

namespace durero::io {
namespace {

/// The most bodies of a scene: a group of groups of copies doubles with every line.
constexpr std::size_t most_bodies = std::size_t{1} << 22;
/// The most that stand within one another.
constexpr std::size_t most_within = 500;

constexpr std::string_view instance_keys[] = {"de", "mapa"};

/// The copies that a map makes of what `de` names.
BodyParts make_instance(BodyReader& reader, std::span<const json::Reader> values) {
  json::Reader at_map = values[1];
  const model::Mapa mapa = read_map(at_map);
  BodyParts parts = reader.parts(values[0]);
  for (BodyPart& part : parts) part.body = scene::copied(mapa, part.body);
  return parts;
}

constexpr BodyTipo all_tipos[] = {{"instancia", instance_keys, make_instance},
                                  {"union", solid_keys, make_union},
                                  {"interseccion", solid_keys, make_intersection},
                                  {"diferencia", solid_keys, make_difference},
                                  {"caja", box_keys, make_box}};

bool is_one(const BodyParts& parts) { return parts.size() == 1 && parts.front().name.empty(); }

/// A mark that is taken back at the end of its scope.
class Mark {
 public:
  Mark(std::set<const void*>& marks, const void* mark) : marks_(marks), mark_(mark) {}
  ~Mark() { marks_.erase(mark_); }
  Mark(const Mark&) = delete;
  Mark& operator=(const Mark&) = delete;

 private:
  std::set<const void*>& marks_;
  const void* mark_;
};

/// A depth that is one more until the end of its scope.
class OneDeeper {
 public:
  explicit OneDeeper(std::size_t& depth) : depth_(depth) { ++depth_; }
  ~OneDeeper() { --depth_; }
  OneDeeper(const OneDeeper&) = delete;
  OneDeeper& operator=(const OneDeeper&) = delete;

 private:
  std::size_t& depth_;
};

[[noreturn]] void fail_too_many(const json::Reader& in, std::size_t at) {
  in.fail(at, fmt::format("there are more than {} copies", most_bodies), "expected fewer");
}

[[noreturn]] void fail_within_itself(const json::Reader& in, std::size_t at, std::string_view name) {
  in.fail(at, fmt::format("{} is made of itself", text::shown(name)), "expected one that is made of others");
}

}  // namespace

BodyParts alone(scene::Body body) {
  BodyParts parts;
  parts.push_back({{}, std::move(body)});
  return parts;
}

std::span<const BodyTipo> body_tipos() { return all_tipos; }

const BodyTipo* body_tipo(const json::Reader& in) {
  auto tipo = in.member("tipo");
  if (!tipo || tipo->kind() != json::TokenKind::string) return nullptr;
  const auto* const found = std::ranges::find(all_tipos, tipo->string("tipo"), &BodyTipo::word);
  return found == std::end(all_tipos) ? nullptr : found;
}

BodyReader::Kept BodyReader::read(json::Reader& in, ShapeKeys has) {
  const BodyTipo* const tipo = body_tipo(in);
  if (tipo == nullptr) {
    WrittenShape shape = read_shape(in, has);
    return {.name = shape.id, .material = shape.material, .shape = shape.shape};
  }
  std::vector<std::string_view> keys{"tipo"};
  keys.insert(keys.end(), tipo->keys.begin(), tipo->keys.end());
  if (has.id) keys.emplace_back("id");
  const std::size_t required = keys.size();
  if (has.material) keys.emplace_back("material");
  Kept kept{.tipo = tipo, .values = std::vector<json::Reader>(tipo->keys.size(), in)};
  in.object(fmt::format("an element of tipo {}", tipo->word), keys, required, [&](std::size_t key) {
    const std::size_t at = in.offset();
    if (keys[key] == "id") {
      kept.name = {read_id(in), at};
    } else if (keys[key] == "material") {
      kept.material = {in.string("material"), at};
    } else {
      if (key > 0) kept.values[key - 1] = in;
      in.skip();
    }
  });
  return kept;
}

BodyReader::Kept BodyReader::read_prototype(json::Reader& in) {
  constexpr std::string_view group_keys[] = {"elementos"};
  if (!in.member("elementos")) return read(in, {.id = false, .material = true});
  Kept group;
  std::set<std::string_view> seen;
  in.object("a prototype", group_keys, 1, [&](std::size_t) {
    in.array("elementos", [&] {
      Kept member = read(in, {.id = true, .material = true});
      if (!seen.insert(member.name.value).second)
        in.fail(member.name.offset, fmt::format("id is {}, which stands twice", text::shown(member.name.value)),
                "expected each once");
      group.members.push_back(std::move(member));
    });
  });
  return group;
}

void BodyReader::keep_element(json::Reader& in) { elements_.push_back(read(in, {.id = true, .material = true})); }

void BodyReader::keep_prototypes(json::Reader& in) {
  in.members("prototypes", [&](const json::Key& key) {
    if (!model::Elemento::is_name(std::string(key.name)))
      in.fail(key.offset, fmt::format("{} names nothing", text::shown(key.name)),
              "expected 1 to 128 of A-Z a-z 0-9 _ . : -");
    Kept prototype = read_prototype(in);
    prototype.name = {key.name, key.offset};
    prototypes_.push_back(std::move(prototype));
  });
}

void BodyReader::find_what_is_named() {
  for (const Kept& element : elements_) element_by_name_.emplace(element.name.value, &element);
  for (const Kept& prototype : prototypes_) prototype_by_name_.emplace(prototype.name.value, &prototype);
  for (std::size_t i = 0; i < groups_.size(); ++i) group_by_name_.emplace(groups_[i].name.name, i);
  for (const MaterialUse& use : uses_) material_by_name_.emplace(use.element, use.material);
}

// Each prototype and element has at most the parts that the names in it say, which are counted before any is made.
void BodyReader::require_few(const json::Reader& in) {
  for (const std::deque<Kept>* all : {&prototypes_, &elements_})
    for (const Kept& kept : *all)
      if (parts_count(kept) > most_bodies) fail_too_many(in, kept.name.offset);
}

// An element that is too deep, or made of itself, counts as one part: it is refused when it is made.
std::size_t BodyReader::parts_count(const Kept& kept) {
  const auto [known, is_new] = counts_.emplace(&kept, 1);
  if (!is_new || depth_ == most_within) return known->second;
  const OneDeeper deeper(depth_);
  std::size_t count = 1;
  if (kept.tipo != nullptr && kept.tipo->make == make_instance) {
    count = parts_count(kept.values[0]);
  } else if (kept.tipo == nullptr && !kept.shape) {
    count = 0;
    for (const Kept& member : kept.members) count = std::min(count + parts_count(member), most_bodies + 1);
  }
  return known->second = count;
}

std::size_t BodyReader::parts_count(json::Reader in) {
  if (depth_ == most_within) return 1;
  const OneDeeper deeper(depth_);
  if (in.kind() == json::TokenKind::string) return named_count(in.string("a name"));
  if (auto group = in.member("group"))
    return group->kind() == json::TokenKind::string ? group_count(group->string("group")) : 1;
  const BodyTipo* const tipo = body_tipo(in);
  auto copied = in.member("de");
  return tipo != nullptr && tipo->make == make_instance && copied ? parts_count(*copied) : 1;
}

std::size_t BodyReader::named_count(std::string_view name) {
  for (const ByName* all : {&prototype_by_name_, &element_by_name_})
    if (const auto found = all->find(name); found != all->end()) return parts_count(*found->second);
  return 1;
}

std::size_t BodyReader::group_count(std::string_view name) {
  const auto found = group_by_name_.find(name);
  if (found == group_by_name_.end()) return named_count(name);
  const auto [known, is_new] = counts_.emplace(&found->second, 1);
  if (!is_new || depth_ == most_within) return known->second;
  const OneDeeper deeper(depth_);
  const WrittenGroup& group = groups_[found->second];
  std::size_t count = group.elementos.size();
  for (const NamePlace& inner : group.groups) count = std::min(count + group_count(inner.name), most_bodies + 1);
  return known->second = count;
}

void BodyReader::check_prototype(const json::Reader& in, const Kept& prototype) {
  const auto [name, at] = prototype.name;
  if (prototype_by_name_.at(name) != &prototype)
    in.fail(at, fmt::format("prototype {} stands twice", text::shown(name)), "expected it once");
  if (scene_.find(name) || element_by_name_.contains(name))
    in.fail(at, fmt::format("prototype {} has the name of an element", text::shown(name)), "expected another");
  parts_of(in, at, prototype);
}

std::vector<Placed<std::string_view>> BodyReader::materials_of_prototypes() const {
  std::vector<Placed<std::string_view>> all;
  const auto take = [&](const Kept& kept) {
    if (kept.material) all.push_back(*kept.material);
  };
  for (const Kept& prototype : prototypes_) {
    take(prototype);
    std::ranges::for_each(prototype.members, take);
  }
  return all;
}

void BodyReader::add(const json::Reader& in, const Kept& element) {
  const auto [name, at] = element.name;
  if (scene_.find(name)) add_stand_in(in, scene_, element.name);  // which fails
  const BodyParts& parts = parts_of(in, at, element);
  if (is_one(parts)) return add_part(in, element, name, parts.front());
  if (group_by_name_.contains(name))
    in.fail(at, fmt::format("group {} stands twice", text::shown(name)), "expected it once");
  WrittenGroup group{{std::string(name), at}, {}, {}};
  for (const BodyPart& part : parts) {
    const std::string& full = part_names_.emplace_back(fmt::format("{}:{}", name, part.name));
    if (!model::Elemento::is_name(full))
      in.fail(at, fmt::format("its element {} has a name of more than 128 characters", text::shown(full)),
              "expected a shorter id");
    add_part(in, element, full, part);
    group.elementos.push_back({full, at});
  }
  groups_.push_back(std::move(group));
}

void BodyReader::add_part(const json::Reader& in, const Kept& element, std::string_view name, const BodyPart& part) {
  add_stand_in(in, scene_, {name, element.name.offset});
  scene_.set_body(scene_.find(name).value(), part.body);
  if (part.material) uses_.push_back({name, *part.material});
}

const BodyParts& BodyReader::parts_of(const json::Reader& in, std::size_t at, const Kept& kept) {
  if (const auto found = made_.find(&kept); found != made_.end()) return found->second;
  if (!in_work_.insert(&kept).second) fail_within_itself(in, at, kept.name.value);
  const Mark mark(in_work_, &kept);
  return made_.emplace(&kept, made(kept)).first->second;
}

BodyParts BodyReader::made(const Kept& kept) {
  BodyParts parts;
  if (kept.tipo != nullptr) {
    parts = kept.tipo->make(*this, kept.values);
  } else if (kept.shape) {
    parts = alone(scene::unmoved(*kept.shape));
  } else {
    for (const Kept& member : kept.members) {
      for (BodyPart& part : made(member)) {
        part.name =
            part.name.empty() ? std::string(member.name.value) : fmt::format("{}:{}", member.name.value, part.name);
        parts.push_back(std::move(part));
      }
    }
  }
  if (kept.material)
    for (BodyPart& part : parts) part.material = kept.material;
  return parts;
}

scene::Body BodyReader::body(json::Reader in) {
  BodyParts found = parts(in);
  if (!is_one(found)) in.fail(in.offset(), "a group stands here", "expected an element");
  return std::move(found.front().body);
}

BodyParts BodyReader::parts(json::Reader in) {
  const std::size_t at = in.offset();
  if (depth_ == most_within)
    in.fail(at, fmt::format("more than {} elements are made of one another", most_within), "expected fewer");
  const OneDeeper deeper(depth_);
  BodyParts found;
  if (in.kind() == json::TokenKind::string) {
    found = named(in, at, in.string("a name"));
  } else if (in.member("group")) {
    constexpr std::string_view keys[] = {"group"};
    in.object("a group", keys, 1, [&](std::size_t) {
      const std::size_t at_name = in.offset();
      found = of_group(in, at_name, in.string("group"));
    });
  } else {
    found = made(read(in, {.id = false, .material = false}));
  }
  count_ += found.size();
  if (count_ > most_bodies) fail_too_many(in, at);
  return found;
}

BodyParts BodyReader::named(const json::Reader& in, std::size_t at, std::string_view name) {
  if (const auto found = prototype_by_name_.find(name); found != prototype_by_name_.end())
    return parts_of(in, at, *found->second);
  if (const auto found = element_by_name_.find(name); found != element_by_name_.end())
    return parts_of(in, at, *found->second);
  BodyPart part = of_element(in, {std::string(name), at});
  BodyParts parts = alone(std::move(part.body));
  parts.front().material = part.material;
  return parts;
}

BodyPart BodyReader::of_element(const json::Reader& in, const NamePlace& name) {
  const auto kept = element_by_name_.find(name.name);
  if (kept != element_by_name_.end()) {
    const BodyParts& parts = parts_of(in, name.offset, *kept->second);
    if (!is_one(parts))
      in.fail(name.offset, fmt::format("{} is a group", text::shown(name.name)), "expected an element");
    return {name.name, parts.front().body, parts.front().material};
  }
  const auto element = scene_.find(name.name);
  if (!element)
    in.fail(name.offset, fmt::format("{} is no element", text::shown(name.name)),
            "expected the name of an element or of a prototype");
  BodyPart part{name.name, scene_.visit(*element, [](const auto& shape) { return scene::unmoved(shape); })};
  const auto material = material_by_name_.find(name.name);
  if (material != material_by_name_.end()) part.material = material->second;
  return part;
}

BodyParts BodyReader::of_group(const json::Reader& in, std::size_t at, std::string_view name) {
  const auto found = group_by_name_.find(name);
  if (found == group_by_name_.end()) {
    const auto kept = element_by_name_.find(name);
    if (kept != element_by_name_.end() && !is_one(parts_of(in, at, *kept->second)))
      return parts_of(in, at, *kept->second);
    in.fail(at, fmt::format("{} is no group", text::shown(name)), "expected the name of a group");
  }
  if (!in_work_.insert(&found->second).second) fail_within_itself(in, at, name);
  const Mark mark(in_work_, &found->second);
  const WrittenGroup group = groups_[found->second];
  BodyParts parts;
  for (const NamePlace& e : group.elementos) parts.push_back(of_element(in, e));
  for (const NamePlace& g : group.groups) {
    BodyParts inner = of_group(in, g.offset, g.name);
    const bool is_copy = !group_by_name_.contains(g.name);
    for (BodyPart& part : inner) {
      if (is_copy) part.name = fmt::format("{}:{}", g.name, part.name);
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

}  // namespace durero::io
