#pragma once
/// Files of distances. As JSON lines, in the order of the points:
///
///   {"point":0,"count":"one","elementos":["a"],"distance":4,"nearest":[0,0,4]}
///   {"point":1,"count":"many","elementos":["a","b"],"distance":1,"nearest":[-1,0,0]}
///   {"point":2,"count":"none","elementos":[]}
///
/// `count` says how many points of the scene are nearest; of many, `nearest` is the first by x, y, z. `elementos`
/// ascends by the bytes of the names. Where one element was asked about that is closed, `signed` is its distance with
/// the sign. A value whose rounding is infinite is the string "inf" or "-inf".
///
/// As .npy, one record a point: dtype [('count','S4'),('distance','<f8'),('nearest','<f8',(3,)),('elementos','S…')]; of
/// none the numbers are NaN; the names stand in `elementos` separated by commas.

#include <optional>
#include <span>
#include <string>

#include "durero/scene/proximity.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// The word of a count in files.
std::string_view word(scene::NearestCount count);

/// One line of JSON, without line end. `with_sign`: the distance of the element asked about, where it is closed.
std::string proximity_text(std::size_t point, const scene::Proximity& proximity, const scene::Scene& scene,
                           std::optional<double> with_sign = {});

/// The .npy file of the answers for all points.
std::string proximities_npy(std::span<const scene::Proximity> proximities, const scene::Scene& scene);

}  // namespace durero::io
