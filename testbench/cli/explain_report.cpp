// SPDX-License-Identifier: Apache-2.0
#include "explain_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "io/config_json.hpp"
#include "samples.hpp"

namespace halfspace {
namespace {

const char* kind_name(EdgeKind kind) {
  return kind == EdgeKind::kTop ? "top" : kind == EdgeKind::kLeft ? "left" : "other";
}

const char* description(Fate fate) {
  switch (fate) {
    case Fate::kClipped: return "clipped: the geometry stage left nothing";
    case Fate::kZeroArea: return "zero area after snapping";
    case Fate::kCulled: return "culled by the way it faces";
    case Fate::kNoSample: return "no sample: its box is empty";
    case Fate::kOutsideBox: return "outside its box";
    case Fate::kOutsideEdge: return "outside an edge";
    case Fate::kTieLost: return "tie lost: on an edge that is neither top nor left";
    case Fate::kBehind: return "behind: covers it, lost the depth test";
    case Fate::kCovers: return "covers, and is what shows";
  }
  return "";
}

bool has_edges(const PieceAccount& piece) { return piece.doubled_area != 0; }

std::array<double, 2> sample_px(const ExplainedFrame& about) {
  const auto s = static_cast<std::size_t>(about.at.sample);
  const SamplePosition p = sample_positions(about.config.samples)[s];
  return {about.at.x + p.x / 16.0, about.at.y + p.y / 16.0};
}

int edge_fraction_bits(const Config& config) {
  return config.subpixel_bits + config.position_bits();
}

std::vector<int> edge_list(unsigned mask) {
  std::vector<int> edges;
  for (int i = 0; i < 3; ++i) {
    if ((mask >> i & 1) != 0) edges.push_back(i);
  }
  return edges;
}

std::string edge_names(unsigned mask) {
  std::string text;
  for (const int i : edge_list(mask))
    text += (text.empty() ? "edge " : " and edge ") + fmt::format("{}", i);
  return text;
}

// What decided, in a few words.
std::string why(const PieceAccount& piece) {
  switch (piece.fate) {
    case Fate::kOutsideBox:
      return fmt::format("box is pixels ({}, {}) to ({}, {})", piece.box.x_first, piece.box.y_first,
                         piece.box.x_last, piece.box.y_last);
    case Fate::kOutsideEdge: return "outside " + edge_names(piece.failed);
    case Fate::kTieLost: return "tie lost on " + edge_names(piece.failed);
    case Fate::kBehind:
    case Fate::kCovers: break;
    default: return description(piece.fate);
  }
  std::string text = fmt::format("depth {}", piece.depth);
  if (piece.ties_won != 0) text += ", tie won on " + edge_names(piece.ties_won);
  if (piece.fate == Fate::kCovers) return text;
  if (piece.behind < 0) return text + ", not nearer than the cleared depth";
  return text +
         fmt::format(", {} triangle {}", piece.passed ? "replaced by" : "behind", piece.behind);
}

void append_piece(std::string& out, const PieceAccount& piece, const Config& config) {
  const auto px = [&](std::int32_t value) { return std::ldexp(value, -config.subpixel_bits); };
  auto to = std::back_inserter(out);
  fmt::format_to(to, "    {}\n", why(piece));
  fmt::format_to(to, "    vertices px");
  for (const Point& p : piece.triangle.vertex) fmt::format_to(to, "  ({}, {})", px(p.x), px(p.y));
  fmt::format_to(to, "\n");
  if (!has_edges(piece)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeAccount& e = piece.edge[i];
    fmt::format_to(to, "    edge {}  {:5}  a {:>7}  b {:>7}  E {:>14}  biased {:>14}{}\n", i,
                   kind_name(e.kind), e.a, e.b, e.raw, e.biased,
                   e.raw == 0      ? e.biased == 0 ? "  tie won" : "  tie lost"
                   : e.biased >= 0 ? ""
                                   : "  outside");
  }
}

void append_account(std::string& out, const TriangleAccount& account, const Config& config) {
  fmt::format_to(std::back_inserter(out), "\ntriangle {}: {}\n", account.index,
                 description(account.fate));
  for (const PieceAccount& piece : account.pieces) append_piece(out, piece, config);
}

nlohmann::ordered_json piece_json(const PieceAccount& piece) {
  nlohmann::ordered_json json;
  json["reason"] = fate_name(piece.fate);
  json["why"] = why(piece);
  for (const Point& p : piece.triangle.vertex) json["vertices"].push_back({p.x, p.y});
  json["doubled_area"] = piece.doubled_area;
  if (!has_edges(piece)) return json;
  json["flipped"] = piece.doubled_area < 0;
  if (piece.fate >= Fate::kOutsideBox) {
    json["box"] = {piece.box.x_first, piece.box.y_first, piece.box.x_last, piece.box.y_last};
  }
  for (const EdgeAccount& e : piece.edge) {
    json["edges"].push_back({{"a", e.a},
                             {"b", e.b},
                             {"raw", e.raw},
                             {"biased", e.biased},
                             {"kind", kind_name(e.kind)}});
  }
  if (piece.failed != 0) json["decided_by_edges"] = edge_list(piece.failed);
  if (piece.ties_won != 0) json["ties_won_on_edges"] = edge_list(piece.ties_won);
  if (piece.fate < Fate::kBehind) return json;
  json["depth"] = piece.depth;
  json["passed_when_drawn"] = piece.passed;
  if (piece.fate == Fate::kBehind && piece.behind >= 0) json["behind"] = piece.behind;
  return json;
}

}  // namespace

std::string explain_text(const Explainer& explainer, const ExplainedFrame& about) {
  std::string out;
  auto to = std::back_inserter(out);
  const auto [x, y] = sample_px(about);
  const int bits = edge_fraction_bits(about.config);
  fmt::format_to(to, "pixel ({}, {}), sample {} of {}, at ({}, {}) px in {}, {}x{}\n", about.at.x,
                 about.at.y, about.at.sample, about.config.samples, x, y, about.scene,
                 about.frame.width, about.frame.height);
  const Rgb color = explainer.color();
  if (explainer.winner() >= 0) {
    fmt::format_to(to, "triangle {} shows, depth {}; ", explainer.winner(), explainer.depth());
  } else {
    fmt::format_to(to, "no triangle: the background shows; ");
  }
  fmt::format_to(to, "the pixel's colour is {} {} {}\n", color[0], color[1], color[2]);
  std::uint64_t total = 0;
  for (const std::uint64_t count : explainer.counts()) total += count;
  fmt::format_to(to, "\n{:>10} triangles submitted\n", total);
  for (std::size_t i = 0; i < kFates; ++i) {
    fmt::format_to(to, "{:>10} {}\n", explainer.counts()[i], description(static_cast<Fate>(i)));
  }
  if (explainer.accounts().empty()) return out;
  fmt::format_to(to, "\nE is in units of 2^-{} px^2, inside positive; a and b in 2^-{} px\n", bits,
                 about.config.subpixel_bits);
  std::vector<const TriangleAccount*> order;
  for (const TriangleAccount& account : explainer.accounts()) order.push_back(&account);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->fate > b->fate; });
  for (const TriangleAccount* account : order) append_account(out, *account, about.config);
  return out;
}

nlohmann::ordered_json explain_json(const Explainer& explainer, const ExplainedFrame& about) {
  nlohmann::ordered_json json;
  json["scene"] = about.scene;
  json["width"] = about.frame.width;
  json["height"] = about.frame.height;
  json["x"] = about.at.x;
  json["y"] = about.at.y;
  json["sample"] = about.at.sample;
  json["sample_px"] = sample_px(about);
  json["edge_fraction_bits"] = edge_fraction_bits(about.config);
  json["winner"] = nullptr;
  if (explainer.winner() >= 0) json["winner"] = explainer.winner();
  json["depth"] = explainer.depth();
  json["pixel_color"] = explainer.color();
  std::uint64_t total = 0;
  nlohmann::ordered_json counts;
  for (std::size_t i = 0; i < kFates; ++i) {
    counts[fate_name(static_cast<Fate>(i))] = explainer.counts()[i];
    total += explainer.counts()[i];
  }
  json["triangles"] = total;
  json["counts"] = counts;
  json["accounts"] = nlohmann::ordered_json::array();
  for (const TriangleAccount& account : explainer.accounts()) {
    nlohmann::ordered_json one;
    one["triangle"] = account.index;
    one["reason"] = fate_name(account.fate);
    one["pieces"] = nlohmann::ordered_json::array();
    for (const PieceAccount& piece : account.pieces) one["pieces"].push_back(piece_json(piece));
    json["accounts"].push_back(std::move(one));
  }
  json["config"] = config_json(about.config);
  return json;
}

}  // namespace halfspace
