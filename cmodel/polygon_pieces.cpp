// SPDX-License-Identifier: Apache-2.0
#include "polygon_pieces.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "fixed.hpp"

namespace halfspace {
namespace {

constexpr std::size_t kMostVertices = Pieces::kMost + 2;

// Above 0 when a, b, c turn clockwise as seen with y down. |differences| <= 2^29: fits 60 bits.
std::int64_t turn(const Point& a, const Point& b, const Point& c) {
  const std::int64_t ux = std::int64_t{b.x} - a.x, uy = std::int64_t{b.y} - a.y;
  const std::int64_t vx = std::int64_t{c.x} - a.x, vy = std::int64_t{c.y} - a.y;
  return ux * vy - uy * vx;
}

// The polygon from its least vertex on, in the direction in which its area is positive, without
// equal neighbours.
class Ring {
 public:
  explicit Ring(std::span<const Point> points) : points_(points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (count_ == 0 || at(count_ - 1) != points[i]) place_[count_++] = i;
    }
    while (count_ > 1 && at(count_ - 1) == at(0)) --count_;
    if (area() < 0) {
      std::reverse(place_.begin(), end());
      reversed_ = true;
    }
    begin_at_least();
  }

  bool reversed() const { return reversed_; }
  std::size_t count() const { return count_; }
  std::size_t place(std::size_t i) const { return place_[i % count_]; }
  const Point& at(std::size_t i) const { return points_[place(i)]; }
  void remove(std::size_t i) {
    std::copy(place_.begin() + static_cast<std::ptrdiff_t>(i) + 1, end(),
              place_.begin() + static_cast<std::ptrdiff_t>(i));
    --count_;
  }

  std::int64_t area() const {  // doubled; eight turns: fits 63 bits
    std::int64_t sum = 0;
    for (std::size_t i = 1; i + 1 < count_; ++i) sum += turn(at(0), at(i), at(i + 1));
    return sum;
  }

 private:
  std::array<std::size_t, kMostVertices>::iterator end() {
    return place_.begin() + static_cast<std::ptrdiff_t>(count_);
  }
  // Rotates so that the vertices, read from the first on, are the least of all rotations.
  void begin_at_least() {
    std::size_t best = 0;
    const auto before = [this](std::size_t a, std::size_t b) {
      for (std::size_t n = 0; n < count_; ++n) {
        const Point& p = at(a + n);
        const Point& q = at(b + n);
        if (p != q) return std::tie(p.x, p.y) < std::tie(q.x, q.y);
      }
      return false;
    };
    for (std::size_t i = 1; i < count_; ++i) {
      if (before(i, best)) best = i;
    }
    std::rotate(place_.begin(), place_.begin() + static_cast<std::ptrdiff_t>(best), end());
  }

  std::span<const Point> points_;
  std::array<std::size_t, kMostVertices> place_{};
  std::size_t count_ = 0;
  bool reversed_ = false;
};

class Cutter {
 public:
  explicit Cutter(std::span<const Point> points) : points_(points), ring_(points) {}

  Pieces run() {
    if (ring_.count() < 3 || ring_.area() == 0) return {};
    cut();
    if (ring_.reversed()) {
      for (Piece& piece : std::span(pieces_.piece)) std::swap(piece[1], piece[2]);
    }
    return pieces_;
  }

 private:
  void cut() {
    for (std::size_t apex = 0; apex < ring_.count(); ++apex) {
      if (fan(apex)) return;
    }
    pieces_ = {};
    Ring left = ring_;
    while (left.count() >= 3 && cut_ear(left)) continue;
    if (left.count() < 3) return;
    add_largest([this](const Piece& piece) { return is_inside(piece); });
    add_largest([this](const Piece& piece) { return winding_at_middle(piece) > 0; });
  }

  // All pieces around one vertex; false when one of them faces away or covers another.
  bool fan(std::size_t apex) {
    pieces_ = {};
    for (std::size_t i = 1; i + 1 < ring_.count(); ++i) {
      const std::int64_t area = turn(ring_.at(apex), ring_.at(apex + i), ring_.at(apex + i + 1));
      if (area < 0) return false;
      if (area == 0) continue;
      const Piece piece{ring_.place(apex), ring_.place(apex + i), ring_.place(apex + i + 1)};
      if (!is_apart(piece)) return false;
      pieces_.add(piece);
    }
    return true;
  }

  // Always there when no edges cross, until what is left has no area.
  bool cut_ear(Ring& left) {
    for (std::size_t i = 0; i < left.count(); ++i) {
      const std::size_t before = i + left.count() - 1;
      if (turn(left.at(before), left.at(i), left.at(i + 1)) <= 0) continue;
      const Piece ear{left.place(before), left.place(i), left.place(i + 1)};
      if (!is_inside(ear) || !is_apart(ear)) continue;
      pieces_.add(ear);
      left.remove(i);
      return true;
    }
    return false;
  }

  // What is apart from all before of the triangles that may be taken, the largest first.
  template <class May>
  void add_largest(const May& may) {
    const std::size_t n = ring_.count();
    while (pieces_.count < Pieces::kMost) {
      std::int64_t largest = 0;
      Piece best{};
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
          for (std::size_t k = j + 1; k < n; ++k) {
            const std::int64_t area = turn(ring_.at(i), ring_.at(j), ring_.at(k));
            const Piece piece{ring_.place(i), ring_.place(j), ring_.place(k)};
            if (area <= largest || !is_apart(piece) || !may(piece)) continue;
            largest = area;
            best = piece;
          }
        }
      }
      if (largest == 0) return;
      pieces_.add(best);
    }
  }

  const Point& point(const Piece& piece, std::size_t i) const { return points_[piece[i % 3]]; }

  // No edge passes through the piece, and the polygon goes around it.
  bool is_inside(const Piece& piece) const {
    for (std::size_t i = 0; i < ring_.count(); ++i) {
      if (passes(piece, ring_.at(i), ring_.at(i + 1))) return false;
    }
    return winding_at_middle(piece) > 0;
  }

  // A segment stays out of a triangle when an edge has both its ends on the outer side, or when the
  // triangle lies on one side of it.
  bool passes(const Piece& piece, const Point& from, const Point& to) const {
    bool left = true, right = true;
    for (std::size_t e = 0; e < 3; ++e) {
      const Point &a = point(piece, e), &b = point(piece, e + 1);
      if (turn(a, b, from) <= 0 && turn(a, b, to) <= 0) return false;
      left = left && turn(from, to, a) >= 0;
      right = right && turn(from, to, a) <= 0;
    }
    return !left && !right;
  }

  // How often the polygon goes around the piece's middle, in thirds of a subpixel. On an edge,
  // which only a piece that an edge passes through may be: around one side of it.
  int winding_at_middle(const Piece& piece) const {
    const auto sum = [&](auto axis) {
      return std::int64_t{point(piece, 0).*axis} + point(piece, 1).*axis + point(piece, 2).*axis;
    };
    const std::int64_t x = sum(&Point::x), y = sum(&Point::y);
    int winding = 0;
    for (std::size_t i = 0; i < ring_.count(); ++i) {
      const Point &a = ring_.at(i), &b = ring_.at(i + 1);
      const std::int64_t ay = 3 * std::int64_t{a.y} - y, by = 3 * std::int64_t{b.y} - y;
      if ((ay <= 0) == (by <= 0)) continue;
      const std::int64_t ax = 3 * std::int64_t{a.x} - x, bx = 3 * std::int64_t{b.x} - x;
      // |ax|, |ay|, ... <= 3 2^29 < 2^31: a product of two fits 62 bits.
      const std::int64_t side = ax * by - ay * bx;
      if (ay <= 0 && side > 0) ++winding;
      if (ay > 0 && side < 0) --winding;
    }
    return winding;
  }

  // Two triangles share no inner point when an edge of one has the other on its outer side.
  bool is_parted(const Piece& a, const Piece& b) const {
    for (std::size_t e = 0; e < 3; ++e) {
      bool outside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        outside = outside && turn(point(a, e), point(a, e + 1), point(b, i)) <= 0;
      }
      if (outside) return true;
    }
    return false;
  }
  bool is_apart(const Piece& piece) const {
    return std::all_of(pieces_.all().begin(), pieces_.all().end(), [&](const Piece& other) {
      return is_parted(piece, other) || is_parted(other, piece);
    });
  }

  std::span<const Point> points_;
  Ring ring_;
  Pieces pieces_;
};

}  // namespace

Pieces polygon_pieces(std::span<const Point> ring) {
  HS_CHECK(ring.size() >= 3 && ring.size() <= kMostVertices);
  return Cutter(ring).run();
}

}  // namespace halfspace
