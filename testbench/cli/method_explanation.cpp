// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "lab/method_accounts.hpp"
#include "lab_door.hpp"
#include "method_picture.hpp"
#include "pictures.hpp"

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;
using lab::MethodAccount;
using lab::MethodFate;
using lab::MethodPixel;
using lab::PieceDecision;

const char* description(MethodFate fate) {
  switch (fate) {
    case MethodFate::kClipped: return "clipped: nothing left before the method";
    case MethodFate::kOutside: return "outside: no hit, and rightly";
    case MethodFate::kTieLost: return "tie lost: no hit on its edge, and rightly";
    case MethodFate::kFalseHit: return "false hit: drawn without owning the pixel";
    case MethodFate::kDouble: return "double: drawn where its owner is drawn as well";
    case MethodFate::kMissed: return "missed: owns the pixel, and one beside it is drawn instead";
    case MethodFate::kGap: return "gap: owns the pixel, and none beside it is drawn instead";
    case MethodFate::kBehind: return "behind: rightly drawn, another's depth shows";
    case MethodFate::kCovers: return "covers: rightly drawn";
  }
  return "";
}

const char* verdict_name(lab::Verdict verdict) {
  constexpr std::array<const char*, 5> names{"no_area", "outside", "tie_lost", "tie_won", "inside"};
  return names[static_cast<std::size_t>(verdict)];
}

const char* kind_name(lab::RuleEdge kind) {
  constexpr std::array<const char*, 3> names{"top", "left", "other"};
  return names[static_cast<std::size_t>(kind)];
}

Json edge_json(const lab::ExactEdge& exact, const methods::OwnEdge* own) {
  Json json{{"exact", exact.value}, {"kind", kind_name(exact.kind)}};
  if (own == nullptr) return json;
  json["raw"] = own->raw;
  if (own->biased) json["biased"] = *own->biased;
  json["passes"] = own->passes;
  return json;
}

Json piece_json(const PieceDecision& piece) {
  Json json;
  for (const oracle::Vec& v : piece.vertex) json["vertices"].push_back({v.x, v.y});
  json["exact"] = verdict_name(piece.verdict);
  json["owns_unsnapped"] = piece.owns_unsnapped;
  if (piece.hits) json["hits"] = *piece.hits;
  if (piece.verdict == lab::Verdict::kNoArea) return json;
  for (std::size_t i = 0; i < 3; ++i) {
    json["edges"].push_back(edge_json(piece.edge[i], piece.own ? &(*piece.own)[i] : nullptr));
  }
  return json;
}

Json account_json(const MethodAccount& account) {
  Json json{{"triangle", account.triangle},
            {"reason", fate_name(account.fate)},
            {"mistake", is_mistake(account.fate)},
            {"hits", account.hits},
            {"owns", account.owns},
            {"shows", account.shows}};
  json["pieces"] = Json::array();
  for (const PieceDecision& piece : account.pieces) json["pieces"].push_back(piece_json(piece));
  for (const lab::SegmentDecision& s : account.segments) {
    json["segments"].push_back({{"from", {s.segment.from.x, s.segment.from.y}},
                                {"to", {s.segment.to.x, s.segment.to.y}},
                                {"hits", s.hits},
                                {"owns", s.owns}});
  }
  return json;
}

// As render writes it: the winner's colour, or what stands for the number of hits.
Rgb shown_color(const methods::Method& method, const MethodPixel& pixel) {
  if (method.attributes && pixel.winner >= 0) return picture_color(pixel.color);
  const auto hits = static_cast<std::uint8_t>(std::min(pixel.hits, 255u));
  return picture_of_counts({hits}, 1, 1).pixel[0];
}

void append_vertices(std::string& out, const Json& vertices) {
  out += "    vertices px";
  for (const Json& v : vertices) {
    out += fmt::format("  ({:.9g}, {:.9g})", v[0].get<double>(), v[1].get<double>());
  }
  out += "\n";
}

void append_piece(std::string& out, const Json& piece, bool snapped) {
  auto to = std::back_inserter(out);
  fmt::format_to(to, "    exact rule: {}", piece["exact"].get<std::string>());
  const bool owns = piece["exact"] == "inside" || piece["exact"] == "tie_won";
  if (snapped && piece["owns_unsnapped"] != owns) {
    out += owns ? "; before its vertices were snapped it did not own the pixel"
                : "; before its vertices were snapped it owned the pixel";
  }
  out += "\n";
  append_vertices(out, piece["vertices"]);
  for (std::size_t i = 0; piece.contains("edges") && i < 3; ++i) {
    const Json& e = piece["edges"][i];
    fmt::format_to(to, "    edge {}  {:5}  exact {:>16.9g}", i, e["kind"].get<std::string>(),
                   e["exact"].get<double>());
    if (e.contains("raw")) fmt::format_to(to, "  method {:>16.9g}", e["raw"].get<double>());
    if (e.contains("biased")) fmt::format_to(to, "  biased {:>16.9g}", e["biased"].get<double>());
    if (e.contains("passes")) out += e["passes"].get<bool>() ? "  passes" : "  fails";
    if (e["exact"] == 0.0) out += "  tie";
    out += "\n";
  }
}

void append_account(std::string& out, const Json& account, bool snapped) {
  auto to = std::back_inserter(out);
  const auto reason = account["reason"].get<std::string>();
  for (int i = 0; i < lab::kMethodFates; ++i) {
    const auto fate = static_cast<MethodFate>(i);
    if (reason != lab::fate_name(fate)) continue;
    fmt::format_to(to, "\ntriangle {}: {}\n", account["triangle"].get<std::uint64_t>(),
                   description(fate));
  }
  fmt::format_to(to, "    hits {}, by the exact rule {}{}\n", account["hits"].get<int>(),
                 account["owns"].get<int>(), account["shows"].get<bool>() ? "; it shows" : "");
  if (!account.contains("segments")) {
    for (const Json& piece : account["pieces"]) append_piece(out, piece, snapped);
    return;
  }
  for (const Json& s : account["segments"]) {
    fmt::format_to(to, "    segment ({}, {}) to ({}, {})  hits {}, by the exact rule {}\n",
                   s["from"][0].get<double>(), s["from"][1].get<double>(), s["to"][0].get<double>(),
                   s["to"][1].get<double>(), s["hits"].get<int>(), s["owns"].get<int>());
  }
}

void append_heading(std::string& out, const Json& data) {
  auto to = std::back_inserter(out);
  fmt::format_to(to, "pixel ({}, {}), centre ({}, {}) px in {}, {}x{}, by {}\n",
                 data["x"].get<int>(), data["y"].get<int>(), data["x"].get<int>() + 0.5,
                 data["y"].get<int>() + 0.5, data["scene"].get<std::string>(),
                 data["width"].get<int>(), data["height"].get<int>(),
                 data["method"].get<std::string>());
  fmt::format_to(to, "{}; ties: {}\n", data["title"].get<std::string>(),
                 data["ties"].get<std::string>());
  const bool snapped = !data["truth_subpixel_bits"].is_null();
  fmt::format_to(
      to, "{} hits, by the exact rule {} ({}); ", data["hits"].get<int>(), data["owns"].get<int>(),
      snapped ? fmt::format("vertices snapped to 2^-{} px", data["truth_subpixel_bits"].get<int>())
              : std::string("vertices as they are"));
  if (!data["winner"].is_null()) {
    fmt::format_to(to, "triangle {} shows, depth {:.9g}; ", data["winner"].get<std::uint64_t>(),
                   data["depth"].get<double>());
  }
  const Json& color = data["pixel_color"];
  fmt::format_to(to, "the pixel's colour is {} {} {}\n", color[0].get<int>(), color[1].get<int>(),
                 color[2].get<int>());
  fmt::format_to(to, "\n{:>10} triangles submitted\n", data["triangles"].get<std::uint64_t>());
  for (int i = 0; i < lab::kMethodFates; ++i) {
    const auto fate = static_cast<MethodFate>(i);
    fmt::format_to(to, "{:>10} {}\n", data["counts"][lab::fate_name(fate)].get<std::uint64_t>(),
                   description(fate));
  }
}

}  // namespace

Json method_explanation(const std::string& scene_name, const Scene& scene,
                        const methods::Method& method, const FrameState& frame, int x, int y,
                        bool all) {
  const methods::Drawing drawing = scene_drawing(scene, 0, frame);
  methods::Canvas canvas = method_canvas(frame);
  if (method.attributes) canvas.keep_attributes();
  const MethodPixel pixel =
      lab::method_pixel(method, drawing, scene.triangles(0), canvas, x, y, all);
  require_finished(method, canvas);
  Json json{
      {"scene", scene_name},  {"width", frame.width}, {"height", frame.height}, {"x", x}, {"y", y},
      {"method", method.name}};
  json["title"] = method.title;
  json["input"] = methods::input_name(method.input());
  json["ties"] = methods::rule_name(method.rule);
  json["truth_subpixel_bits"] = nullptr;
  if (pixel.truth_bits >= 0) json["truth_subpixel_bits"] = pixel.truth_bits;
  json["hits"] = pixel.hits;
  json["owns"] = pixel.owns;
  json["winner"] = nullptr;
  if (pixel.winner >= 0) {
    json["winner"] = pixel.winner;
    json["depth"] = pixel.depth;
  }
  json["pixel_color"] = shown_color(method, pixel);
  json["triangles"] = pixel.triangles;
  for (int i = 0; i < lab::kMethodFates; ++i) {
    json["counts"][lab::fate_name(static_cast<MethodFate>(i))] =
        pixel.counts[static_cast<std::size_t>(i)];
  }
  json["accounts"] = Json::array();
  for (const MethodAccount& account : pixel.accounts) {
    json["accounts"].push_back(account_json(account));
  }
  return json;
}

std::string method_explanation_text(const Json& data) {
  std::string out;
  append_heading(out, data);
  if (data["accounts"].empty()) return out;
  const bool lines = data["input"] == "lines";
  if (!lines) out += "\nedge values are in px^2, inside positive\n";
  // Mistakes first, then what shows, then as submitted.
  std::vector<const Json*> order;
  for (const Json& account : data["accounts"]) order.push_back(&account);
  const auto rank = [](const Json& account) {
    return account["mistake"].get<bool>() ? 0
           : account["shows"].get<bool>() ? 1
           : account["hits"] != 0         ? 2
                                          : 3;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](const Json* a, const Json* b) { return rank(*a) < rank(*b); });
  const bool snapped = !data["truth_subpixel_bits"].is_null();
  for (const Json* account : order) append_account(out, *account, snapped);
  return out;
}

}  // namespace halfspace
