#include "durero/scene/scene.hpp"

#include <stdexcept>
#include <utility>

#include "durero/model/malla.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/stage.hpp"

namespace durero::scene {

const Label& Scene::label(ElementRef element) const noexcept {
  return with_shape(element.tipo, [&]<class Shape>(std::type_identity<Shape>) -> const Label& {
    return table<Shape>().labels[element.index];
  });
}

Label& Scene::label(ElementRef element) noexcept { return const_cast<Label&>(std::as_const(*this).label(element)); }

std::optional<Meshes::Face> Scene::face(ElementRef element) const noexcept {
  if (!is_face(element)) return std::nullopt;
  return meshes_.face(element.index - table<Triangle>().size());
}

// A face of a mesh has a name: Mallas.inv.1.
model::Elemento Scene::name(ElementRef element) const {
  if (const auto of = face(element)) return model::nombre_cara(of->mesh.m, of->number).value();
  return label(element).name;
}

std::optional<ElementRef> Scene::find(std::string_view text, NameIndex::hash_type hash) const noexcept {
  if (const auto single = index_.find(hash, [&](ElementRef place) { return label(place).name.name() == text; }))
    return single;
  const auto number = meshes_.find_face(text);
  if (!number) return std::nullopt;
  return ElementRef{Triangle::tipo, table<Triangle>().size() + *number};
}

std::optional<ElementRef> Scene::find(std::string_view text) const noexcept {
  return find(text, NameIndex::hash(text));
}

std::optional<std::uint32_t> Scene::material(ElementRef element) const noexcept {
  const auto of = face(element);
  const std::uint32_t material = of ? of->mesh.material : label(element).material;
  if (material == no_material) return std::nullopt;
  return material;
}

void Scene::set_material(ElementRef element, std::optional<std::uint32_t> material) {
  require_single(element);
  if (material && *material >= stage().materials.size()) throw std::out_of_range("no such material");
  label(element).material = material.value_or(no_material);
}

void Scene::require_single(ElementRef element) const {
  if (is_face(element)) throw std::domain_error("a face has the looks of its mesh");
}

template <class Attribute>
const Attribute* Scene::rare(ElementRef element, std::optional<Attribute> RareAttributes::*which) const noexcept {
  if (is_face(element)) return nullptr;
  const auto& held = label(element).rare;
  return held && (*held).*which ? &*((*held).*which) : nullptr;
}

template <class Attribute>
void Scene::set_rare(ElementRef element, std::optional<Attribute> RareAttributes::*which,
                     const std::optional<Attribute>& value) {
  require_single(element);
  const auto& held = label(element).rare;
  RareAttributes all = held ? *held : RareAttributes{};
  all.*which = value;
  label(element).rare = std::make_shared<const RareAttributes>(all);
}

std::optional<Wrap> Scene::wrap(ElementRef element) const {
  if (const auto of = face(element)) {
    if (of->mesh.uv.empty()) return std::nullopt;
    const auto [i, j, k] = of->mesh.caras[of->number];
    return Wrap{{of->mesh.uv[i], of->mesh.uv[j], of->mesh.uv[k]}};
  }
  const Wrap* const held = rare(element, &RareAttributes::wrap);
  return held == nullptr ? std::nullopt : std::optional(*held);
}

void Scene::set_wrap(ElementRef element, const Wrap& wrap) {
  if (element.tipo != model::Tipo::soy_triangulo) throw std::domain_error("textures are laid on triangles alone");
  set_rare<Wrap>(element, &RareAttributes::wrap, wrap);
}

std::optional<VertexNormals> Scene::vertex_normals(ElementRef element) const noexcept {
  if (const auto of = face(element)) {
    if (of->mesh.normals.empty()) return std::nullopt;
    const auto [i, j, k] = of->mesh.caras[of->number];
    return VertexNormals{of->mesh.normals[i], of->mesh.normals[j], of->mesh.normals[k]};
  }
  const VertexNormals* const held = rare(element, &RareAttributes::normals);
  return held == nullptr ? std::nullopt : std::optional(*held);
}

void Scene::set_vertex_normals(ElementRef element, const VertexNormals& normals) {
  if (element.tipo != model::Tipo::soy_triangulo) throw std::domain_error("triangles alone have normals at vertices");
  if (!have_directions(normals)) throw std::domain_error("a normal has no direction");
  set_rare<VertexNormals>(element, &RareAttributes::normals, normals);
}

const glm::dvec3* Scene::motion(ElementRef element) const noexcept { return rare(element, &RareAttributes::motion); }

void Scene::set_motion(ElementRef element, const glm::dvec3& motion) {
  using Motion = std::optional<glm::dvec3>;
  set_rare<glm::dvec3>(element, &RareAttributes::motion, motion == glm::dvec3(0) ? Motion() : Motion(motion));
}

const Body* Scene::body(ElementRef element) const noexcept {
  const auto* const held = rare(element, &RareAttributes::body);
  return held == nullptr ? nullptr : held->get();
}

void Scene::set_body(ElementRef element, Body body) {
  if (element.tipo != Sphere::tipo) throw std::domain_error("a body stands in the tables as a sphere");
  set_rare<std::shared_ptr<const Body>>(element, &RareAttributes::body, std::make_shared<const Body>(std::move(body)));
}

bool Scene::has_bodies() const noexcept {
  const auto spheres = static_cast<std::uint32_t>(shapes<Sphere>().size());
  for (std::uint32_t i = 0; i < spheres; ++i)
    if (body({Sphere::tipo, i}) != nullptr) return true;
  return false;
}

void Scene::audit() {
  audits_are_put_off_ = false;
  if (!contract::evaluated(contract::cost::audit)) return;
  auto state = std::make_shared<const model::Escena>(retrieve(*this));
  model::check(model::inv(*state), contract::cost::audit);
  audited_ = std::move(state);
}

model::Answer Scene::apply_total(const Edit& edit) {
  if (edit.material && *edit.material >= stage().materials.size()) throw std::out_of_range("no such material");
  const model::Answer answer = apply_total(edit.operation);
  if (answer.ok() && edit.material) set_material(find(name_of(edit.operation).name()).value(), edit.material);
  return answer;
}

template <class Shape>
model::Answer Scene::add(const model::Elemento& e, const Shape& shape, std::optional<std::uint32_t> material) {
  return apply_total(Edit{addition(e, shape), material});
}

using OfMaterial = std::optional<std::uint32_t>;
template model::Answer Scene::add(const model::Elemento&, const Sphere&, OfMaterial);
template model::Answer Scene::add(const model::Elemento&, const Cylinder&, OfMaterial);
template model::Answer Scene::add(const model::Elemento&, const Cone&, OfMaterial);
template model::Answer Scene::add(const model::Elemento&, const TruncatedCone&, OfMaterial);
template model::Answer Scene::add(const model::Elemento&, const Plane&, OfMaterial);
template model::Answer Scene::add(const model::Elemento&, const Disc&, OfMaterial);
template model::Answer Scene::add(const model::Elemento&, const Triangle&, OfMaterial);

}  // namespace durero::scene
