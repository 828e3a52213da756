#include "durero/accel/light_buffer.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "durero/scene/stage.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

static_assert(Structure<LightBuffer>);

constexpr double widening = 0x1p-22;

/// The greatest depth of squares. Smaller squares would be as small as the widening.
constexpr std::uint32_t deepest_square = 18;

/// The greatest numbers of quartered squares and of references, for so many elements.
constexpr std::size_t most_quartered(std::size_t elements) { return 512 + 2 * elements; }
constexpr std::size_t most_references(std::size_t elements) { return 4096 + 16 * elements; }

/// The length of a list whose square is quartered even if each quarter has the whole list, because a sphere may cover a
/// quarter.
constexpr std::size_t few_seen = 16;

LightCube::Item item_of(const scene::Scene& scene, scene::ElementRef e, const glm::dvec3& light) {
  return scene.visit(e, [&](const auto& shape) {
    return LightCube::Item{e, seen(surface::ball(shape), light), surface::box(shape)};
  });
}

/// Whether segments with ordinary rays may end at the light: whether an ordinary element may be there.
bool is_ordinary(const glm::dvec3& light) { return trace::ordinary(scene::Sphere{light, 1}); }

/// A sphere of radius r, whose centre is seen from the light at distance d, covers a square under this condition. If
/// the centre is within arcsin(r(1 − 2⁻²⁰)/d) of every direction of the square, widened, then it is so of −v₀. The foot
/// of the centre on the exact segment from x to the light, where |v₀| > d, is then less than r(1 − 2⁻²⁰)(1 + 2⁻⁴⁰) from
/// it, and the ray's own point at that parameter u|v₀| more: inside the sphere, if |v₀| ≤ 2³¹·r. The ray's end lies
/// u|v₀| from the light: outside, if d ≥ r(1 + 2⁻²⁰). From the one to the other the ray crosses the sphere, at 0 < t <
/// 1, wherever x lies.
constexpr double inner = 1 - 0x1p-20, outer = 1 + 0x1p-20;

bool covers(const scene::Sphere& sphere, const ApparentBall& seen, const DirectionCone& cone) {
  return seen.distance >= sphere.radio * outer * outer && is_covered(cone, seen, sphere.radio / seen.distance * inner);
}

}  // namespace

LightCube::LightCube(const scene::Scene& scene, const glm::dvec3& light, std::span<const scene::ElementRef> elements,
                     const LightBufferOptions& options)
    : scene_(&scene), options_(options), light_(light), nodes_(6), records_{{{}, trace::no_limit, trace::no_limit}} {
  double reach = 0;
  for (const scene::ElementRef e : elements) {
    items_.push_back(item_of(scene, e, light));
    if (const double far = items_.back().seen.far; far < trace::no_limit) reach = std::max(reach, far);
  }
  const double close = 0x1p-25 * reach;
  longest_ = 0x1p29 * close;
  for (Item& item : items_) item.seen.around = item.seen.around || item.seen.near < close;
  std::ranges::stable_sort(items_, {}, [](const Item& item) { return item.seen.near; });
  build();
}

/// Adds a record for the nearest sphere in `seen` that covers the cone, and removes the elements that it hides. The
/// record.
std::uint32_t LightCube::end_at_cover(const DirectionCone& cone, Numbers& seen, std::uint32_t record) {
  for (const std::uint32_t number : seen) {
    const Item& item = items_[number];
    if (item.seen.near > records_[record].from) break;
    if (item.e.tipo != model::Tipo::soy_esfera) continue;
    const scene::Sphere& sphere = scene_->shapes<scene::Sphere>()[item.e.index];
    const double from = item.seen.distance * outer;
    if (from >= records_[record].from || !covers(sphere, item.seen, cone)) continue;
    records_.push_back({item.e, from, 0x1p31 * sphere.radio});
    record = static_cast<std::uint32_t>(records_.size() - 1);
  }
  const auto is_hidden = [&](std::uint32_t number) { return items_[number].seen.near > records_[record].from; };
  std::erase_if(seen, is_hidden);
  return record;
}

/// Whether all elements of a list are seen all around, or cover the square, which holds in every part of it too.
bool LightCube::is_settled(const Open& open) const {
  return std::ranges::all_of(open.seen, [&](std::uint32_t number) {
    return items_[number].seen.around || (open.record != 0 && items_[number].e == records_[open.record].e);
  });
}

LightCube::Open LightCube::open(std::uint32_t node, const Square& square, const Numbers& seen, std::uint32_t record,
                                std::uint32_t depth) {
  const DirectionCone cone = cone_of(square, widening);
  Open open{node, square, {}, record, depth};
  std::ranges::copy_if(seen, std::back_inserter(open.seen),
                       [&](std::uint32_t number) { return may_be_seen(items_[number].seen, cone); });
  if (options_.ends_at_cover) open.record = end_at_cover(cone, open.seen, record);
  depth_ = std::max(depth_, depth);
  return open;
}

/// Quarters the square of the longest list, the first made among equal ones, again and again.
void LightCube::build() {
  const auto is_after = [](const Open& a, const Open& b) {
    return a.seen.size() < b.seen.size() || (a.seen.size() == b.seen.size() && a.node > b.node);
  };
  std::vector<Open> heap;
  const auto push = [&](Open&& open) {
    heap.push_back(std::move(open));
    std::ranges::push_heap(heap, is_after);
  };
  Numbers all(items_.size());
  std::iota(all.begin(), all.end(), 0U);
  std::size_t references = 0;
  for (std::uint32_t face = 0; face < 6; ++face) {
    Open whole_face = open(face, whole(face), all, 0, 0);
    references += whole_face.seen.size();
    push(std::move(whole_face));
  }
  while (!heap.empty()) {
    std::ranges::pop_heap(heap, is_after);
    const Open longest = std::move(heap.back());
    heap.pop_back();
    if (!quarter_pays(longest, references, push)) close(longest);
  }
}

/// Makes the quarters of a square and hands them to push, if there is room and the quarters' lists gain something.
template <class Push>
bool LightCube::quarter_pays(const Open& whole, std::size_t& references, Push push) {
  const std::size_t before = whole.seen.size();
  if (whole.depth == deepest_square || nodes_.size() > 4 * most_quartered(items_.size()) || is_settled(whole))
    return false;
  std::array<Open, 4> parts;
  std::size_t after = 0;
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  for (std::uint32_t which = 0; which < 4; ++which) {
    parts[which] = open(first + which, quarter(whole.square, which), whole.seen, whole.record, whole.depth + 1);
    after += parts[which].seen.size();
  }
  const bool is_less = after < 4 * before || before <= few_seen;
  if (!is_less || references + after > most_references(items_.size())) return false;
  references += after - before;
  nodes_[whole.node] = {first, 0, whole.record, true};
  nodes_.resize(nodes_.size() + 4);
  for (Open& part : parts) push(std::move(part));
  return true;
}

void LightCube::close(const Open& open) {
  const auto first = static_cast<std::uint32_t>(references_.size());
  nodes_[open.node] = {first, static_cast<std::uint32_t>(open.seen.size()), open.record, false};
  references_.insert(references_.end(), open.seen.begin(), open.seen.end());
}

LightCube::List LightCube::list(const trace::Ray& ray) const {
  const CubePoint place = place_of(-ray.v);
  Square square = whole(place.face);
  const Node* node = &nodes_[place.face];
  while (node->is_quartered) {
    const std::uint32_t which = quarter_of(square, place);
    square = quarter(square, which);
    node = &nodes_[node->first + which];
  }
  return {{references_.data() + node->first, node->count}, records_[node->record]};
}

void LightCube::add_to(Size& size) const {
  const auto quartered = static_cast<std::size_t>(std::ranges::count_if(nodes_, &Node::is_quartered));
  size.nodes += quartered;
  size.cells += nodes_.size() - quartered;
  size.references += references_.size();
  size.depth = std::max<std::size_t>(size.depth, depth_);
  size.bytes += items_.size() * sizeof(Item) + nodes_.size() * sizeof(Node) + records_.size() * sizeof(Record) +
                references_.size() * sizeof(std::uint32_t);
}

LightBuffer::LightBuffer(const scene::Scene& scene, const LightBufferOptions& options) : LinearList(scene) {
  std::vector<scene::ElementRef> elements;
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    if (trace::ordinary(shape)) elements.push_back(e);
  });
  for (const scene::Light& light : scene.stage().lights)
    if (is_ordinary(light.position)) cubes_.emplace_back(scene, light.position, elements, options);
}

const LightCube* LightBuffer::cube_of(const trace::Ray& ray) const {
  const auto found = std::ranges::find_if(cubes_, [&](const LightCube& cube) { return cube.serves(ray); });
  return found == cubes_.end() ? nullptr : &*found;
}

bool LightBuffer::is_certainly_occluded(const trace::Ray& ray, scene::Origin en) const {
  const LightCube* const cube = ray.ordinary ? cube_of(ray) : nullptr;
  if (cube == nullptr) return false;
  const LightCube::Record& record = cube->list(ray).record;
  return record.from <= ray.length() && ray.length() * outer <= record.to && !en.contains(record.e);
}

Size LightBuffer::size() const {
  Size size = LinearList::size();
  for (const LightCube& cube : cubes_) cube.add_to(size);
  return size;
}

}  // namespace durero::accel
