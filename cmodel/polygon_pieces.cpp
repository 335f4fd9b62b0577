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
    while (ring_.count() >= 3) {
      if (!cut_flat() && !cut_ear(true) && !cut_ear(false)) ring_.remove(most_reflex());
    }
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

  // A vertex between two others, or at the end of a spike.
  bool cut_flat() {
    for (std::size_t i = 0; i < ring_.count(); ++i) {
      if (turn_at(i) != 0) continue;
      ring_.remove(i);
      return true;
    }
    return false;
  }

  // empty: only an ear with no other vertex in it, which is always there when no edges cross.
  bool cut_ear(bool empty) {
    for (std::size_t i = 0; i < ring_.count(); ++i) {
      const Piece ear{ring_.place(i + ring_.count() - 1), ring_.place(i), ring_.place(i + 1)};
      if (turn_at(i) <= 0 || (empty && !is_empty(ear)) || !is_apart(ear)) continue;
      pieces_.add(ear);
      ring_.remove(i);
      return true;
    }
    return false;
  }

  std::size_t most_reflex() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < ring_.count(); ++i) {
      if (turn_at(i) < turn_at(best)) best = i;
    }
    return best;
  }

  std::int64_t turn_at(std::size_t i) const {
    return turn(ring_.at(i + ring_.count() - 1), ring_.at(i), ring_.at(i + 1));
  }
  const Point& point(const Piece& piece, std::size_t i) const { return points_[piece[i % 3]]; }

  // No vertex that is left lies in the ear or on its border, but for its own corners.
  bool is_empty(const Piece& ear) const {
    for (std::size_t i = 0; i < ring_.count(); ++i) {
      const Point& p = ring_.at(i);
      if (p == point(ear, 0) || p == point(ear, 1) || p == point(ear, 2)) continue;
      bool in = true;
      for (std::size_t e = 0; e < 3; ++e) in = in && turn(point(ear, e), point(ear, e + 1), p) >= 0;
      if (in) return false;
    }
    return true;
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
