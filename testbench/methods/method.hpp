// SPDX-License-Identifier: Apache-2.0
//
// The gallery: every method of rasterization this project compares itself with, behind one
// interface. Each is in its textbook form with its variants beside it; all sample at pixel centres.
// They are references and comparators, not stages. Pages: docs/05_methods.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "camera.hpp"
#include "canvas.hpp"

namespace halfspace::methods {

// A position in pixels: x right, y down, origin at the frame's top-left corner. Any double.
struct Position {
  double x = 0;
  double y = 0;
  bool operator==(const Position&) const = default;
};

// A projected vertex, not snapped. z is window depth 0..1, linear on the screen; w is the clip
// coordinate (1 where there is no perspective).
struct Vertex {
  double x = 0;
  double y = 0;
  double z = 0.5;
  double w = 1;
  Color color{};
  Position position() const { return {x, y}; }
};
using Facet = std::array<Vertex, 3>;  // a triangle; either winding

// Rings of a polygon, the last vertex joined to the first. A point is inside when a ray from it
// crosses the rings an odd number of times: outer rings and holes need no order.
struct Polygon {
  std::vector<std::vector<Position>> rings;
};

struct Segment {
  Position from;
  Position to;
};

// A vertex before the division by w; OpenGL's clip volume, attributes as Vertex::color.
struct ClipPoint {
  glm::dvec4 position{0.0};
  Color color{};
};
using ClipFacet = std::array<ClipPoint, 3>;

// A vertex in the world, and what is seen of it.
struct WorldPoint {
  glm::dvec3 position{0.0};
  Color color{};
};
using WorldFacet = std::array<WorldPoint, 3>;
struct View {
  Camera camera;
  int width = 0;  // of the frame, px; the canvas may show a part
  int height = 0;
};

// One primitive onto the canvas. None throws, none reads beyond its input; coordinates that are not
// finite draw nothing or something wrong, as the method has it.
using DrawFacet = std::function<void(const Facet&, Canvas&)>;
using DrawPolygon = std::function<void(const Polygon&, Canvas&)>;
using DrawSegment = std::function<void(const Segment&, Canvas&)>;
using DrawClip = std::function<void(const ClipFacet&, const View&, Canvas&)>;
using DrawWorld = std::function<void(const WorldFacet&, const View&, Canvas&)>;
using Draw = std::variant<DrawFacet, DrawPolygon, DrawSegment, DrawClip, DrawWorld>;

// One edge of a triangle at a pixel's centre, as a method computes it, errors and all; px^2.
struct OwnEdge {
  double raw = 0;                // inside positive
  std::optional<double> biased;  // with the tie rule in it, where the method has a bias
  bool passes = false;           // the method takes the centre for inside
};
// Edges from vertex i to vertex (i + 1) mod 3 of the facet as given; nothing for a facet that the
// method does not draw. The centre of pixel (x, y) is hit exactly when all three pass.
using OwnEdges = std::optional<std::array<OwnEdge, 3>>;
using EdgesAt = std::function<OwnEdges(const Facet&, int x, int y)>;

// What a method takes, in the order of Draw.
enum class InputKind { kTriangles, kPolygons, kLines, kClipSpace, kWorld };

// Who owns a sample exactly on an edge.
enum class Rule {
  kTopLeft,     // the triangle at whose left or top it lies
  kDrawTies,    // every triangle that touches it
  kSkipTies,    // nobody
  kHalfOpen,    // spans closed at the left and top, open at the right and bottom
  kOffscreen,   // the triangle on the side of an off-screen point
  kUnspecified  // whatever the rounding gives
};

struct Method {
  std::string name;        // unique, lower case with underscores
  int row = 0;             // 1..18, the method's row in docs/05_methods/README.md
  std::string family;      // the page in docs/05_methods, without .md
  std::string title;       // one line: what it is and what this variant changes
  std::string source;      // author and title
  std::string complexity;  // per primitive
  std::string use;         // when to use it
  std::string fails;       // when it fails; empty: never, for the vertices it takes
  Rule rule = Rule::kUnspecified;
  std::string precision;    // "float", "double", "fixed" ...
  int subpixel_bits = -1;   // vertices are snapped to 2^-bits px first; -1: taken as they are
  bool exact = false;       // 0 wrong samples, whatever the input, against the oracle on vertices
                            // that are multiples of 2^-8 px (2^-subpixel_bits when given) in
                            // +-2^14 px; polygons without self-intersection, lines: nearest pixel
  bool attributes = false;  // calls Canvas::fragment()
  Draw draw;
  EdgesAt edges;  // null: it has no edge values, or they depend on more than the pixel

  InputKind input() const { return static_cast<InputKind>(draw.index()); }
};

// Every method, by row and then as its page lists it. Built at the first call; thread-safe.
std::span<const Method> all();

// The method of that name, or null.
const Method* find(std::string_view name);

const char* input_name(InputKind kind);
const char* rule_name(Rule rule);

// The same geometry in every form that a method may take. Make one from triangles, or fill it.
struct Drawing {
  View view;
  std::vector<Facet> facets;
  std::vector<Polygon> polygons;
  std::vector<Segment> segments;
  std::vector<ClipFacet> clip;
  std::vector<WorldFacet> world;
  // Which of the triangles given each facet and polygon is, or is a piece of; never falls. Made by
  // drawing_of().
  std::vector<std::uint32_t> origin;
};

// Window-space triangles in all forms: each triangle is also a polygon of one ring and three
// segments; in clip space it has its own w; in the world it lies before an orthographic camera.
// width, height: the frame, px.
Drawing drawing_of(std::span<const Facet> facets, int width, int height);

// Triangles in clip space in all forms but the world's: they are clipped to near, far and a guard
// band before they become triangles, polygons and segments of the window.
Drawing drawing_of(std::vector<ClipFacet> clip, int width, int height);

// Draws all primitives of the method's kind in order, or until the canvas is exhausted.
void draw(const Method& method, const Drawing& drawing, Canvas& canvas);
// The same; `after` is called after each primitive with its index.
using AfterPrimitive = std::function<void(std::size_t)>;
void draw(const Method& method, const Drawing& drawing, Canvas& canvas,
          const AfterPrimitive& after);

// How many of them there are.
std::size_t primitives(const Method& method, const Drawing& drawing);

// Which of the triangles that the drawing was made of primitive i is, or is a part of.
std::size_t triangle_of(InputKind kind, const Drawing& drawing, std::size_t i);

}  // namespace halfspace::methods
