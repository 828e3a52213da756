#pragma once
/// A solid made of solids, as a ray meets it: exactly, from face to face (spec/solidos.tex).

#include <memory>
#include <vector>

#include "durero/composed/figure.hpp"
#include "durero/composed/form.hpp"
#include "durero/composed/side_tree.hpp"

namespace durero::composed {

class SolidFace;

/// The surface of a solid (superficie.def.1), and its body along rays.
class SolidFigure final : public Figure {
 public:
  /// Precondition: every part bounds a solid.
  explicit SolidFigure(const scene::Compound& solid);
  ~SolidFigure() override;
  SolidFigure(const SolidFigure&) = delete;
  SolidFigure& operator=(const SolidFigure&) = delete;

  /// The first point on the surface; no_minimum where the ray runs along it from its origin on. A ray that starts on
  /// the solid starts on every face that may hold at a point whose rounding its origin is (superficie_desde.def.1).
  First first(const model::Rayo& rayo, bool on) const override;
  std::optional<std::vector<Parameter>> parameters(const model::Rayo& rayo, bool on,
                                                   surface::exact::RayStretch stretch) const override;
  bool may_meet(const model::Rayo& rayo, bool on) const override;
  surface::Box box() const override { return box_; }
  glm::dvec3 normal(const glm::dvec3& point) const override;

  /// The stretches of the ray in the body (cuerpo.def.1), ascending and apart from each other. A point alone begins
  /// where it ends.
  std::vector<surface::exact::Segment> inside(const model::Rayo& rayo, bool on) const;

  /// The number of surfaces that its faces lie on.
  std::size_t size() const;

 private:
  /// The inside of a face, which becomes one of faces_ if none is a multiple of it.
  SideTree side_of(const SpaceForm<Dyadic>& form);
  SideTree tree_of(const scene::Body& body);
  SideTree tree_of(const scene::Instance& instance);
  SideTree tree_of(const scene::Compound& solid);

  std::vector<std::uint8_t> starts(const model::Rayo& rayo, bool on) const;

  std::vector<SolidFace> faces_;
  SideTree tree_;
  surface::Box box_;
};

}  // namespace durero::composed
