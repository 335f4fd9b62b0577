// SPDX-License-Identifier: Apache-2.0
//
// Who contributes to methods::all(): one function a file, each appending its variants.
#pragma once

#include <vector>

#include "method.hpp"

namespace halfspace::methods {

void add_lines(std::vector<Method>& list);              // row 1
void add_edge_walk(std::vector<Method>& list);          // row 2
void add_edge_function(std::vector<Method>& list);      // row 3
void add_speed_hacks(std::vector<Method>& list);        // row 4
void add_fill_rules(std::vector<Method>& list);         // row 5
void add_plane_equation(std::vector<Method>& list);     // row 6
void add_barycentric(std::vector<Method>& list);        // row 7
void add_reference_point(std::vector<Method>& list);    // row 8
void add_scaled_line(std::vector<Method>& list);        // row 9
void add_tiled(std::vector<Method>& list);              // row 10
void add_mask_table(std::vector<Method>& list);         // row 11
void add_warnock(std::vector<Method>& list);            // row 12
void add_micropolygons(std::vector<Method>& list);      // row 12
void add_parity_scan(std::vector<Method>& list);        // row 13
void add_active_edge_table(std::vector<Method>& list);  // row 13
void add_decomposition(std::vector<Method>& list);      // row 14
void add_constrained(std::vector<Method>& list);        // row 14, only with CGAL
void add_shading(std::vector<Method>& list);            // row 15
void add_projection(std::vector<Method>& list);         // row 16
void add_clipping(std::vector<Method>& list);           // row 17
void add_pipeline(std::vector<Method>& list);           // row 18

// Where the methods come from. The lecture notes by author and title.
inline constexpr const char* kLuebke =
    "D. Luebke, CS 445/645 Introduction to Computer Graphics, Drawing Triangles, 2003";
inline constexpr const char* kMao = "Mao A., Computer Graphics, CH6 Rasterization";
inline constexpr const char* kDrawing =
    "Drawing Triangles (lecture notes in prose, after CMU 15-462)";
inline constexpr const char* kShinar =
    "T. Shinar, CS 130 Computer Graphics, Rasterizing Triangles and Graphics Pipeline, UC "
    "Riverside";
inline constexpr const char* kPolygons =
    "Polygons and Modern Rasterization (lecture notes, slides)";
inline constexpr const char* kPineda =
    "J. Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988";

}  // namespace halfspace::methods
