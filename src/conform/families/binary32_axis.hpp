#pragma once
/// Unit vectors of binary32 numbers.

#include <glm/vec3.hpp>

namespace durero::conform {

/// A vector d of binary32 numbers with |d·d − 1| ≤ 2⁻⁵⁰ near the given one, whose length is about 1; opposite vectors
/// have opposite ones, and a coordinate that is 0 stays 0.
glm::dvec3 binary32_axis(const glm::dvec3& near);

}  // namespace durero::conform
