// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../camera.hpp"
#include "mesh.hpp"

namespace halfspace {

// The mesh with fewer triangles, each vertex kept or gone: meshoptimizer's edge collapses, up to
// an error of `world` units as it measures it (the distance to the planes of what was collapsed:
// an estimate, not a bound). Normals and colours stay with their vertices. The result has at
// least one triangle. Throws Error(kFitTool) in a build without meshoptimizer.
void simplify(Mesh& mesh, double world);

// World units that a pixel spans at the camera's near plane.
double pixel_size(const Camera& camera, int frame_height);

}  // namespace halfspace
