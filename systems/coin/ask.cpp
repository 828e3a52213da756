// Asks Coin by SoRayPickAction of one SoIndexedFaceSet.
#include "../ask.hpp"

#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/details/SoFaceDetail.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoSeparator.h>

using namespace ask;

static SbVec3f sb(const Vec& a) { return {float(a[0]), float(a[1]), float(a[2])}; }

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of), root_(new SoSeparator) {
    const Mesh mesh = mesh_of(of);
    auto* points = new SoCoordinate3;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) points->point.set1Value(int(i), sb(mesh.points[i]));
    auto* faces = new SoIndexedFaceSet;
    int place = 0;
    for (const auto& face : mesh.faces) {
      for (unsigned i : face) faces->coordIndex.set1Value(place++, int(i));
      faces->coordIndex.set1Value(place++, SO_END_FACE_INDEX);
    }
    root_->ref();
    root_->addChild(points);
    root_->addChild(faces);
  }
  ~Asked() { root_->unref(); }

  void ask(const Ray& ray) const {
    SoRayPickAction action(SbViewportRegion(1, 1));
    action.setRay(sb(ray.p), sb(unit(ray.v)), 0);  // without a least distance, what is behind the origin is picked, too
    action.apply(root_);
    const SoPickedPoint* met = action.getPickedPoint();
    if (met == nullptr) return miss();
    const SbVec3f& place = met->getPoint();
    const int face = static_cast<const SoFaceDetail*>(met->getDetail())->getFaceIndex();
    hit_at(of_->elements[std::size_t(face)].name, {place[0], place[1], place[2]});
  }

 private:
  const Scene* of_;
  SoSeparator* root_;
};

int main() {
  SoDB::init();
  return answer(SoDB::getVersion(), [](const Scene& scene) { return Asked(scene); });
}
