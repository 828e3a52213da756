#include "durero/accel/classification.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "accel/finite_box.hpp"
#include "durero/accel/coherence.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

static_assert(Structure<Classification>);

/// The length of a list that is not divided.
constexpr std::size_t short_list = 4;

/// A bound on the angle by which the rounding of u and v turns a direction.
constexpr double turned = 0x1p-50;

/// The number of times that a box of so many elements is halved, in space and directions together: if no list were
/// shorter than the list that it is made from, there would be 2²⁴ entries in all.
std::uint32_t most_halvings(std::size_t elements) {
  std::uint32_t halvings = 0;
  while (elements << halvings < (std::size_t{1} << 22U) && halvings < 24) ++halvings;
  return halvings;
}

double longest_side(const surface::Box& box) {
  const glm::dvec3 sides = box.high - box.low;
  return std::max({sides.x, sides.y, sides.z});
}

int longest_axis(const surface::Box& box) {
  const glm::dvec3 sides = box.high - box.low;
  return sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
}

}  // namespace

/// A box of five dimensions. Its children are the quarters of its square, or the halves, 0 and 1, of its box of space.
struct Classification::Node {
  surface::Box box;
  Square square;
  std::uint32_t halvings;
  bool halves_space;
  std::vector<Entry> list{};
  mutable std::array<std::atomic<Node*>, 4> children{};

  Node(const surface::Box& place, const Square& directions, std::uint32_t so_often, double whole_side)
      : box(place),
        square(directions),
        halvings(so_often),
        halves_space(longest_side(place) * 2 >= directions.side * whole_side) {}
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  ~Node() {
    for (const std::atomic<Node*>& each : children) delete each.load();
  }

  double middle() const {
    const int axis = longest_axis(box);
    return 0.5 * box.low[axis] + 0.5 * box.high[axis];
  }
};

Classification::Classification(const scene::Scene& scene) : scene_(&scene) {
  bounds_ = {glm::dvec3(trace::no_limit), glm::dvec3(-trace::no_limit)};
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    const auto box = finite_box(scene, e);
    if (!box) return extraordinary_.push_back(e);
    bounds_ = {glm::min(bounds_.low, box->low), glm::max(bounds_.high, box->high)};
    elements_.push_back(e);
    balls_.push_back(surface::ball(shape));
    boxes_.push_back(*box);
  });
  if (elements_.empty()) return;
  reach_ = glm::length(bounds_.high - bounds_.low);
  const glm::dvec3 farthest = glm::max(glm::abs(bounds_.low), glm::abs(bounds_.high));
  margin_ = 0x1p-30 * reach_ + 0x1p-45 * (farthest.x + farthest.y + farthest.z);
  most_halvings_ = most_halvings(elements_.size());
  std::vector<Entry> all;
  for (std::uint32_t number = 0; number < elements_.size(); ++number) all.push_back({number, 0});
  for (std::uint32_t face = 0; face < 6; ++face) {
    roots_[face] = std::make_unique<Node>(bounds_, whole(face), 0, longest_side(bounds_));
    make_list(*roots_[face], all);
  }
}

Classification::~Classification() = default;

/// The half diagonal is increased by its own rounding; the margin pays also for the rounding of the middle.
void Classification::make_list(Node& node, std::span<const Entry> of_parent) const {
  const glm::dvec3 middle = 0.5 * node.box.low + 0.5 * node.box.high;
  const double half = 0.5 * glm::length(node.box.high - node.box.low) * (1 + 0x1p-40) + margin_;
  const DirectionCone cone = cone_of(node.square, turned);
  for (const Entry& entry : of_parent) {
    const ApparentBall grown = seen_from_within({middle, half}, balls_[entry.number]);
    if (may_be_seen(grown, cone)) node.list.push_back({entry.number, grown.near});
  }
  std::ranges::stable_sort(node.list, {}, &Entry::near);
}

bool Classification::is_leaf(const Node& node) const {
  return node.list.size() <= short_list || node.halvings >= most_halvings_;
}

std::unique_ptr<Classification::Node> Classification::child(const Node& node, std::uint32_t which) const {
  surface::Box box = node.box;
  if (node.halves_space) (which == 0 ? box.high : box.low)[longest_axis(node.box)] = node.middle();
  auto made = std::make_unique<Node>(box, node.halves_space ? node.square : quarter(node.square, which),
                                     node.halvings + (node.halves_space ? 1 : 2), longest_side(bounds_));
  make_list(*made, node.list);
  return made;
}

std::span<const Classification::Entry> Classification::list(const glm::dvec3& place, const trace::Ray& ray,
                                                            Work& work) const {
  const CubePoint towards = place_of(ray.v);
  const Node* node = roots_[towards.face].get();
  while (!is_leaf(*node)) {
    ++work.nodes;
    const std::uint32_t which = node->halves_space ? (place[longest_axis(node->box)] < node->middle() ? 0 : 1)
                                                   : quarter_of(node->square, towards);
    std::atomic<Node*>& slot = node->children[which];
    Node* next = slot.load(std::memory_order_acquire);
    if (next == nullptr) {
      auto made = child(*node, which);
      if (slot.compare_exchange_strong(next, made.get(), std::memory_order_acq_rel)) next = made.release();
    }
    node = next;
  }
  ++work.cells;
  return node->list;
}

/// The start lies before the computed entry by 2⁻⁴⁰ of it, because the entry errs by less than 2⁻⁴⁸ of itself. The
/// ray's own point at t therefore lies before the box, and so near to the box and to the place that the margin, which
/// is more than 2⁻³⁸·t·|v| and the roundings of the place, contains it. Where the ray misses the box, any place serves.
/// Nothing where t·|v| is too long for the margin.
std::optional<Classification::Start> Classification::start(const trace::Ray& ray, const Beam& beam,
                                                           const BoxInterval& stretch) const {
  if (stretch.entry == 0) return Start{0, ray.p};
  const double t = stretch.entry * (1 - 0x1p-40);
  if (!(t * ray.length() <= 0x1p8 * reach_)) return std::nullopt;
  return Start{t, glm::clamp(beam.p + t * ray.v, bounds_.low, bounds_.high)};
}

Size Classification::size() const {
  const std::size_t ball = sizeof(scene::ElementRef) + sizeof(surface::Ball) + sizeof(surface::Box);
  Size size{.elements = elements_.size(),
            .apart = extraordinary_.size(),
            .bytes = elements_.size() * ball + extraordinary_.size() * sizeof(scene::ElementRef)};
  std::vector<const Node*> left;
  for (const auto& root : roots_)
    if (root) left.push_back(root.get());
  while (!left.empty()) {
    const Node& node = *left.back();
    left.pop_back();
    const bool is_cell = is_leaf(node);
    ++(is_cell ? size.cells : size.nodes);
    size.references += node.list.size();
    size.depth = std::max<std::size_t>(size.depth, node.halvings);
    size.bytes += sizeof(Node) + node.list.size() * sizeof(Entry);
    for (const std::atomic<Node*>& each : node.children)
      if (const Node* const below = each.load(std::memory_order_acquire)) left.push_back(below);
  }
  return size;
}

}  // namespace durero::accel
